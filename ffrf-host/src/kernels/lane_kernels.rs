//! The loops over lanes of the runtime, run over the tables of a body that was read a moment ago.
//!
//! Generated code gives the number of modes to the loops when it is compiled. Here every number of groups of four
//! modes up to [`LARGEST`] / 4 is compiled in, and the last group is padded with zeros as in the generated tables,
//! so that the same operations are done on the same numbers.

use ffrf_codegen::lanes::{LaneTables, MomentTables};
use ffrf_runtime::lanes::{LaneBody, PortableTable, State, on_registers};

use super::Bodies;

/// Largest number of modes.
pub const LARGEST: usize = 64;

/// The kernels that are loops, for any number of modes.
pub trait LaneKernels {
    /// Mass matrix. Shape: N x N.
    fn mass_matrix(&self, q: &[f64]) -> Vec<Vec<f64>>;
    /// Quadratic velocity vector. Shape: N.
    fn quadratic_velocity(&self, q: &[f64], omega: [f64; 3], q_dot: &[f64]) -> Vec<f64>;
    /// Accelerations under `force`, elastic and damping forces included. Shape: N.
    fn forward_dynamics(&self, q: &[f64], omega: [f64; 3], q_dot: &[f64], force: &[f64]) -> Vec<f64>;
    /// Kinetic energy. Units: J.
    fn kinetic_energy(&self, q: &[f64], velocity: [f64; 3], omega: [f64; 3], q_dot: &[f64]) -> f64;
    /// Angular momentum about the frame origin. Shape: 3. Units: N m s.
    fn angular_momentum(&self, q: &[f64], velocity: [f64; 3], omega: [f64; 3], q_dot: &[f64]) -> [f64; 3];
}

/// The loops for these tables, `None` for more than [`LARGEST`] modes.
pub fn lane_kernels(tables: &LaneTables) -> Option<Box<dyn LaneKernels>> {
    // modes, velocities, groups, then pairs and single groups or tiles below the diagonal
    Some(match (tables.groups, &tables.moments) {
        (1, MomentTables::Whole { .. } | MomentTables::None) => whole::<4, 10, 1, 0, 1>(tables),
        (2, MomentTables::Whole { .. } | MomentTables::None) => whole::<8, 14, 2, 1, 0>(tables),
        (3, MomentTables::Whole { .. } | MomentTables::None) => whole::<12, 18, 3, 1, 1>(tables),
        (4, MomentTables::Whole { .. } | MomentTables::None) => whole::<16, 22, 4, 2, 0>(tables),
        (5, MomentTables::Whole { .. } | MomentTables::None) => whole::<20, 26, 5, 2, 1>(tables),
        (5, _) => half::<20, 26, 5, 80>(tables),
        (6, _) => half::<24, 30, 6, 120>(tables),
        (7, _) => half::<28, 34, 7, 168>(tables),
        (8, _) => half::<32, 38, 8, 224>(tables),
        (9, _) => half::<36, 42, 9, 288>(tables),
        (10, _) => half::<40, 46, 10, 360>(tables),
        (11, _) => half::<44, 50, 11, 440>(tables),
        (12, _) => half::<48, 54, 12, 528>(tables),
        (13, _) => half::<52, 58, 13, 624>(tables),
        (14, _) => half::<56, 62, 14, 728>(tables),
        (15, _) => half::<60, 66, 15, 840>(tables),
        (16, _) => half::<64, 70, 16, 960>(tables),
        _ => return None,
    })
}

fn whole<const M: usize, const N: usize, const G: usize, const PAIRS: usize, const SINGLE: usize>(
    tables: &LaneTables,
) -> Box<dyn LaneKernels> {
    let bodies = Bodies { zero: 0.0, constant: |number: f64| number };
    let moments = bodies.whole::<f64, M, PAIRS, SINGLE>(tables);
    Box::new(Loops::<M, N, G, _> { modes: tables.modes, body: bodies.body(tables, moments) })
}

fn half<const M: usize, const N: usize, const G: usize, const TILES: usize>(
    tables: &LaneTables,
) -> Box<dyn LaneKernels> {
    let bodies = Bodies { zero: 0.0, constant: |number: f64| number };
    let moments = bodies.half::<f64, 4, G, TILES>(tables);
    Box::new(Loops::<M, N, G, _> { modes: tables.modes, body: bodies.body(tables, moments) })
}

/// A body and its loops.
struct Loops<const M: usize, const N: usize, const G: usize, P: 'static> {
    modes: usize,
    body: LaneBody<'static, f64, M, G, P>,
}

/// The numbers, padded with zero.
fn padded<const K: usize>(numbers: &[f64]) -> [f64; K] {
    let mut padded = [0.0; K];
    for (place, number) in padded.iter_mut().zip(numbers) {
        *place = *number;
    }
    padded
}

impl<const M: usize, const N: usize, const G: usize, P: PortableTable<f64, M, G>> Loops<M, N, G, P> {
    #[inline(never)]
    fn state(&self, q: &[f64], omega: [f64; 3], q_dot: &[f64]) -> State<f64, G> {
        on_registers!(registers => self.body.on(registers).state(&padded(q), omega, &padded(q_dot)))
    }

    fn without_padding(&self, numbers: [f64; N]) -> Vec<f64> {
        numbers.into_iter().take(6 + self.modes).collect()
    }
}

impl<const M: usize, const N: usize, const G: usize, P: PortableTable<f64, M, G>> LaneKernels
    for Loops<M, N, G, P>
{
    fn mass_matrix(&self, q: &[f64]) -> Vec<Vec<f64>> {
        let state = self.state(q, [0.0; 3], &[]);
        let columns: [[f64; N]; N] = on_registers!(registers => self.body.on(registers).mass_matrix(&state));
        columns.into_iter().take(6 + self.modes).map(|column| self.without_padding(column)).collect()
    }

    fn quadratic_velocity(&self, q: &[f64], omega: [f64; 3], q_dot: &[f64]) -> Vec<f64> {
        let state = self.state(q, omega, q_dot);
        self.without_padding(self.body.quadratic_velocity(&state))
    }

    fn forward_dynamics(&self, q: &[f64], omega: [f64; 3], q_dot: &[f64], force: &[f64]) -> Vec<f64> {
        let state = self.state(q, omega, q_dot);
        let (q, q_dot, force) = (padded(q), padded(q_dot), padded(force));
        self.without_padding(on_registers!(registers => {
            self.body.on(registers).forward_dynamics(&state, &q, &q_dot, &force)
        }))
    }

    fn kinetic_energy(&self, q: &[f64], velocity: [f64; 3], omega: [f64; 3], q_dot: &[f64]) -> f64 {
        let state = self.state(q, omega, q_dot);
        on_registers!(registers => {
            self.body.on(registers).kinetic_energy(&state, &velocity, &omega, &padded(q_dot))
        })
    }

    fn angular_momentum(&self, q: &[f64], velocity: [f64; 3], omega: [f64; 3], q_dot: &[f64]) -> [f64; 3] {
        let state = self.state(q, omega, q_dot);
        on_registers!(registers => self.body.on(registers).angular_momentum(&state, &velocity, &omega))
    }
}
