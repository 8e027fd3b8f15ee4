//! Why a file could not be written, in words.

use std::io::{self, ErrorKind};
use std::path::Path;

use crate::escape::{printable, printable_path};
use crate::finding::{Exit, Finding, Place, Refusal};
use crate::text::Text;

/// A refusal of exit 5 for a path, with the reason that the system gives.
pub(super) fn unwritable(path: &Path, error: &io::Error) -> Refusal {
    let shown = shown(path);
    let (reason, remedy) = words(error);
    refusal(
        Text::new(
            format!("no se puede escribir en {shown}: {}", reason.es),
            format!("cannot write to {shown}: {}", reason.en),
        ),
        remedy,
    )
}

/// A refusal of exit 5 in given words.
pub(super) fn refusal(what: Text, remedy: Text) -> Refusal {
    Refusal::new(Exit::Unwritable, Finding::stop(Place::File, what, remedy))
}

/// A path as it may be shown.
pub(super) fn shown(path: &Path) -> String {
    printable_path(path)
}

/// The reason and the remedy for an error of the system.
pub(super) fn words(error: &io::Error) -> (Text, Text) {
    let another = Text::fixed("elija otra carpeta (opción -o)", "choose another folder (option -o)");
    match error.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => (
            Text::fixed("no queda espacio en el disco", "no space left on the disk"),
            Text::fixed(
                "libere espacio o elija otra carpeta (opción -o); los archivos anteriores siguen intactos",
                "free some space or choose another folder (option -o); the files that were there are untouched",
            ),
        ),
        ErrorKind::FileTooLarge => (
            Text::fixed("el archivo supera el tamaño permitido", "the file is larger than is allowed here"),
            Text::fixed(
                "elija otra carpeta (opción -o) o pida un límite mayor (ulimit -f)",
                "choose another folder (option -o) or ask for a greater limit (ulimit -f)",
            ),
        ),
        ErrorKind::PermissionDenied => (Text::fixed("permiso denegado", "permission denied"), another),
        ErrorKind::ReadOnlyFilesystem => {
            (Text::fixed("el sistema de archivos es de solo lectura", "the file system is read-only"), another)
        }
        ErrorKind::NotFound => (Text::fixed("no existe", "it does not exist"), another),
        ErrorKind::NotADirectory => {
            (Text::fixed("una parte de la ruta no es una carpeta", "a part of the path is not a folder"), another)
        }
        ErrorKind::IsADirectory => (
            Text::fixed("hay una carpeta con ese nombre", "there is a folder of that name"),
            Text::fixed(
                "renombre esa carpeta o elija otra (opción -o)",
                "rename that folder or choose another (option -o)",
            ),
        ),
        ErrorKind::InvalidFilename => (
            Text::fixed("el nombre no es válido o es demasiado largo", "the name is not valid or is too long"),
            Text::fixed("acorte el nombre del libro", "give the workbook a shorter name"),
        ),
        ErrorKind::ResourceBusy => (
            Text::fixed("está en uso", "it is in use"),
            Text::fixed("ciérrelo en los demás programas", "close it in the other programs"),
        ),
        _ => (Text::same(printable(&error.to_string())), another),
    }
}
