//! Random states for `ffrf verify`: the same for the same seed, on every machine.

use ffrf_fe::oracle::{Oracle, OracleState};

/// Largest displacement of a node, over the size of the body.
pub const DISPLACEMENT: f64 = 0.3;
/// Largest component of the angular velocity. Units: rad/s.
pub const ANGULAR_VELOCITY: f64 = 10.0;

/// Random numbers by SplitMix64 (Steele, Lea & Flood 2014).
struct Random(u64);

impl Random {
    /// A number in [-1, 1).
    fn draw(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self, amplitude: f64) -> [f64; 3] {
        [0; 3].map(|_| amplitude * self.draw())
    }
}

/// `count` states: displacements up to [`DISPLACEMENT`] of the body's size, angular velocity up to
/// [`ANGULAR_VELOCITY`], velocities up to that times the size.
///
/// The first state is undeformed, the amplitude of the others grows to the full one.
pub fn sample_states(oracle: &Oracle<'_>, count: usize, seed: u64) -> Vec<OracleState> {
    let mut random = Random(seed);
    let size = oracle.size();
    (0..count)
        .map(|index| {
            let share = if count > 1 { index as f64 / (count - 1) as f64 } else { 1.0 };
            let q = coordinates(oracle, &mut random, share * DISPLACEMENT * size);
            let q_dot = coordinates(oracle, &mut random, DISPLACEMENT * ANGULAR_VELOCITY * size);
            let velocity = random.vector(ANGULAR_VELOCITY * size);
            OracleState { q, q_dot, velocity, omega: random.vector(ANGULAR_VELOCITY) }
        })
        .collect()
}

/// Random forces whose size is that of the inertia forces of the state.
pub fn sample_forces(count: usize, scale: impl Fn(usize) -> f64, seed: u64) -> Vec<f64> {
    // Another stream than that of the states.
    let mut random = Random(!seed);
    (0..count).map(|index| scale(index) * random.draw()).collect()
}

/// Modal coordinates in which every mode takes part and no node moves farther than `displacement`.
fn coordinates(oracle: &Oracle<'_>, random: &mut Random, displacement: f64) -> Vec<f64> {
    let count = oracle.mode_count();
    let mut coordinates = vec![0.0; count];
    for mu in 0..count {
        let mut unit = vec![0.0; count];
        unit[mu] = 1.0;
        let largest = oracle.largest_displacement(&unit);
        let weight = random.draw();
        coordinates[mu] = if largest > 0.0 { weight / largest } else { 0.0 };
    }
    let largest = oracle.largest_displacement(&coordinates);
    let factor = if largest > 0.0 { displacement / largest } else { 0.0 };
    coordinates.iter().map(|coordinate| factor * coordinate).collect()
}
