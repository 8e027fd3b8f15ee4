//! The sheet of variants: settings above, and a list of the inputs that are varied below.

use crate::kind::measure::Level;
use crate::limits::{SWEEP_DESIGNS, SWEEP_INPUTS};
use crate::parameter::field::{Field, Optional, Required, Usual};
use crate::parameter::list::{List, Naming};
use crate::parameter::{Form, Parameter, Section, Sheet};
use crate::sweep::plan::Method;
use crate::table::Unit;
use crate::text::{Text, t};

const REACH: [f64; 2] = [-1e9, 1e9];

/// How the designs are chosen.
pub static METHOD: Field<Method, Required> = Field::choice(
    "method",
    "sweep_method",
    t("Cómo se eligen los diseños", "How the designs are chosen"),
    t(
        "«factorial»: todos los niveles con todos; «latino» y «sobol»: tantos diseños como diga samples, bien repartidos; «saltelli»: grupos para los índices de Sobol; «lista»: los de la hoja DISEÑOS",
        "factorial: every level with every other; latin and sobol: samples designs, spread evenly; saltelli: groups for Sobol's indices; list: those of the sheet DESIGNS",
    ),
);
/// How many designs are sampled.
pub static SAMPLES: Field<u32, Optional> = Field::whole(
    "samples",
    "sweep_samples",
    Unit::Count,
    [1, SWEEP_DESIGNS],
    t("Número de diseños", "Number of designs"),
    t(
        "Con «latino» y «sobol»; con «saltelli», de grupos. Con «sobol» y «saltelli», mejor una potencia de dos",
        "With latin and sobol; with saltelli, of groups; sobol and saltelli: best a power of two",
    ),
);
/// What chance begins with.
pub static SEED: Field<u32, Optional> = Field::whole(
    "seed",
    "sweep_seed",
    Unit::Count,
    [0, 1_000_000],
    t("Semilla: la misma da los mismos diseños", "Seed: the same one gives the same designs"),
    t("Vacía: 1", "Empty: 1"),
);
/// What a design is judged by.
pub static LEVEL: Field<Level, Usual> = Field::choice_or(
    Level::Program,
    "level",
    "sweep_level",
    t("Con qué se comprueba cada diseño", "What each design is checked by"),
    t(
        "«límites»: los límites derivados; «programa», o vacía: además los programas, releídos, con todas las comprobaciones",
        "limits: the derived limits; program, or empty: the programs as well, read back, with all checks",
    ),
);
/// What is to be small or large.
pub static OBJECTIVES: Field<String, Optional> = Field::line(
    "objectives",
    "sweep_objectives",
    400,
    t("Lo que debe ser mínimo o máximo", "What is to be small or large"),
    t("Como «time_s min; clearance_mm max»", "Such as time_s min; clearance_mm max"),
);
/// What must hold.
pub static CONSTRAINTS: Field<String, Optional> = Field::line(
    "constraints",
    "sweep_constraints",
    400,
    t("Lo que debe cumplirse, además de no haber paradas", "What must hold, beside there being no stops"),
    t("Como «clearance_mm >= 0.5; time_s <= 600»", "Such as clearance_mm >= 0.5; time_s <= 600"),
);

const SETTINGS: &[&Parameter] = &[&METHOD.row, &SAMPLES.row, &SEED.row, &LEVEL.row, &OBJECTIVES.row, &CONSTRAINTS.row];

/// The symbol of an input.
pub static INPUT: Field<String, Required> = Field::line(
    "inputs/input",
    "",
    60,
    t("Símbolo de una entrada", "Symbol of an input"),
    t("Como en la hoja de datos", "As on the sheet of the data"),
);
/// The least value.
pub static FROM: Field<f64, Optional> = Field::real(
    "inputs/from",
    "",
    Unit::One,
    REACH,
    t("Desde", "From"),
    t("En la unidad de la entrada", "In the input's unit"),
);
/// The greatest value.
pub static TO: Field<f64, Optional> =
    Field::real("inputs/to", "", Unit::One, REACH, t("Hasta, incluido", "To, included"), t("", ""));
/// From one value to the next.
pub static STEP: Field<f64, Optional> = Field::real(
    "inputs/step",
    "",
    Unit::One,
    REACH,
    t("Paso", "Step"),
    t("Vacía: el intervalo se muestrea", "Empty: the range is sampled"),
);
/// Values, parted by semicolons.
pub static VALUES: Field<String, Optional> = Field::line(
    "inputs/values",
    "",
    1000,
    t("O valores, separados por punto y coma", "Or values, parted by semicolons"),
    t("Como «4; 5» o «sí; no»", "Such as 4; 5 or yes; no"),
);
/// How a range is sampled.
pub static DISTRIBUTION: Field<String, Optional> = Field::line(
    "inputs/distribution",
    "",
    60,
    t("Distribución", "Distribution"),
    t(
        "«uniforme», o vacía; o «normal» con media y desviación típica, como «normal 2 0.05»: decimales con punto. Se corta en desde y hasta",
        "uniform, or empty; normal with mean and standard deviation, such as normal 2 0.05: decimals with a point. Cut at from and to",
    ),
);
/// What a person wants to remember.
pub static NOTE: Field<String, Optional> =
    Field::line("inputs/note", "", 200, t("Nota", "Note"), t("No se lee", "Not read"));

/// The sheet's name.
pub const NAME: Text = t("BARRIDO", "SWEEP");

/// The name of the sheet that holds the designs of a list: a row of symbols, then one design a row.
pub const DESIGNS: Text = t("DISEÑOS", "DESIGNS");

/// The list of the inputs.
const LIST: List = List {
    key: "inputs",
    is_program: false,
    naming: Naming::One(NAME),
    title: t("Entradas que varían", "Inputs that vary"),
    note: t(
        "Una fila por entrada: desde y hasta, con o sin paso, o una lista de valores. Las demás entradas quedan como en la hoja de datos.",
        "One row for each input: from and to, with or without a step, or a list of values. All other inputs stay as on the sheet of the data.",
    ),
    optional: true,
    columns: &[&INPUT.row, &FROM.row, &TO.row, &STEP.row, &VALUES.row, &DISTRIBUTION.row, &NOTE.row],
    widths: &[15.5, 37.0, 19.0, 8.0, 42.0, 24.0, 30.0],
    most: SWEEP_INPUTS as usize,
};

/// The sheet as a form, so that it is read as any other.
pub static FORM: Form = Form {
    kind: "sweep",
    schema: "rodete-sweep 1",
    sheets: &[Sheet {
        name: NAME,
        title: t("Variantes del diseño", "Variants of the design"),
        optional: false,
        sections: &[Section { title: t("Plan", "Plan"), parameters: SETTINGS, optional: false }],
    }],
    lists: &[LIST],
    ..Form::PLAIN
};
