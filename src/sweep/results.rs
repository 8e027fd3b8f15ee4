//! What came of a sweep, as its workbook and its report show it.

use crate::finding::{Finding, Grade};
use crate::kind::Kind;
use crate::kind::measure::{Level, Measure};
use crate::parameter::field::Chosen;
use crate::sweep::form::LEVEL;
use crate::sweep::indices::LEAST;
use crate::sweep::plan::{INPUT, Plan};
use crate::sweep::ranking::Counts;
use crate::sweep::row::State;
use crate::sweep::sensitivity::{Effect, NoRoom, SAMPLES, SHARES_LEAST, Slope};
use crate::sweep::table::{
    CAUTION, CODES, FEASIBLE, FRONT, ID, LIMIT, MARGIN, MESSAGE, REASON, STATE, STOP, Table, VALUE, plain,
};
use crate::text::{Language, Text, t};

/// The colours of designs in the charts of the workbook and of the report: those of the front, others of the best, other feasible ones,
/// and those that break a constraint.
pub const COLOURS: [&str; 4] = ["#3f7f3f", "#c0504d", "#4a86c5", "#b4b4b4"];

/// A code, what it says, and how many designs have it.
#[derive(Clone, Debug)]
pub struct Coded {
    /// The code of a finding; an objective or a constraint, as their cells say it.
    pub code: String,
    /// What it says, of the first design that has it.
    pub what: Text,
    /// How many designs.
    pub count: u64,
}

/// What came of one of the best designs when it was built whole, as a workbook with its programs.
#[derive(Clone, Debug)]
pub struct Built {
    /// Its file, as it is found from the folder of the sweep's workbook: its results, or the bare workbook of a design that was
    /// rejected.
    pub file: String,
    /// rodete rejected it: there are no results and no programs.
    pub rejected: bool,
    /// What the build found.
    pub findings: Vec<Finding>,
}

impl Built {
    /// What it was rejected for; `None` where it was built.
    #[must_use]
    pub fn stop(&self) -> Option<&Finding> {
        let stop = self.findings.iter().find(|one| one.grade == Grade::Stop);
        stop.or(self.findings.first()).filter(|_| self.rejected)
    }
}

/// The heading of a column of the rows on a sheet; inputs and measures are called as their cells say them.
#[must_use]
pub fn heading(name: &str) -> Text {
    match name {
        STATE => t("estado", "state"),
        FEASIBLE => t("válido", "feasible"),
        STOP => t("paradas", "stop"),
        CAUTION => t("precauciones", "caution"),
        CODES => t("códigos", "codes"),
        REASON => t("motivo", "reason"),
        VALUE => t("valor", "value"),
        LIMIT => t("límite", "limit"),
        MARGIN => t("margen", "margin"),
        MESSAGE => t("mensaje", "message"),
        FRONT => t("frente", "front"),
        name => Text::same(name.to_owned()),
    }
}

/// How a design ended, as a sheet says it.
#[must_use]
pub fn state(word: &str) -> Text {
    let says = [
        (State::Done, t("hecho", "done")),
        (State::Refused, t("rechazado", "refused")),
        (State::Failed, t("fallido", "failed")),
    ];
    let said = says.into_iter().find(|(state, _)| state.word() == word);
    said.map_or_else(|| Text::same(word.to_owned()), |(_, text)| text)
}

/// What came of a sweep.
#[derive(Clone, Copy, Debug)]
pub struct Results<'a> {
    /// The kind.
    pub kind: &'a dyn Kind,
    /// The plan.
    pub plan: &'a Plan,
    /// The name of the workbook that was swept.
    pub source: &'a str,
    /// The rows of the best designs, in their order.
    pub top: &'a Table,
    /// The rows of all designs, or the best of them.
    pub all: &'a Table,
    /// How many designs of each state there are.
    pub counts: Counts,
    /// Designs on the front.
    pub front: usize,
    /// What came of each of the best when it was built whole; `None` of those that were not.
    pub built: &'a [Option<Built>],
    /// What those of them that were rejected were rejected for, most first.
    pub rejected: &'a [Coded],
    /// The front was longer, and is cut.
    pub cut: bool,
    /// Why the others are not good, most first.
    pub why: &'a [Coded],
    /// The cautions of the best designs, most first: of those that were built whole, what the build found.
    pub cautions: &'a [Coded],
    /// What each input does.
    pub effects: &'a [Effect],
    /// From how many triples the indices of Sobol come, of how many; `None` for a plan that is not made for them.
    pub triples: Option<(u64, u64)>,
}

impl Results<'_> {
    /// What a chart calls a column of the rows: a measure by its name in words, an input by its symbol; without its unit.
    #[must_use]
    pub fn name(&self, column: &str) -> Text {
        let measure = self.kind.measures().iter().find(|one| one.key == column);
        measure.map_or_else(|| Text::same(plain(column)), Measure::name)
    }

    /// How many designs there are, and how many of each state.
    #[must_use]
    pub fn counted(&self) -> Text {
        let Counts { done, refused, failed, feasible } = self.counts;
        let (all, front) = (self.plan.count, self.front);
        let [es, en] = if all == 1 { ["diseño", "design"] } else { ["diseños", "designs"] };
        Text::new(
            format!(
                "{all} {es}: {done} hechos, {refused} rechazados, {failed} fallidos; {feasible} válidos, {front} en el frente"
            ),
            format!(
                "{all} {en}: {done} done, {refused} refused, {failed} failed; {feasible} feasible, {front} on the front"
            ),
        )
    }

    /// How many of the best were built whole, and how many of those were rejected.
    #[must_use]
    pub fn tried(&self) -> (usize, usize) {
        let tried = || self.built.iter().flatten();
        (tried().count(), tried().filter(|one| one.rejected).count())
    }

    /// How many of the best were rejected when they were built whole; `None` where none was.
    #[must_use]
    pub fn refuted(&self) -> Option<Text> {
        let (built, rejected) = self.tried();
        (rejected > 0).then(|| {
            Text::new(
                format!("rodete rechaza {rejected} de los {built} que ha generado enteros."),
                format!("rodete rejects {rejected} of the {built} that it built whole."),
            )
        })
    }

    /// What the designs were judged by, as the end of a sentence.
    #[must_use]
    pub fn judged_by(&self) -> Text {
        match self.plan.level {
            Level::Limits => t(
                "por los límites derivados: ningún programa se ha releído",
                "by the derived limits: no program was read back",
            ),
            Level::Program => t(
                "por los programas, releídos, con todas las comprobaciones",
                "by the programs, read back, with all checks",
            ),
        }
    }

    /// The same in full, and where a whole build knows more.
    #[must_use]
    pub fn judged(&self) -> Text {
        let by = self.judged_by();
        let level = |language| LEVEL.row.label(self.plan.level.key(), language);
        let [es, en] = match self.plan.level {
            Level::Limits => [
                ", y un diseño que aquí vale puede rechazarse al generarlo entero",
                ", and a design that is good here may be rejected when it is built whole",
            ],
            Level::Program => ["", ""],
        };
        Text::new(
            format!("Juzgado con level = {}, {}{es}.", level(Language::Es), by.es),
            format!("Judged with level = {}, {}{en}.", level(Language::En), by.en),
        )
    }

    /// What the best designs are, and which of them are built.
    #[must_use]
    pub fn listed(&self) -> Text {
        let unbuilt = self.built.iter().take(self.front).filter(|one| one.is_none()).count();
        let (es, en) = if unbuilt > 0 {
            (
                format!(" Del frente, sin generar: {unbuilt}; --top genera más."),
                format!(" Of the front, not built: {unbuilt}; --top builds more."),
            )
        } else {
            (String::new(), String::new())
        };
        let refuted = self.refuted().map_or(t("", ""), |Text { es, en }| Text::new(format!(" {es}"), format!(" {en}")));
        if self.plan.objectives.is_empty() {
            return Text::new(
                format!(
                    "Los primeros diseños válidos del plan: sin objectives ninguno es mejor que otro.{}",
                    refuted.es
                ),
                format!(
                    "The first feasible designs of the plan: without objectives none is better than another.{}",
                    refuted.en
                ),
            );
        }
        Text::new(
            format!(
                "Primero todo el frente: los diseños que ningún otro mejora en todos los objetivos.{es}{}",
                refuted.es
            ),
            format!("First the whole front: the designs that no other betters in every objective.{en}{}", refuted.en),
        )
    }

    /// The columns of the best designs that compare them: what varies, what is asked for, and what is to be known. The others are
    /// with the rows of all, and in the workbook of each.
    #[must_use]
    pub fn brief(&self) -> Table {
        let Plan { objectives, constraints, .. } = self.plan;
        let asked = |name: &str| {
            objectives
                .iter()
                .map(|one| one.measure)
                .chain(constraints.iter().map(|one| one.measure))
                .any(|one| one.key == name)
        };
        let kept = |name: &str| name.starts_with(INPUT) || asked(name) || [ID, CAUTION, CODES, FRONT].contains(&name);
        Table { columns: self.top.columns.iter().filter(|one| kept(&one.name)).cloned().collect() }
    }

    /// True where an index of Sobol is told of an input.
    #[must_use]
    pub fn indexed(&self) -> bool {
        self.effects.iter().flat_map(|one| &one.indices).any(Option::is_some)
    }

    /// True where the share of an input is told.
    #[must_use]
    pub fn shared(&self) -> bool {
        self.effects.iter().flat_map(|one| &one.shares).any(Option::is_some)
    }

    /// What the effects of the inputs are, around the design of the workbook and over the plan; first, if that design is not good, why,
    /// and by what designs were judged.
    #[must_use]
    pub fn explained(&self) -> Vec<Text> {
        let around = Text::new(
            format!(
                "Alrededor del diseño del libro, las demás entradas sin cambio: cuánto puede bajar y subir la entrada sin que el diseño se rechace ni incumpla una restricción (≥: hasta donde se ha mirado; sin él, hasta un límite, también el de la propia celda), y cuánto cambia cada objetivo. Las tolerancias, redondeadas hacia cero. rodete mira a {SAMPLES} distancias iguales a cada lado, hasta el ancho del intervalo, y más cerca que la primera a su mitad, su cuarto y así hasta 1/32; lo que hay entre dos de ellas no se ha mirado."
            ),
            format!(
                "Around the workbook's design, other inputs unchanged: how far the input may go down and up before the design is refused or breaks a constraint (≥: as far as was looked; without it, up to a limit, that of its own cell among them), and how much each objective changes. Tolerances are rounded towards zero. rodete looks at {SAMPLES} even distances to each side, as far as the range is wide, and nearer than the first at a half of it, a quarter and so on to a 32nd; what lies between two of them was not looked at."
            ),
        );
        let over = match self.triples {
            None if !self.shared() => Text::new(
                format!(
                    "Partes de la varianza: ninguna. Piden {SHARES_LEAST} diseños válidos, 4 de media en cada tramo de una entrada, y objetivos que varían."
                ),
                format!(
                    "Shares of the variance: none. They take {SHARES_LEAST} feasible designs, 4 in the mean in each slice of an input, and objectives that vary."
                ),
            ),
            None => t(
                "Partes: qué parte de la varianza sigue a esta entrada sola, en los diseños válidos. Son cifras aproximadas: de un plan que no se hizo para ellas (saltelli sí), o con diseños rechazados, pueden sumar más del 100 %.",
                "Shares: the part of the variance that follows this input alone, over the feasible designs. They are rough: of a plan that is not made for them (saltelli is), or with refused designs, they may sum to more than 100 %.",
            ),
            Some((of, all)) if !self.indexed() => Text::new(
                format!(
                    "Índices de Sobol: ninguno. Piden {LEAST} grupos cuyos diseños son válidos, y hay {of} de {all}; y objetivos que varían."
                ),
                format!(
                    "Sobol's indices: none. They take {LEAST} groups whose designs are feasible, and there are {of} of {all}; and objectives that vary."
                ),
            ),
            Some((of, all)) => Text::new(
                format!(
                    "Índices de Sobol, de {of} de {all} grupos cuyos diseños son válidos: qué parte de la varianza explica esta entrada sola, y sola y con las demás; ±: en 19 de cada 20 casos."
                ),
                format!(
                    "Sobol's indices, from {of} of {all} groups whose designs are feasible: which part of the variance this input explains alone, and alone and with others; ±: in 19 of 20 cases."
                ),
            ),
        };
        let own = self.effects.iter().find_map(|one| match &one.room {
            Err(NoRoom::Design(why)) => Some(why.clone()),
            _ => None,
        });
        let flat = self.effects.iter().any(|one| one.slopes.contains(&Slope::Rounding)).then(|| {
            t(
                "– en lugar de un cambio por unidad: en el paso que se mira, el objetivo cambia como mucho lo que se redondea (0.001 mm, 0.001°, 0.01 s).",
                "– in place of a change per unit: over the step that is looked at, the objective changes by no more than its rounding (0.001 mm, 0.001°, 0.01 s).",
            )
        });
        own.into_iter().chain([self.judged(), around]).chain(flat).chain([over]).collect()
    }
}
