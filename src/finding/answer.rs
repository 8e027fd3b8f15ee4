//! What the operating system answered, in words of both languages.

use std::io::{self, ErrorKind};

use crate::escape::printable;
use crate::text::Text;

/// Why the operating system refused: in English as it says it, in Spanish in words of our own, or for an answer that is rare
/// as a quotation. Safe for a terminal.
#[must_use]
pub fn answer(error: &io::Error) -> Text {
    let said = printable(&error.to_string());
    let own = match error.kind() {
        ErrorKind::NotFound => "no existe",
        ErrorKind::PermissionDenied => "permiso denegado",
        ErrorKind::AlreadyExists => "ya existe",
        ErrorKind::NotADirectory => "una parte de la ruta no es una carpeta",
        ErrorKind::IsADirectory => "es una carpeta",
        ErrorKind::DirectoryNotEmpty => "la carpeta no está vacía",
        ErrorKind::ReadOnlyFilesystem => "el sistema de archivos es de solo lectura",
        ErrorKind::StorageFull => "no queda espacio en el disco",
        ErrorKind::QuotaExceeded => "ha agotado su espacio en el disco",
        ErrorKind::FileTooLarge => "el archivo supera el tamaño permitido",
        ErrorKind::InvalidFilename => "el nombre no es válido o es demasiado largo",
        ErrorKind::ResourceBusy | ErrorKind::ExecutableFileBusy => "está en uso",
        ErrorKind::CrossesDevices => "está en otro disco",
        ErrorKind::TooManyLinks => "tiene demasiados enlaces",
        ErrorKind::StaleNetworkFileHandle => "la carpeta de red ya no está",
        ErrorKind::BrokenPipe => "quien lee ha cerrado",
        ErrorKind::TimedOut => "no responde a tiempo",
        ErrorKind::Interrupted => "se interrumpió",
        ErrorKind::UnexpectedEof => "el archivo acaba antes de tiempo",
        ErrorKind::OutOfMemory => "no queda memoria",
        _ => match error.raw_os_error() {
            // EIO, EMFILE and ELOOP, which have no kind of their own.
            Some(5) if cfg!(unix) => "el disco falla al leer o escribir",
            Some(24) if cfg!(unix) => "hay demasiados archivos abiertos",
            Some(40) if cfg!(target_os = "linux") => "el enlace vuelve sobre sí mismo",
            _ => return quoted(said),
        },
    };
    Text::new(own.to_owned(), said)
}

/// Words of a program that speaks English alone.
#[must_use]
pub fn quoted(said: String) -> Text {
    Text::new(format!("«{said}»"), said)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_of_the_system_has_spanish_words_and_a_rare_one_is_a_quotation() {
        let told = answer(&ErrorKind::PermissionDenied.into());
        assert_eq!((&*told.es, &*told.en), ("permiso denegado", "permission denied"));
        let told = answer(&io::Error::other("device \u{1b}[31mgone"));
        assert_eq!((&*told.es, &*told.en), ("«device \\u{1b}[31mgone»", "device \\u{1b}[31mgone"));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn answers_that_have_no_kind_of_their_own_are_known_by_number() {
        for (number, words) in [(5, "falla"), (24, "abiertos"), (40, "enlace")] {
            let told = answer(&io::Error::from_raw_os_error(number));
            assert!(told.es.contains(words), "{}", told.es);
        }
    }
}
