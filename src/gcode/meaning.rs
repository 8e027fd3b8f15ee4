//! What G and M codes mean, in words.

use crate::gcode::code::{Cycle, G, M, SinglePassCycle, TurningCycle};
use crate::gcode::in_force::Compensation;
use crate::gcode::motion::{FeedMode, Plane};
use crate::text::{Text, t};

/// What is refused, by its name.
fn refused(Text { es, en }: &Text) -> Text {
    Text::new(format!("se rechaza: {es}"), format!("rejected: {en}"))
}

impl G {
    /// What the code does, in words for lists and messages.
    #[must_use]
    pub fn told(self) -> Text {
        match self {
            Self::Rapid => t("movimiento rápido", "rapid move"),
            Self::Linear => t("recta con avance", "straight move at feed"),
            Self::Arc(true) => t("arco horario", "arc clockwise"),
            Self::Arc(false) => t("arco antihorario", "arc counter-clockwise"),
            Self::Dwell => t("espera", "dwell"),
            Self::SetOffsets => {
                t("orígenes o tabla de herramientas por programa", "work offset or tool table by program")
            }
            Self::Plane(Plane::XY) => t("plano XY", "plane XY"),
            Self::Plane(Plane::ZX) => t("plano ZX", "plane ZX"),
            Self::Plane(Plane::YZ) => t("plano YZ", "plane YZ"),
            Self::Inch => t("pulgadas", "inches"),
            Self::Millimetre => t("milímetros", "millimetres"),
            Self::Reference(false) => t("al punto de referencia", "to the reference point"),
            Self::Reference(true) => t("a otro punto de referencia", "to another reference point"),
            Self::SetReference(false) => {
                t("esta posición es el punto de referencia", "this position is the reference point")
            }
            Self::SetReference(true) => {
                t("esta posición es el otro punto de referencia", "this position is the other reference point")
            }
            Self::Compensation(Compensation::Off) => t("sin compensación de radio", "no radius compensation"),
            Self::Compensation(Compensation::Left) => {
                t("compensación de radio a la izquierda", "radius compensation to the left")
            }
            Self::Compensation(Compensation::Right) => {
                t("compensación de radio a la derecha", "radius compensation to the right")
            }
            Self::CompensationGiven(Compensation::Off) => t("sin compensación de radio", "no radius compensation"),
            Self::CompensationGiven(Compensation::Left) => t(
                "compensación de radio a la izquierda, el diámetro en D",
                "radius compensation to the left, the diameter in D",
            ),
            Self::CompensationGiven(Compensation::Right) => t(
                "compensación de radio a la derecha, el diámetro en D",
                "radius compensation to the right, the diameter in D",
            ),
            Self::ToolLength => t("corrector de longitud de la tabla", "tool length offset from the table"),
            Self::ToolLengthGiven => t("corrector de longitud en el bloque", "tool length offset given in the block"),
            Self::ToolLengthAdded => t(
                "corrector de longitud que se suma al que está en vigor",
                "tool length offset added to the one in force",
            ),
            Self::ToolLengthOff => t("sin corrector de longitud", "no tool length offset"),
            Self::LocalOffset => t("origen local", "local offset"),
            Self::MachineCoordinates => t("este bloque en cotas de máquina", "this block in machine coordinates"),
            Self::WorkOffset(number) => {
                Text::new(format!("decalaje de origen {number}"), format!("work offset {number}"))
            }
            Self::PathControl => t(
                "control de la trayectoria, sin efecto en la programada",
                "path control, without effect on the programmed path",
            ),
            Self::PathTolerance => {
                t("control de la trayectoria con tolerancias P y Q", "path control with tolerances P and Q")
            }
            Self::Cycle(cycle) => cycle.told(),
            Self::Turning(cycle) => cycle.told(),
            Self::Pass(cycle) => cycle.told(),
            Self::Thread(false) => t("rosca", "thread"),
            Self::Thread(true) => t("rosca de paso variable", "thread of a changing lead"),
            Self::Cancel => t("ni ciclo ni movimiento", "no cycle, no motion"),
            Self::Absolute => t("cotas absolutas", "absolute coordinates"),
            Self::Incremental => t("cotas incrementales", "incremental coordinates"),
            Self::CentreAbsolute => t("centros absolutos", "absolute arc centres"),
            Self::CentreIncremental => t("centros desde el comienzo del arco", "arc centres from the start of the arc"),
            Self::SetPosition => t("esta posición recibe estas cotas", "this position gets these coordinates"),
            Self::ClearPosition => t("G92 anulado, sus registros a cero", "G92 off, its registers cleared"),
            Self::SuspendPosition => t("G92 anulado, sus registros quedan", "G92 off, its registers kept"),
            Self::RestorePosition => t("G92 otra vez en vigor", "G92 on again"),
            Self::Feed(FeedMode::PerMinute) => t("F por minuto", "F per minute"),
            Self::Feed(FeedMode::PerRevolution) => t("F por vuelta", "F per revolution"),
            Self::Feed(FeedMode::InverseTime) => {
                t("F es la inversa del tiempo en minutos", "F is the inverse of the time in minutes")
            }
            Self::Feed(FeedMode::Seconds) => t("F es el tiempo en segundos", "F is the time in seconds"),
            Self::ReturnInitial => t(
                "los ciclos vuelven a la altura de la que salieron",
                "cycles return to the height that they started from",
            ),
            Self::ReturnR => t("los ciclos vuelven a R", "cycles return to R"),
            Self::ConstantSurfaceSpeed => t("velocidad de corte constante", "constant surface speed"),
            Self::Rpm => t("revoluciones por minuto", "revolutions per minute"),
            Self::SetPositionOrSpeed => t(
                "esta posición recibe estas cotas; con S sola, el límite de giro",
                "this position gets these coordinates; with S alone the speed limit",
            ),
            Self::Refused(_, name) | Self::RefusedCycle(name) => refused(name),
        }
    }
}

impl Cycle {
    fn told(self) -> Text {
        match self {
            Self::ChipBreak => t("taladrado con rotura de viruta", "drilling with chip breaking"),
            Self::TapLeft => t("roscado a izquierdas con macho flotante", "left-hand tapping with a floating chuck"),
            Self::Drill => t("taladrado", "drilling"),
            Self::DrillDwell => t("taladrado con espera", "drilling with dwell"),
            Self::Peck => t("taladrado profundo", "peck drilling"),
            Self::TapRight => t("roscado a derechas con macho flotante", "right-hand tapping with a floating chuck"),
            Self::Bore => t("mandrinado, salida con avance", "boring, out at feed"),
            Self::BoreStop => t(
                "mandrinado, espera, parada del husillo, salida en rápido",
                "boring, dwell, spindle stop, out in rapid",
            ),
            Self::BackBore => t("mandrinado por detrás", "back boring"),
            Self::BoreManual => {
                t("mandrinado, espera, parada del husillo, salida a mano", "boring, dwell, spindle stop, out by hand")
            }
            Self::BoreDwell => t("mandrinado, espera, salida con avance", "boring, dwell, out at feed"),
        }
    }
}

impl TurningCycle {
    fn told(self) -> Text {
        match self {
            Self::Finish => t("acabado por el contorno", "finishing along the contour"),
            Self::Axial => t("desbaste a lo largo de Z", "stock removal along Z"),
            Self::Radial => t("desbaste a lo largo de X", "stock removal along X"),
            Self::Repeat => t("desbaste a lo largo del contorno", "stock removal along the contour"),
            Self::GrooveFace => t(
                "ranurado y taladrado a lo largo de Z con rotura de viruta",
                "grooving and drilling along Z, with chip breaking",
            ),
            Self::GrooveOutside => {
                t("ranurado a lo largo de X con rotura de viruta", "grooving along X, with chip breaking")
            }
            Self::Thread => t("rosca en varias pasadas", "a thread in several passes"),
            Self::ByLetters(cycle) => {
                let number = cycle.number();
                Text::new(format!("ciclo de torneado {number} de Fagor"), format!("Fagor's turning cycle {number}"))
            }
        }
    }
}

impl SinglePassCycle {
    fn told(self) -> Text {
        match self {
            Self::Axial => t("una pasada a lo largo de Z o de un cono", "one pass along Z or a cone"),
            Self::Thread => t("una pasada de rosca", "one pass of a thread"),
            Self::Radial => t("una pasada a lo largo de X o de un cono", "one pass along X or a cone"),
        }
    }
}

impl FeedMode {
    /// What F means.
    #[must_use]
    pub fn told(self) -> Text {
        G::Feed(self).told()
    }
}

impl M {
    /// What the code does, in words for lists and messages.
    #[must_use]
    pub fn told(self) -> Text {
        match self {
            Self::Pause => t("parada hasta que siga el operario", "stop until the operator goes on"),
            Self::End => t("fin del programa", "end of the program"),
            Self::Spindle(true) => t("husillo en sentido horario", "spindle clockwise"),
            Self::Spindle(false) => t("husillo en sentido antihorario", "spindle counter-clockwise"),
            Self::SpindleOff => t("husillo parado", "spindle off"),
            Self::SpindleOrient => t("husillo a un ángulo", "spindle to an angle"),
            Self::ToolChange => t("cambio de herramienta", "tool change"),
            Self::SetTool => t("la herramienta montada recibe un número", "the loaded tool gets a number"),
            Self::Coolant(true) => t("refrigerante", "coolant on"),
            Self::Coolant(false) => t("sin refrigerante", "coolant off"),
            Self::Override => t("mandos de corrección", "override switches"),
            Self::Output => t("una salida digital P", "a digital output P"),
            Self::Input => t("se lee o se espera una entrada", "an input is read or waited for"),
            Self::AnalogOutput => t("una salida analógica E recibe el valor Q", "an analog output E gets the value Q"),
            Self::SaveState(false) => t("se guarda el estado modal", "the modal state is kept"),
            Self::SaveState(true) => t(
                "se guarda el estado modal, y el fin de la llamada lo devuelve",
                "the modal state is kept, and the end of the call gives it back",
            ),
            Self::ForgetState => t("se tira lo que se guardó", "what was kept is dropped"),
            Self::RestoreState => t("vuelve a regir lo que se guardó", "what was kept is in force again"),
            Self::Call => t("llamada de un subprograma", "call of a subprogram"),
            Self::CallBlock => t(
                "llamada de un subprograma del mismo programa por el número de su primer bloque",
                "call of a subprogram of the same program by the number of its first block",
            ),
            Self::Return => t("regreso de un subprograma", "return from a subprogram"),
            Self::Door => t("puertas de la máquina", "the machine's doors"),
            Self::User => t("del fabricante o del usuario: no se ejecuta", "the builder's or the user's: not run"),
            Self::NotFollowed(Text { es, en }) => Text::new(format!("{es}: no se ejecuta"), format!("{en}: not run")),
            Self::Refused(name) => refused(name),
        }
    }
}
