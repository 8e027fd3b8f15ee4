//! What goes wrong while a program turns: numbered, with cause, place and depth.

use super::stock::Fixture;
use crate::finding::{Finding, Grade, Place};
use crate::gcode::control::Compensation;
use crate::machine::axis::Axis;
use crate::number::shown;
use crate::text::Text;

/// Depths up to this are contact and no collision, mm.
pub const TOUCH: f64 = 0.001;

/// How deep a retraction may scrape without being a stop, mm.
///
/// An edge of lead angle φ1 > 90° leans away from the shoulder in front of which it stops, and leaves there a wedge of
/// a tan(φ1 − 90°) at a depth of cut a: 0.44 mm at 95° and 5 mm. A tool that is taken straight up the shoulder, by a program
/// or by a cycle whose way out no program changes, takes it away with its nose, and a finishing allowance with it. That is
/// metal, cut at rapid, but no crash. Anything deeper is no leftover of the edge's own. Derived here.
pub const SCRAPE: f64 = 0.5;

/// What moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moving {
    /// The cutter.
    Cutter,
    /// The holder.
    Holder,
    /// The turret's body.
    Turret,
}

/// Why an alarm is raised. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// A rapid motion goes through metal.
    RapidInMetal,
    /// The tool is taken off its cut at rapid and scrapes metal, no deeper than [`SCRAPE`].
    RetractionInMetal,
    /// An edge of the cutter that does not cut runs into metal.
    BackInMetal,
    /// The holder or the turret runs into metal.
    BodyInMetal(Moving),
    /// A boring bar is fed into metal where there is no hole, or none wide enough for it.
    BoreWithoutHole {
        /// The diameter of the hole before it; 0 where there is none.
        hole: f64,
        /// The least that bar and edge need.
        least: f64,
    },
    /// Something that moves runs into something that stands.
    Collision(Moving, Fixture),
    /// The turret's reference point leaves the travel of an axis.
    Travel(Axis),
    /// The cut is deeper than the cutting edge is long across the motion.
    DepthOfCut {
        /// The depth of cut.
        depth: f64,
        /// What the edge has.
        edge: f64,
    },
    /// Another edge makes the surface and not the nose: the far end of the auxiliary edge leaves its mark, or an edge takes away
    /// again what a nose has made.
    BackCutting,
    /// A thread without a lead.
    NoLead,
    /// The lead is none that the insert is made for.
    Lead {
        /// The lead programmed.
        lead: f64,
        /// The least and the greatest of the insert.
        leads: [f64; 2],
    },
    /// A pass of a thread with another lead than the passes before.
    LeadDiffers {
        /// The lead of this pass.
        lead: f64,
        /// The lead of the earlier ones.
        before: f64,
    },
    /// A thread is cut with a tool for something else.
    NoThreader,
    /// The spindle's speed is not the same in all passes of a thread.
    ThreadSpeed {
        /// The speed in this pass, rpm.
        speed: f64,
        /// Another in this pass, or that of an earlier one, rpm.
        before: f64,
    },
    /// A constant surface speed without a greatest speed asks for more than the spindle can.
    NoGreatestSpeed {
        /// The speed asked for, rpm; infinite on the axis.
        asked: f64,
        /// The machine's greatest, rpm.
        most: f64,
    },
    /// S is more than the spindle can.
    TooFast {
        /// The speed asked for, rpm.
        asked: f64,
        /// The machine's greatest, rpm.
        most: f64,
    },
    /// The spindle stands still in the cut.
    SpindleStopped,
    /// A feed per revolution while the spindle stands still: the slide does not move.
    FeedStands,
    /// The spindle turns the way in which the tool does not cut.
    SpindleWrongWay,
    /// No coolant in the cut.
    NoCoolant,
    /// A feed of 0.
    NoFeed,
    /// A feed in the cut that is none of turning, in mm a revolution: F is meant the other way, in mm/min or per revolution.
    ImplausibleFeed {
        /// What the tool is fed with each revolution, mm.
        feed: f64,
        /// Between what it is taken as it stands, mm.
        limits: [f64; 2],
    },
    /// The turret has no tool in this place.
    UnknownTool(u32),
    /// The offset in force is none of the tool's; 0: none is.
    OtherOffset {
        /// The number in force.
        offset: u32,
        /// The tool's own.
        own: u32,
    },
    /// A drill works beside the axis.
    OffAxis,
    /// The turret turns to this place where one of its tools has no room, or over the stock.
    ToolChange(u32),
    /// G41 or G42 keeps the nose on the side to which the tip points: into the work.
    NoseInTheWork(Compensation),
    /// The feed leaves ridges: it is too much for the nose.
    CoarseFeed {
        /// What the tool is fed with each revolution, mm.
        feed: f64,
        /// The most that the nose smooths, mm.
        most: f64,
    },
    /// A thread is deeper than its lead has room for: its crests are gone.
    ThreadTooDeep {
        /// How deep.
        depth: f64,
        /// The most.
        most: f64,
    },
    /// A thread begins in metal before the slide has come up to its speed.
    ShortRunIn {
        /// How far it runs in.
        length: f64,
        /// What it needs.
        least: f64,
    },
    /// A piece is cut off, mm³.
    PartedOff(f64),
}

/// An alarm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alarm {
    /// Why.
    pub cause: Cause,
    /// The number of the motion, from 0.
    pub motion: usize,
    /// The number of the subprogram's file; 0 for the program.
    pub file: usize,
    /// The line of the file, from 1.
    pub line: usize,
    /// The block number.
    pub n: Option<u32>,
    /// Where, in program coordinates: X as a diameter, and Z; mm.
    pub place: [f64; 2],
    /// How deep, mm, where that has a meaning: into metal, into a fixture, past the travel.
    pub depth: Option<f64>,
}

impl Moving {
    const fn name(self) -> [&'static str; 2] {
        match self {
            Self::Cutter => ["la placa o broca", "the insert or drill"],
            Self::Holder => ["el portaherramientas", "the holder"],
            Self::Turret => ["la torreta", "the turret"],
        }
    }
}

impl Fixture {
    const fn name(self) -> [&'static str; 2] {
        match self {
            Self::Chuck => ["el plato", "the chuck"],
            Self::Jaws => ["las garras", "the jaws"],
            Self::Tailstock => ["el contrapunto", "the tailstock"],
        }
    }
}

impl Cause {
    /// What one alarm is told from another by: its number, and the axis that is at the end of its travel.
    #[must_use]
    pub const fn key(self) -> (u16, Option<u8>) {
        (self.number(), if let Self::Travel(axis) = self { Some(axis as u8) } else { None })
    }

    /// The alarm's number.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::RapidInMetal | Self::RetractionInMetal => 101,
            Self::BackInMetal => 102,
            Self::BodyInMetal(Moving::Turret) => 104,
            Self::BodyInMetal(_) => 103,
            Self::BoreWithoutHole { .. } => 105,
            Self::Collision(moving, fixture) => 111 + 3 * moving as u16 + fixture as u16,
            Self::Travel(_) => 121,
            Self::DepthOfCut { .. } => 131,
            Self::BackCutting => 132,
            Self::NoLead => 141,
            Self::Lead { .. } => 142,
            Self::LeadDiffers { .. } => 143,
            Self::NoThreader => 144,
            Self::ThreadSpeed { .. } => 145,
            Self::ThreadTooDeep { .. } => 146,
            Self::ShortRunIn { .. } => 147,
            Self::NoGreatestSpeed { .. } => 151,
            Self::TooFast { .. } => 152,
            Self::SpindleStopped => 153,
            Self::SpindleWrongWay => 154,
            Self::FeedStands => 155,
            Self::NoCoolant => 161,
            Self::NoFeed => 171,
            Self::ImplausibleFeed { .. } => 172,
            Self::CoarseFeed { .. } => 173,
            Self::UnknownTool(_) => 181,
            Self::OffAxis => 182,
            Self::OtherOffset { .. } => 183,
            Self::ToolChange(_) => 184,
            Self::NoseInTheWork(_) => 185,
            Self::PartedOff(_) => 191,
        }
    }

    /// True where it hangs on where the tool is: with another tool's offset it may follow from that.
    #[must_use]
    pub const fn hangs_on_offset(self) -> bool {
        matches!(
            self,
            Self::RapidInMetal
                | Self::RetractionInMetal
                | Self::BackInMetal
                | Self::BodyInMetal(_)
                | Self::BoreWithoutHole { .. }
                | Self::Collision(..)
                | Self::Travel(_)
                | Self::DepthOfCut { .. }
                | Self::BackCutting
                | Self::ThreadTooDeep { .. }
                | Self::ShortRunIn { .. }
                | Self::OffAxis
                | Self::SpindleWrongWay
        )
    }

    /// How grave it is.
    #[must_use]
    pub const fn grade(self) -> Grade {
        match self {
            Self::NoCoolant | Self::PartedOff(_) => Grade::Note,
            Self::RetractionInMetal
            | Self::BackCutting
            | Self::Lead { .. }
            | Self::LeadDiffers { .. }
            | Self::NoThreader
            | Self::ThreadSpeed { .. }
            | Self::ThreadTooDeep { .. }
            | Self::ShortRunIn { .. }
            | Self::CoarseFeed { .. }
            | Self::NoseInTheWork(_)
            | Self::ImplausibleFeed { .. }
            | Self::NoGreatestSpeed { .. }
            | Self::OtherOffset { .. }
            | Self::TooFast { .. } => Grade::Caution,
            _ => Grade::Stop,
        }
    }

    /// What happens, as a sentence without a full stop.
    #[must_use]
    pub fn text(self) -> Text {
        let t = Text::fixed;
        match self {
            Self::RapidInMetal => t("Avance rápido a través del material", "Rapid motion through metal"),
            Self::RetractionInMetal => {
                t("La retirada raspa el material en avance rápido", "The retraction scrapes metal at rapid")
            }
            Self::BackInMetal => t(
                "Un lado sin filo de la placa entra en el material",
                "A side of the insert that does not cut runs into metal",
            ),
            Self::BodyInMetal(moving) => {
                let [es, en] = moving.name();
                sentence(format!("{es} entra en el material"), format!("{en} runs into metal"))
            }
            Self::BoreWithoutHole { hole, .. } if hole > TOUCH => t(
                "La barra de mandrinar entra con avance en un agujero demasiado estrecho para ella",
                "The boring bar is fed into a hole that is too narrow for it",
            ),
            Self::BoreWithoutHole { .. } => t(
                "La barra de mandrinar entra con avance en macizo, donde no hay agujero",
                "The boring bar is fed into solid metal, where there is no hole",
            ),
            Self::Collision(moving, fixture) => {
                let ([es, en], [es_in, en_in]) = (moving.name(), fixture.name());
                sentence(format!("{es} choca con {es_in}"), format!("{en} hits {en_in}"))
            }
            Self::Travel(axis) => Text::new(
                format!("El eje {} sale de su recorrido", axis.letter()),
                format!("Axis {} leaves its travel", axis.letter()),
            ),
            Self::DepthOfCut { .. } => {
                t("La profundidad de corte es mayor que el filo", "The depth of cut is greater than the cutting edge")
            }
            Self::BackCutting => t(
                "El perfil queda fuera del alcance: corta otro filo, no la punta",
                "The profile is out of reach: another edge cuts, not the nose",
            ),
            Self::NoLead => t("Rosca sin paso", "Thread without a lead"),
            Self::Lead { .. } => {
                t("El paso no es de los de la placa de roscar", "The lead is none of the threading insert's")
            }
            Self::LeadDiffers { .. } => t(
                "El avance de la rosca no es el paso de las pasadas anteriores",
                "The feed in the thread is not the lead of the earlier passes",
            ),
            Self::NoThreader => t(
                "Se rosca con una herramienta que no es de roscar",
                "A thread is cut with a tool that is not for threads",
            ),
            Self::ThreadSpeed { .. } => t(
                "El giro del husillo cambia entre las pasadas de la rosca: no entran en el mismo filete",
                "The spindle's speed changes between the passes of the thread: they do not enter the same groove",
            ),
            Self::NoGreatestSpeed { .. } => t(
                "Velocidad de corte constante sin giro máximo: cerca del eje el husillo llega a su límite",
                "Constant surface speed without a greatest speed: near the axis the spindle runs up to its limit",
            ),
            Self::TooFast { .. } => {
                t("S es mayor que el giro máximo del husillo", "S is more than the spindle's greatest speed")
            }
            Self::SpindleStopped => t("Corte con el husillo parado", "Cutting with the spindle stopped"),
            Self::SpindleWrongWay => {
                t("El husillo gira al revés para esta herramienta", "The spindle turns the wrong way for this tool")
            }
            Self::FeedStands => t(
                "Avance por vuelta con el husillo parado: el carro no se mueve",
                "Feed per revolution with the spindle stopped: the slide does not move",
            ),
            Self::OtherOffset { offset: 0, .. } => {
                t("Movimiento de trabajo sin corrector de herramienta", "Motion at feed without a tool offset")
            }
            Self::OtherOffset { .. } => {
                t("El corrector en vigor no es el de la herramienta", "The offset in force is not the tool's own")
            }
            Self::NoCoolant => t("Corte sin refrigerante", "Cutting without coolant"),
            Self::NoFeed => t("Movimiento de trabajo con avance 0", "Motion at feed with a feed of 0"),
            Self::ImplausibleFeed { .. } => t(
                "El avance por vuelta en el corte no es propio del torneado",
                "The feed per revolution in the cut is none of turning",
            ),
            Self::UnknownTool(place) => Text::new(
                format!("No hay herramienta en el puesto {place} de la torreta"),
                format!("There is no tool in place {place} of the turret"),
            ),
            Self::OffAxis => t("La broca trabaja fuera del eje", "The drill works beside the axis"),
            Self::ToolChange(place) => Text::new(
                format!("La torreta gira al puesto {place} dentro de la pieza, en lo que la sujeta o sobre el bruto"),
                format!("The turret turns to place {place} inside the work, in what holds it or over the stock"),
            ),
            Self::NoseInTheWork(side) => {
                let code = if side == Compensation::Left { "G41" } else { "G42" };
                Text::new(
                    format!("{code} deja la punta del lado de la pieza"),
                    format!("{code} keeps the nose on the side of the work"),
                )
            }
            Self::CoarseFeed { .. } => t(
                "El avance por vuelta es demasiado para el radio de punta: deja surcos",
                "The feed per revolution is too much for the nose radius: it leaves ridges",
            ),
            Self::ThreadTooDeep { .. } => t(
                "La rosca es más honda de lo que admite su paso: se lleva las crestas",
                "The thread is deeper than its lead allows: its crests are cut away",
            ),
            Self::ShortRunIn { .. } => t(
                "La entrada de la rosca es más corta de lo que necesita el control: el paso sale corto",
                "The run-in of the thread is shorter than the control needs: its lead comes out short",
            ),
            Self::PartedOff(_) => t("Se desprende una pieza", "A piece is cut off"),
        }
    }

    /// What to do about it.
    #[must_use]
    pub const fn remedy(self) -> Text {
        let t = Text::fixed;
        match self {
            Self::RapidInMetal => t(
                "Aleje el punto de partida o haga este movimiento con avance de trabajo",
                "Start farther away, or make this motion at feed",
            ),
            Self::RetractionInMetal => t(
                "Retire con avance o a 45°, termine el contorno del ciclo fuera del bruto, o use una herramienta con φ1 de 90° o menos",
                "Retract at feed or at 45°, end the cycle's contour outside the stock, or use a tool with φ1 of 90° or less",
            ),
            Self::BackInMetal | Self::BackCutting => t(
                "Elija una herramienta de otra mano o con más ángulo libre, o cambie el sentido de la pasada",
                "Choose a tool of the other hand or with more clearance, or turn the pass about",
            ),
            Self::BodyInMetal(Moving::Turret) | Self::Collision(Moving::Turret, Fixture::Chuck | Fixture::Jaws) => t(
                "Use una herramienta que sobresalga más, o compruebe su l y el cuerpo de la torreta (BX_min a BZ_max en el libro)",
                "Use a tool that stands out more, or check its l and the turret's body (BX_min to BZ_max in the workbook)",
            ),
            Self::BodyInMetal(_) => {
                t("Elija una herramienta más larga o más estrecha", "Choose a longer or a narrower tool")
            }
            Self::BoreWithoutHole { .. } => t(
                "Taladre antes hasta el diámetro que aquí se da como mínimo, o abra el agujero en más pasadas o con una barra más delgada",
                "Drill first, up to the diameter told here as the least, or open the hole in more passes or with a thinner bar",
            ),
            Self::Collision(_, Fixture::Tailstock) => t(
                "Retire el contrapunto (en el libro, tailstock: no), o limite el movimiento",
                "Withdraw the tailstock (in the workbook, tailstock: no), or keep the motion away",
            ),
            Self::Collision(..) => t(
                "Sujete la pieza más afuera o limite el movimiento",
                "Clamp the work farther out, or keep the motion away",
            ),
            Self::Travel(_) => {
                t("Revise ceros y correctores, o acerque la pieza", "Check zeros and offsets, or bring the work nearer")
            }
            Self::DepthOfCut { .. } => t("Reparta el corte en más pasadas", "Divide the cut into more passes"),
            Self::NoLead => t("Escriba el paso con F", "Write the lead with F"),
            Self::Lead { .. } => t("Cambie de placa o corrija F", "Change the insert or correct F"),
            Self::LeadDiffers { .. } => t("Use el mismo paso en todas las pasadas", "Use the same lead in all passes"),
            Self::NoThreader => t("Llame a la herramienta de roscar", "Call the threading tool"),
            Self::ThreadSpeed { .. } => t("Rosque con G97 y S en rpm", "Cut threads with G97 and S in rpm"),
            Self::NoGreatestSpeed { .. } => t("Limite el giro con G50 S (G92 S)", "Limit the speed with G50 S (G92 S)"),
            Self::TooFast { .. } => t("Reduzca S", "Reduce S"),
            Self::OtherOffset { .. } => {
                t("Llame a la herramienta con su corrector", "Call the tool with its own offset")
            }
            Self::SpindleStopped | Self::FeedStands => {
                t("Programe M3 o M4 con S antes del corte", "Program M3 or M4 with S before the cut")
            }
            Self::SpindleWrongWay => t(
                "Cambie M3 por M4 o al revés; si la herramienta está montada con la otra cara arriba, escriba en su celda M de la hoja HERRAMIENTAS el giro con el que corta",
                "Change M3 to M4 or the other way; where the tool lies the other face up, write the way it cuts in its cell M on the sheet TOOLS",
            ),
            Self::NoCoolant => t("Programe M8 si el material lo pide", "Program M8 if the material asks for it"),
            Self::NoFeed => t("Programe F", "Program F"),
            Self::ImplausibleFeed { .. } => t(
                "Compruebe F y si es por vuelta (G99; G95 en Fagor) o por minuto (G98; G94)",
                "Check F, and whether it is per revolution (G99; on a Fagor G95) or per minute (G98; G94)",
            ),
            Self::UnknownTool(_) => t("Monte la herramienta o corrija T", "Mount the tool or correct T"),
            Self::OffAxis => t("Lleve la broca a X0", "Bring the drill to X0"),
            Self::ToolChange(_) => t(
                "Retire antes la torreta, a la derecha de la cara y libre con todas sus herramientas, o con G28",
                "Take the turret away first, to the right of the face and clear with all its tools, or with G28",
            ),
            Self::NoseInTheWork(Compensation::Left) => t(
                "Programe G42: por fuera hacia el plato, y por dentro al revés",
                "Program G42: outside towards the chuck, and inside the other way about",
            ),
            Self::NoseInTheWork(_) => t(
                "Programe G41: por dentro hacia el plato, y por fuera al revés",
                "Program G41: inside towards the chuck, and outside the other way about",
            ),
            Self::CoarseFeed { .. } => {
                t("Reduzca F o use más radio de punta", "Reduce F, or use a greater nose radius")
            }
            Self::ThreadTooDeep { .. } => {
                t("Compruebe el diámetro del fondo y el paso F", "Check the diameter of the root and the lead F")
            }
            Self::ShortRunIn { .. } => {
                t("Comience la pasada más lejos o reduzca S", "Begin the pass farther away, or reduce S")
            }
            Self::PartedOff(_) => t("", ""),
        }
    }
}

fn sentence(es: String, en: String) -> Text {
    let capital = |text: String| {
        let mut letters = text.chars();
        letters.next().map(|first| first.to_uppercase().collect::<String>() + letters.as_str()).unwrap_or_default()
    };
    Text::new(capital(es), capital(en))
}

impl Alarm {
    /// The alarm as a finding at a line of the program's file.
    #[must_use]
    pub fn finding(&self) -> Finding {
        let [x, z] = self.place.map(|at| shown(at, 3));
        let what = self.cause.text();
        let number = self.cause.number();
        let at = |text: &str| format!("{number} {text}, X{x} Z{z}");
        let what = Text::new(at(&what.es), at(&what.en));
        let mm = |value: f64| format!("{} mm", shown(value, 3));
        let rpm = |value: f64| if value.is_finite() { format!("{} rpm", shown(value, 0)) } else { "∞".to_owned() };
        let (value, limit) = match self.cause {
            Cause::DepthOfCut { depth, edge } => (mm(depth), mm(edge)),
            Cause::BoreWithoutHole { hole, least } => (format!("Ø {}", mm(hole)), format!("≥ Ø {}", mm(least))),
            Cause::OtherOffset { offset, own } => (format!("D{offset}"), format!("D{own}")),
            Cause::ThreadTooDeep { depth, most } => (mm(depth), format!("≤ {}", mm(most))),
            Cause::ShortRunIn { length, least } => (mm(length), format!("≥ {}", mm(least))),
            Cause::CoarseFeed { feed, most } => (mm(feed), format!("≤ {}", mm(most))),
            Cause::Lead { lead, leads: [low, high] } => (mm(lead), format!("{} – {}", shown(low, 3), mm(high))),
            Cause::LeadDiffers { lead, before } => (mm(lead), mm(before)),
            Cause::ThreadSpeed { speed, before } => (rpm(speed), rpm(before)),
            Cause::ImplausibleFeed { feed, limits: [low, high] } => {
                (format!("{} mm", shown(feed, 6)), format!("{} – {}", shown(low, 3), mm(high)))
            }
            Cause::NoGreatestSpeed { asked, most } | Cause::TooFast { asked, most } => (rpm(asked), rpm(most)),
            Cause::PartedOff(volume) => (format!("{} mm³", shown(volume, 1)), String::new()),
            _ => (self.depth.map(mm).unwrap_or_default(), String::new()),
        };
        let place = Place::Line { line: self.line, columns: Vec::new() };
        Finding::new(self.cause.grade(), place, what, self.cause.remedy()).with(value, limit)
    }
}
