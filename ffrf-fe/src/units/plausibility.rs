//! Density, size, first frequency and the speed that follows from them, beside what solids have.

use ffrf_model::Units;

use super::volume;
use crate::FeModel;

/// What solids have, in SI units: name, unit, least, largest, why.
struct Range {
    what: &'static str,
    unit: &'static str,
    least: f64,
    largest: f64,
}

/// From aerogel to osmium. Units: kg/m³.
const DENSITY: Range = Range { what: "density", unit: "kg/m^3", least: 1.0, largest: 23_000.0 };
/// From a grain of dust to a ship. Units: m.
const SIZE: Range = Range { what: "size", unit: "m", least: 1e-6, largest: 500.0 };
/// From the slowest large structures (some 0.03 Hz) to grains. Units: Hz.
const FREQUENCY: Range = Range { what: "first frequency", unit: "Hz", least: 0.01, largest: 1e9 };
/// Twice size times first frequency: for a free rod the speed of sound, for slender parts down to 1e-4 of it. The
/// fastest solid, diamond, has 18 km/s. Units: m/s.
const SPEED: Range = Range {
    what: "speed of sound (twice size times first frequency)",
    unit: "m/s",
    least: 0.5,
    largest: 30_000.0,
};

/// Units that a model is commonly in.
const COMMON: [&str; 5] = ["m, kg, s", "mm, t, s", "mm, kg, ms", "mm, g, ms", "in, slinch, s"];

/// Figures of a model in its own units.
struct Figures {
    /// Mass over the volume of the elements, or over the box around the nodes: then it is a lower bound.
    density: Option<f64>,
    /// The density is a lower bound.
    at_least: bool,
    size: f64,
    frequency: Option<f64>,
}

/// Remarks on figures that no solid has, in the words of the user; empty for an ordinary part.
///
/// `frequency` is that of the first elastic mode over the unit of time (Hz if time is in s). Without units the figures
/// are judged as if they were SI. Where another common set of units makes all of them ordinary, the remark names it.
pub fn implausible(model: &FeModel, units: Option<Units>, frequency: Option<f64>) -> Vec<String> {
    let figures = figures(model, frequency);
    let mut remarks = odd(&figures, &units.unwrap_or(Units::SI));
    if remarks.is_empty() {
        return remarks;
    }
    let named = units
        .map_or_else(|| "units are not stated; taken as SI".to_owned(), |units| format!("units {units}"));
    let ordinary =
        COMMON.iter().filter_map(|text| Units::of(text)).find(|units| odd(&figures, units).is_empty());
    remarks.push(match ordinary {
        Some(other) => format!("{named}: in {other} all these figures would be ordinary, see --units"),
        None => format!("{named}: are the numbers of the deck in one coherent set of units?"),
    });
    remarks
}

fn figures(model: &FeModel, frequency: Option<f64>) -> Figures {
    let mass: f64 = model.mass.val().iter().sum();
    let edges = volume::box_edges(model);
    let elements = volume::of_elements(model).filter(|&volume| volume > 0.0);
    let volume = elements.unwrap_or(edges[0] * edges[1] * edges[2]);
    Figures {
        density: (volume > 0.0).then(|| mass / volume),
        at_least: elements.is_none(),
        size: edges.into_iter().fold(0.0, f64::max),
        frequency: frequency.filter(|&frequency| frequency > 0.0),
    }
}

/// The figures that no solid has in these units.
fn odd(figures: &Figures, units: &Units) -> Vec<String> {
    let (length, time) = (units.length(), units.time());
    let mut remarks = Vec::new();
    let mut judge = |range: &Range, value: f64, lower: f64| {
        if !(lower..=range.largest).contains(&value) {
            let Range { what, unit, largest, .. } = range;
            let bound =
                if value > *largest { format!("at most {largest:e}") } else { format!("at least {lower:e}") };
            remarks.push(format!("the {what} is {value:.3e} {unit}: solids have {bound}"));
        }
    };
    if let Some(density) = figures.density {
        // A frame may fill a thousandth of its box.
        let fill = if figures.at_least { 1e-3 } else { 1.0 };
        judge(&DENSITY, density * units.mass() / length.powi(3), fill * DENSITY.least);
    }
    let size = figures.size * length;
    judge(&SIZE, size, SIZE.least);
    if let Some(frequency) = figures.frequency {
        let frequency = frequency / time;
        judge(&FREQUENCY, frequency, FREQUENCY.least);
        judge(&SPEED, 2.0 * size * frequency, SPEED.least);
    }
    remarks
}
