//! The parameters that the forms of both pipe workbooks share.

use crate::figure::PAPERS;
use crate::kinds::pipe::size::{NPS, SCHEDULES};
use crate::parameter::{DIALECTS, FieldKind, Parameter, other, real, t, whole};
use crate::table::Unit;

const MM: Unit = Unit::Millimetre;
const DIAMETER: [f64; 2] = [5.0, 3000.0];
const WALL: [f64; 2] = [0.3, 200.0];

/// The sizes of both pipes.
pub(super) const PIPES: &[Parameter] = &[
    other(
        "branch_size",
        "branch_size",
        FieldKind::Choice(NPS),
        false,
        t("Tamaño nominal del injerto (NPS)", "Nominal size of the branch (NPS)"),
        t("ASME B36.10; con la cédula, en lugar de D y t", "ASME B36.10; with the schedule, in place of D and t"),
    ),
    other(
        "branch_schedule",
        "branch_schedule",
        FieldKind::Choice(SCHEDULES),
        false,
        t("Cédula del injerto", "Schedule of the branch"),
        t("ASME B36.10", "ASME B36.10"),
    ),
    real(
        "D_branch",
        "branch_diameter_D",
        MM,
        DIAMETER,
        false,
        t("Diámetro exterior del injerto", "Outside diameter of the branch"),
        t("Vacío si se da el tamaño nominal", "Empty where the nominal size is given"),
    ),
    real(
        "t_branch",
        "branch_wall_t",
        MM,
        WALL,
        false,
        t("Espesor de pared del injerto", "Wall of the branch"),
        t("Menor que el radio", "Less than the radius"),
    ),
    other(
        "header_size",
        "header_size",
        FieldKind::Choice(NPS),
        false,
        t("Tamaño nominal del tubo base (NPS)", "Nominal size of the header (NPS)"),
        t("ASME B36.10; con la cédula, en lugar de D y t", "ASME B36.10; with the schedule, in place of D and t"),
    ),
    other(
        "header_schedule",
        "header_schedule",
        FieldKind::Choice(SCHEDULES),
        false,
        t("Cédula del tubo base", "Schedule of the header"),
        t("ASME B36.10", "ASME B36.10"),
    ),
    real(
        "D_header",
        "header_diameter_D",
        MM,
        DIAMETER,
        false,
        t("Diámetro exterior del tubo base", "Outside diameter of the header"),
        t("Vacío si se da el tamaño nominal", "Empty where the nominal size is given"),
    ),
    real(
        "t_header",
        "header_wall_t",
        MM,
        WALL,
        false,
        t("Espesor de pared del tubo base", "Wall of the header"),
        t("Menor que el radio", "Less than the radius"),
    ),
];

/// The angle between the axes.
pub(super) const THETA: Parameter = real(
    "theta",
    "angle_theta",
    Unit::Degree,
    [1.0, 179.0],
    true,
    t("Ángulo entre los ejes", "Angle between the axes"),
    t("90: perpendicular", "90: square"),
);

/// How far the axes pass each other.
pub(super) const E: Parameter = real(
    "e",
    "eccentricity_e",
    MM,
    [-1500.0, 1500.0],
    true,
    t("Excentricidad: distancia entre los ejes", "Eccentricity: distance between the axes"),
    t(
        "Visto inclinado a la derecha, e > 0 pasa por delante; no debe sobresalir",
        "Seen leaning to the right, e > 0 passes in front; it must not overhang",
    ),
);

/// The pierce delay.
pub(super) const PIERCE_DELAY: Parameter = real(
    "pierce_delay",
    "pierce_delay",
    Unit::Second,
    [0.0, 60.0],
    true,
    t("Espera al perforar", "Pierce delay"),
    t("0: sin espera", "0: none"),
);

/// The part.
pub(super) const PART: Parameter =
    other("part", "part", FieldKind::Line { max: 200 }, true, t("Pieza", "Part"), t("", ""));

/// The material.
pub(super) const MATERIAL: Parameter =
    other("material", "material", FieldKind::Line { max: 200 }, false, t("Material", "Material"), t("", ""));

/// The program number.
pub(super) const NUMBER: Parameter = whole(
    "program",
    "program_number",
    Unit::Count,
    [1, 9999],
    true,
    t("Número de programa", "Program number"),
    t("En la cabecera del programa", "In the program's header"),
);

/// The dialect.
pub(super) const DIALECT: Parameter = other(
    "dialect",
    "dialect",
    FieldKind::Choice(DIALECTS),
    true,
    t("Dialecto del control", "Dialect of the control"),
    t("", ""),
);

/// The codes that turn the torch on.
pub(super) const TORCH_ON: Parameter = other(
    "torch_on",
    "torch_on",
    FieldKind::Codes,
    true,
    t("Códigos que encienden la antorcha", "Codes that turn the torch on"),
    t("Lo usual: M3", "Usual: M3"),
);

/// The codes that turn it off.
pub(super) const TORCH_OFF: Parameter = other(
    "torch_off",
    "torch_off",
    FieldKind::Codes,
    true,
    t("Códigos que la apagan", "Codes that turn it off"),
    t("Lo usual: M5", "Usual: M5"),
);

/// The codes at the end.
pub(super) const END_CODES: Parameter = other(
    "end_codes",
    "end_codes",
    FieldKind::Codes,
    true,
    t("Códigos al terminar", "Codes at the end"),
    t("Lo usual: M30", "Usual: M30"),
);

/// The step of the block numbers.
pub(super) const BLOCK_STEP: Parameter = whole(
    "block_step",
    "block_step",
    Unit::Count,
    [1, 1000],
    true,
    t("Paso de la numeración de bloques", "Step of the block numbers"),
    t("Lo usual: 10", "Usual: 10"),
);

/// The paper that templates are printed on.
pub(super) const PAPER: Parameter = other(
    "paper",
    "paper",
    FieldKind::Choice(PAPERS),
    false,
    t("Papel de la plantilla a tamaño natural", "Paper of the template at full size"),
    t("Vacío: A4", "Empty: A4"),
);
