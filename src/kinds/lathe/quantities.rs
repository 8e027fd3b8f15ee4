//! What turning programs come to, as derived values.

use super::follow::Followed;
use crate::finding::Grade;
use crate::geometry::revolution::volume;
use crate::kinds::lathe::setup::Given;
use crate::removal::turning::step::Total;
use crate::table::{Quantity, Unit};
use crate::text::t;

/// The symbols of those that the set-up gives without a program.
pub const SET_UP: [&str; 2] = ["L3", "Z_W1"];

/// What the programs come to.
pub(super) fn quantities(given: &Given, followed: &[Followed]) -> Vec<Quantity> {
    let quantity = |symbol, meaning, value, unit, source| Quantity { symbol, meaning, value, unit, source, cell: None };
    let sum = |of: fn(&Total) -> f64| followed.iter().map(|one| of(&one.simulation.totals().all)).sum::<f64>();
    let most = |of: fn(&Total) -> f64| followed.iter().map(|one| of(&one.simulation.totals().all)).fold(0.0, f64::max);
    let count = |grade: Option<Grade>| {
        let alarms = followed.iter().flat_map(|one| &one.alarms);
        let counted = alarms.filter(|one| grade.is_none_or(|grade| one.alarm.cause.grade() == grade)).count();
        f64::from(u32::try_from(counted).unwrap_or(u32::MAX))
    };
    let none = || t("", "");
    let left = followed.last().map_or(0.0, |one| one.drawn.part.iter().map(|ring| volume(ring)).sum());
    let mm3 = Unit::CubicMillimetre;
    let mut quantities = vec![
        quantity("L3", t("Voladizo", "Stick-out"), given.setup.stock.overhang, Unit::Millimetre, t("L − L4", "L − L4")),
        quantity(
            "Z_W1",
            t("Cero pieza W1, desde M", "Part zero W1, from M"),
            given.setup.stock.zero(&given.setup.lathe),
            Unit::Millimetre,
            t("L1 + L2 + L3 − L5", "L1 + L2 + L3 − L5"),
        ),
        quantity("t", t("Duración", "Time"), sum(|all| all.seconds), Unit::Second, t("programa leído", "program read")),
        quantity("t_c", t("de ella, cortando", "of it, cutting"), sum(|all| all.cutting_seconds), Unit::Second, none()),
        quantity(
            "t_G0",
            t("de ella, en rápido", "of it, in rapid"),
            sum(|all| all.rapid_seconds),
            Unit::Second,
            none(),
        ),
        quantity("V_r", t("Volumen arrancado", "Volume removed"), sum(|all| all.volume), mm3, none()),
        quantity("V_t", t("Volumen tronzado", "Volume parted off"), sum(|all| all.parted), mm3, none()),
        quantity("V", t("Volumen de la pieza", "Volume of the part"), left, mm3, none()),
        quantity(
            "a_p",
            t("Profundidad de pasada máxima (en una broca, su radio)", "Maximum depth of cut (of a drill its radius)"),
            most(|all| all.depth),
            Unit::Millimetre,
            none(),
        ),
        quantity(
            "V_c",
            t("Velocidad de corte máxima", "Maximum cutting speed"),
            most(|all| all.cutting_speed),
            Unit::MetrePerMinute,
            none(),
        ),
        quantity(
            "Q",
            t("Caudal de viruta máximo", "Maximum removal rate"),
            most(|all| all.rate),
            Unit::CubicCentimetrePerMinute,
            none(),
        ),
        quantity("alarms", t("Alarmas", "Alarms"), count(None), Unit::Count, none()),
        quantity("stops", t("de ellas, paradas", "of them, stops"), count(Some(Grade::Stop)), Unit::Count, none()),
    ];
    let apart = followed.iter().map(|one| one.repeated).fold(0.0, f64::max);
    let name =
        t("Contorno, comparado con otra biblioteca de polígonos", "Contour, compared with another polygon library");
    quantities.push(quantity("δ_2", name, apart, Unit::Millimetre, t("distancia media", "mean distance")));
    quantities
}
