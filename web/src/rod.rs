//! The connecting rod in flight, each number of modes, fidelity and scalar compiled on its own.

use ffrf::FlexibleBody;

use crate::motion::{Choice, Flight, Motion};

ffrf::flexible_body! {
    /// The steel connecting rod of `models/conrod`.
    pub family rods {
        model: "../models/conrod.ffrf.json",
        modes: [0, 2, 4, 8],
        fidelity: [full, linear],
        scalar: [f64, f32],
    }
}

/// About the axis of middle inertia, which is not stable: the rod flips over and over. Units: rad/s.
const SPIN: [f64; 3] = [0.3, 200.0, 0.3];
/// Units of the first modal coordinate: 0.3 mm at the small end.
const DEFORMATION: f64 = 1e-4;

/// The rod in flight. Errors: there is no such member of the family.
pub fn flying(choice: Choice) -> Result<Box<dyn Motion>, String> {
    macro_rules! choose {
        ($($name:ident, $modes:literal, $fidelity:literal, $scalar:ident;)*) => {$(
            // without modes all fidelities are the same
            if choice.modes == $modes
                && ($modes == 0 || choice.linear == ($fidelity == "linear"))
                && choice.single == (stringify!($scalar) == "f32")
            {
                let stable = FlexibleBody::<$scalar>::largest_stable_step(&rods::$name).map(f64::from);
                return Ok(Box::new(Flight::<_, $scalar>::tumbling(rods::$name, SPIN, DEFORMATION, stable)));
            }
        )*};
    }
    macro_rules! each {
        ($name:ident, $modes:literal, $fidelity:literal, $scalar:ident) => {
            choose! { $name, $modes, $fidelity, $scalar; }
        };
    }
    rods::members!(each);
    Err(format!("there is no rod of {} modes here", choice.modes))
}
