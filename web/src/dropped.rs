//! A body of the user's own in flight: kernels whose invariants come at run time.

use ffrf::nalgebra::{RealField, SVector};
use ffrf::{FlexibleBody, Observables};
use ffrf_model::ReducedBody;

use crate::motion::{Choice, Flight, Motion};

/// Turns in a second about the axis of middle inertia, as a share of the lowest frequency.
const SPIN: f64 = 0.02;
/// Spin of a body without frequencies. Units: rad/s.
const RIGID_SPIN: f64 = 20.0;
/// Largest deformation of the first marker at the start, relative to its distance from the frame origin.
const BENT: f64 = 1e-3;

macro_rules! bodies {
    ($($module:ident $modes:literal;)*) => {$(
        mod $module {
            use super::*;

            ffrf::flexible_body! {
                /// Everything as general as it can be.
                pub struct Full { modes: $modes, layout: {}, scalar: generic }
            }
            ffrf::flexible_body! {
                /// Terms of first order in the modal coordinates.
                pub struct Linear { modes: $modes, layout: {}, scalar: generic, fidelity: linear }
            }

            pub fn flying(body: &ReducedBody, choice: Choice) -> Result<Box<dyn Motion>, String> {
                let Invariants { modal_first_moment, position_mode_moment, mode_mode_moment, stiffness, damping } =
                    Invariants::<$modes>::of(body)?;
                let inertia = &body.inertia;
                macro_rules! filled {
                    ($kind:ident) => {{
                        let kernels = $kind {
                            mass: inertia.mass,
                            first_moment: inertia.first_moment,
                            modal_first_moment,
                            second_moment: inertia.second_moment,
                            position_mode_moment,
                            mode_mode_moment,
                            stiffness,
                            damping,
                        };
                        kernels.check().map_err(|error| error.to_string())?;
                        Ok(if choice.single {
                            thrown::<_, f32, $modes>(kernels, body)
                        } else {
                            thrown::<_, f64, $modes>(kernels, body)
                        })
                    }};
                }
                if choice.linear { filled!(Linear) } else { filled!(Full) }
            }
        }
    )*};
}

bodies! { m0 0; m1 1; m2 2; m3 3; m4 4; m6 6; m8 8; }

/// The body in flight. Errors: there are no kernels for so many modes, or the body has fewer.
pub fn flying(body: &ReducedBody, choice: Choice) -> Result<Box<dyn Motion>, String> {
    let body = body.with_modes(choice.modes).map_err(|error| error.to_string())?;
    match choice.modes {
        0 => m0::flying(&body, choice),
        1 => m1::flying(&body, choice),
        2 => m2::flying(&body, choice),
        3 => m3::flying(&body, choice),
        4 => m4::flying(&body, choice),
        6 => m6::flying(&body, choice),
        8 => m8::flying(&body, choice),
        modes => Err(format!("there are kernels for 0, 1, 2, 3, 4, 6 and 8 modes here, not for {modes}")),
    }
}

/// Invariants as a generated body holds them. Shape: M modes.
struct Invariants<const M: usize> {
    modal_first_moment: [[f64; 3]; M],
    position_mode_moment: [[[f64; 3]; 3]; M],
    mode_mode_moment: [[[[f64; 3]; 3]; M]; M],
    stiffness: [[f64; M]; M],
    damping: [[f64; M]; M],
}

impl<const M: usize> Invariants<M> {
    /// Errors: a list is shorter than the number of modes.
    fn of(body: &ReducedBody) -> Result<Self, String> {
        let inertia = &body.inertia;
        Ok(Self {
            modal_first_moment: list(&inertia.modal_first_moment)?,
            position_mode_moment: list(&inertia.position_mode_moment)?,
            mode_mode_moment: rows(&inertia.mode_mode_moment)?,
            stiffness: rows(&body.stiffness)?,
            damping: rows(&body.damping)?,
        })
    }
}

fn list<E: Copy, const M: usize>(entries: &[E]) -> Result<[E; M], String> {
    entries.try_into().map_err(|_| format!("expected a list of {M} entries, found {}", entries.len()))
}

fn rows<E: Copy, const M: usize>(entries: &[Vec<E>]) -> Result<[[E; M]; M], String> {
    let mut all = Vec::with_capacity(M);
    for row in entries {
        all.push(list(row)?);
    }
    list(&all)
}

/// Thrown so that something is to be seen, whatever its size and stiffness.
fn thrown<B, T, const M: usize>(kernels: B, body: &ReducedBody) -> Box<dyn Motion>
where
    T: RealField + Copy,
    B: Observables<T> + FlexibleBody<T, Modal = SVector<T, M>> + 'static,
{
    let lowest = body.modes.iter().filter_map(|mode| mode.frequency_hz).find(|frequency| *frequency > 0.0);
    let spin = lowest.map_or(RIGID_SPIN, |frequency| SPIN * std::f64::consts::TAU * frequency);
    let middle = middle_axis(&body.inertia.second_moment);
    let spin = std::array::from_fn(|axis| if axis == middle { spin } else { 2e-3 * spin });
    let length = |vector: &[f64; 3]| vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    let bent = body.markers.iter().find_map(|marker| {
        let moved = length(marker.translation.first()?);
        (moved > 0.0).then(|| BENT * length(&marker.position) / moved)
    });
    let stable = body.highest_frequency().map(|omega| 2.0 * std::f64::consts::SQRT_2 / omega);
    Box::new(Flight::tumbling(kernels, spin, bent.unwrap_or(0.0), stable))
}

/// The axis of the frame that is closest to that of middle inertia: inertia is trace less second moment.
fn middle_axis(second_moment: &[[f64; 3]; 3]) -> usize {
    let mut axes = [0, 1, 2];
    axes.sort_by(|a, b| second_moment[*a][*a].total_cmp(&second_moment[*b][*b]));
    axes[1]
}
