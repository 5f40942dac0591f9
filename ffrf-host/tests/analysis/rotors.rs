//! Whirl of rigid rotors against the closed forms of gyroscopic motion.

use ffrf_host::analysis::{SpinFrame, SpinTarget, Whirl, campbell};

use crate::{close, scene};

const MASS: f64 = 8.0;
/// Moment of inertia about the axis, and across it.
const POLAR: f64 = 0.09;
const TRANSVERSE: f64 = 0.05;
/// From the centre of mass to each support.
const ARM: f64 = 0.2;

/// A rotor about z on two bushings that hold it across the axis with `k` (x and y) and along with 1e6 N/m.
fn rotor(k: [f64; 2], across: [f64; 2]) -> String {
    format!(
        "[simulation]\nduration = 1.0\nstep = 1e-4\n[bodies.rotor]\nmass = {MASS}\n\
         inertia = [[{}, 0.0, 0.0], [0.0, {}, 0.0], [0.0, 0.0, {POLAR}]]\nangular_velocity = [0.0, 0.0, 1.0]\n\
         markers.A = [0.0, 0.0, {}]\nmarkers.B = [0.0, 0.0, {ARM}]\n{}{}",
        across[0],
        across[1],
        -ARM,
        bushing("A", k, -ARM),
        bushing("B", k, ARM)
    )
}

fn bushing(marker: &str, k: [f64; 2], z: f64) -> String {
    format!(
        "[forces.{marker}]\nkind = \"bushing\"\nfirst = \"ground\"\nfirst_position = [0.0, 0.0, {z}]\n\
         second = \"rotor.{marker}\"\nstiffness_matrix = [{}, {}, 1e6, 0.0, 0.0, 0.0]\n",
        k[0], k[1]
    )
}

/// Frequencies (rad/s) of one whirl at one speed, rising.
fn of(points: &[ffrf_host::analysis::CampbellPoint], whirl: Whirl, speed: f64) -> Vec<f64> {
    let chosen = points.iter().filter(|point| point.speed == speed && point.whirl == whirl);
    chosen.map(|point| point.eigenvalue.im).filter(|omega| *omega > 1e-3).collect()
}

/// Eigenvalues of a few rows, some of them degenerate.
const ROUNDING: f64 = 1e-9;

#[test]
fn a_round_rotor_on_round_supports_whirls_forward_and_backward_as_the_closed_form_says() {
    let k = 4e5;
    let scene = scene(&rotor([k; 2], [TRANSVERSE; 2]));
    let speeds = [50.0, 400.0, 2000.0];
    let found = campbell(&scene, &SpinTarget::Body("rotor".into()), &speeds, None).unwrap();
    for speed in speeds {
        // I ω² - I_p Ω ω - 2 k a² = 0
        let (gyro, root) =
            (POLAR * speed, ((POLAR * speed).powi(2) + 8.0 * TRANSVERSE * k * ARM * ARM).sqrt());
        let tilt = [(root + gyro) / (2.0 * TRANSVERSE), (root - gyro) / (2.0 * TRANSVERSE)];
        let bounce = (2.0 * k / MASS).sqrt();
        for (whirl, tilt) in [(Whirl::Forward, tilt[0]), (Whirl::Backward, tilt[1])] {
            let mut found = of(&found.points, whirl, speed);
            // the bounce has two equal eigenvalues, whose directions are arbitrary
            found.retain(|omega| (omega - bounce).abs() > 1e-6 * bounce);
            assert_eq!(found.len(), 1, "{whirl:?} at {speed}: {found:?}");
            close("whirl", found[0], tilt, ROUNDING);
        }
        let all: Vec<f64> =
            found.points.iter().filter(|p| p.speed == speed).map(|p| p.eigenvalue.im).collect();
        let bounces = all.iter().filter(|omega| (*omega - bounce).abs() < ROUNDING * bounce).count();
        assert_eq!(bounces, 2, "{all:?}");
        close("axial", of(&found.points, Whirl::Axial, speed)[0], (2e6 / MASS).sqrt(), ROUNDING);
    }
}

#[test]
fn uneven_supports_need_a_round_rotor() {
    let (kx, ky, speed) = (3e5, 6e5, 700.0);
    let found = campbell(
        &scene(&rotor([kx, ky], [TRANSVERSE; 2])),
        &SpinTarget::Body("rotor".into()),
        &[speed],
        None,
    );
    let found = found.unwrap();
    assert_eq!(found.frames, [SpinFrame::Material]);
    // (2 kx a² - I ω²)(2 ky a² - I ω²) = (I_p Ω ω)²
    let (a, b, i, g) = (2.0 * kx * ARM * ARM, 2.0 * ky * ARM * ARM, TRANSVERSE, POLAR * speed);
    let (p, q) = ((a + b) * i + g * g, a * b);
    let root = (p * p - 4.0 * i * i * q).sqrt();
    let mut expected = vec![
        ((p - root) / (2.0 * i * i)).sqrt(),
        ((p + root) / (2.0 * i * i)).sqrt(),
        (2.0 * kx / MASS).sqrt(),
        (2.0 * ky / MASS).sqrt(),
        (2e6 / MASS).sqrt(),
    ];
    expected.sort_by(f64::total_cmp);
    let found: Vec<f64> =
        found.points.iter().map(|point| point.eigenvalue.im).filter(|w| *w > 1e-3).collect();
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.into_iter().zip(expected) {
        close("frequency", found, expected, ROUNDING);
    }
    // neither is round: coefficients change as it turns
    let uneven = scene(&rotor([kx, ky], [TRANSVERSE, 0.06]));
    let refused =
        campbell(&uneven, &SpinTarget::Body("rotor".into()), &[speed], None).unwrap_err().to_string();
    assert!(refused.contains("no steady rotation at 700 rad/s"), "{refused}");
    assert!(refused.contains("eigenvalues change"), "{refused}");
}

/// A point mass on a rod that a joint turns, in a spring across the rod: a mass in a groove of a turning disc.
#[test]
fn a_mass_in_a_turning_groove_feels_the_centrifugal_force() {
    let (m, k, speed) = (0.5, 2000.0_f64, 30.0_f64);
    let text = format!(
        "[simulation]\nduration = 1.0\nstep = 1e-4\n\
         [bodies.disc]\nmass = 1.0\ninertia = [[0.1,0.0,0.0],[0.0,0.1,0.0],[0.0,0.0,0.2]]\nmarkers.RIM = [0.3, 0.0, 0.0]\n\
         [bodies.mass]\nmass = {m}\ninertia = [[1e-3,0.0,0.0],[0.0,1e-3,0.0],[0.0,0.0,1e-3]]\nposition = [0.1, 0.0, 0.0]\n\
         [joints.shaft]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"disc\"\ndrive = {{ angle = [0.0, 1.0] }}\n\
         [joints.groove]\nkind = \"prismatic\"\nfirst = \"disc\"\nsecond = \"mass\"\naxis = [1.0, 0.0, 0.0]\n\
         [forces.spring]\nkind = \"spring\"\nfirst = \"disc.RIM\"\nsecond = \"mass\"\nstiffness = {k}\n"
    );
    let found = campbell(&scene(&text), &SpinTarget::Joint("shaft".into()), &[speed], None).unwrap();
    // along the groove, driven: ω² = k/m - Ω², as the disc sees it
    assert_eq!(found.frames, [SpinFrame::Space]);
    assert_eq!(found.points.len(), 1);
    assert_eq!(found.points[0].whirl, Whirl::Rotating);
    close("frequency", found.points[0].eigenvalue.im, (k / m - speed * speed).sqrt(), ROUNDING);
}

#[test]
fn both_symmetries_give_the_same_whirl() {
    let (k, speed) = (4e5, 900.0);
    let scene = scene(&rotor([k; 2], [TRANSVERSE; 2]));
    let target = SpinTarget::Body("rotor".into());
    let in_frame = |frame| campbell(&scene, &target, &[speed], Some(frame)).unwrap().points;
    let (material, space) = (in_frame(SpinFrame::Material), in_frame(SpinFrame::Space));
    assert_eq!(material.len(), space.len());
    let bounce = (2.0 * k / MASS).sqrt();
    for (a, b) in material.iter().zip(&space).filter(|(a, _)| a.eigenvalue.im > 1.0) {
        close("whirl", b.eigenvalue.im, a.eigenvalue.im, ROUNDING);
        // where two eigenvalues are equal, only the rotating frame tells their directions apart
        if (a.eigenvalue.im - bounce).abs() > ROUNDING * bounce {
            assert_eq!(a.whirl, b.whirl, "{a:?} {b:?}");
        }
    }
    assert_eq!(of(&space, Whirl::Forward, speed).len(), 2);
    assert_eq!(of(&space, Whirl::Backward, speed).len(), 2);
}
