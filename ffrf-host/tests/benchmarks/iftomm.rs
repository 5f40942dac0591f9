//! The IFToMM library of computational benchmark problems: A01 pendulum, A02 N-four-bar, A04 Bricard.
//! (A03 is the squeezer; A05 is the governor.)
//!
//! Source: M. González, D. Dopico, U. Lugrís, J. Cuadrado, A benchmarking system for MBS simulation software, Multibody
//! Syst. Dyn. 16 (2006) 179-190; <https://www.iftomm-multibody.org/benchmark>.

use super::run::{near, run_scene};

/// A02: tip of the first bar at 10 s, by Richardson extrapolation of a prototype; Exudyn's generalised-alpha at h = 5e-4,
/// 2.5e-4, 1.25e-4 s gives x = 0.3284465114, 0.3284552113, 0.3284573768, which extrapolates to it (TestModels/fourBarMechanismIftomm.py).
const FOUR_BAR_TIP: [f64; 2] = [0.32845812, 0.94451854];
/// A02 with exact equations conserves energy: what RK4 loses in 10 s goes with h⁴, 1.1e-8 J at 2 ms.
const FOUR_BAR_ENERGY: f64 = 2e-8;

#[test]
fn the_four_bar_passes_its_singular_position() {
    let run = run_scene("four_bar.toml", &[]);
    let tip = run.last_vector("tip");
    // the reference has eight digits
    near("tip x", tip.x, FOUR_BAR_TIP[0], 1e-7);
    near("tip y", tip.y, FOUR_BAR_TIP[1], 1e-7);
    near("energy", run.energy_error(), 0.0, FOUR_BAR_ENERGY);
    // it does not tear open where it could
    let [position, velocity] = run.drift();
    assert!(position < 1e-12 && velocity < 1e-11, "{position:e}, {velocity:e}");
    // it lies in one line on its way, more than once
    let heights = run.column("tip.y");
    let passes = heights.windows(2).filter(|pair| pair[0] * pair[1] <= 0.0).count();
    assert!(passes >= 4, "{passes}");
    // and the bars of both windows stay parallel: it never takes the other way
    let [left, right] = ["left", "right"].map(|name| run.column(&format!("{name}.orientation.z")));
    assert!(left.iter().zip(&right).all(|(a, b)| (a.abs() - b.abs()).abs() < 1e-9));
}

/// A04: end of the third rod at 1 s with Exudyn 1.13.6, generalised-alpha with 1 ms.
const BRICARD_END: [f64; 3] = [0.5105015, -1.6491676, 0.1401231];
/// Second-order method with 1 ms: its own error of position, by its convergence in the four-bar (1e-5 of 1 m and less).
const BRICARD: f64 = 1e-5;

#[test]
fn bricards_mechanism_moves_with_its_redundant_row() {
    let run = run_scene("bricard.toml", &[("duration = 10.0", "duration = 1.0")]);
    let end = run.last_vector("end_of_third");
    for (axis, (found, expected)) in end.iter().zip(BRICARD_END).enumerate() {
        near(["x", "y", "z"][axis], *found, expected, BRICARD);
    }
    // conserved over 10 s, through every position of its cycle
    let run = run_scene("bricard.toml", &[]);
    let [position, velocity] = run.drift();
    eprintln!("energy {:e} J, drift {position:e}, {velocity:e}", run.energy_error());
    assert!(position < 1e-12 && velocity < 1e-11, "{position:e}, {velocity:e}");
    near("energy", run.energy_error(), 0.0, 1e-5);
}
