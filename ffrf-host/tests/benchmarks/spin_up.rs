//! The spin-up of a flexible beam: with geometric stiffness it comes back to straight, stretched as the closed form says. Without,
//! it is sound below its first bending frequency; above, it must be seen to leave its validity, and the run says so.
//!
//! Source: J. C. Simo, L. Vu-Quoc, The role of non-linear theories in transient dynamic analysis of flexible structures, J.
//! Sound Vib. 119 (1987) 487-508; the same data in ANSYS verification manual VM258.

use std::path::Path;

use ffrf_model::{
    GeometricStiffness, Inertia, Marker, Mode, ModeKind, Provenance, ReducedBody, SCHEMA_VERSION,
};

use super::run::{Run, near, run_scene, run_text, scene_text};

/// Length (m), mass per length (kg/m), EA (N), EI (N m²), ρI (kg m).
const LENGTH: f64 = 10.0;
const LINE_MASS: f64 = 1.2;
const AXIAL: f64 = 2.8e7;
const BENDING: f64 = 1.4e4;
const ROTARY: f64 = 6e-4;

/// First two roots of 1 + cos λ cosh λ = 0. Source: any table of cantilever modes.
const ROOTS: [f64; 2] = [1.875_104_068_711_961, 4.694_091_132_974_174];

/// Displacement and slope of cantilever mode `k` at x / L, with unit displacement at the tip.
fn cantilever(k: usize, x: f64) -> [f64; 2] {
    let root = ROOTS[k];
    let ratio = (root.cosh() + root.cos()) / (root.sinh() + root.sin());
    let shape = |z: f64| z.cosh() - z.cos() - ratio * (z.sinh() - z.sin());
    let slope = |z: f64| z.sinh() + z.sin() - ratio * (z.cosh() - z.cos());
    let tip = shape(root);
    [shape(root * x) / tip, slope(root * x) * root / LENGTH / tip]
}

/// Extension under centrifugal forces, with unit displacement at the tip: (3 x - x³) / 2.
fn extension(x: f64) -> f64 {
    0.5 * (3.0 * x - x * x * x)
}

/// Two modes of bending in the plane (y), one out of it (z), and the extension (x).
fn shape(mode: usize, x: f64) -> [f64; 3] {
    match mode {
        0 | 1 => [0.0, cantilever(mode, x)[0], 0.0],
        2 => [0.0, 0.0, cantilever(0, x)[0]],
        _ => [extension(x), 0.0, 0.0],
    }
}

/// ∫₀ᴸ of a function of x / L by Simpson's rule on 2000 intervals: exact to 1e-13.
fn integral(function: impl Fn(f64) -> f64) -> f64 {
    let count = 2000;
    let weight = |k: usize| match k {
        0 => 1.0,
        k if k == count => 1.0,
        k if k % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let sum: f64 = (0..=count).map(|k| weight(k) * function(k as f64 / count as f64)).sum();
    sum * LENGTH / (3 * count) as f64
}

/// Slopes of a mode across the beam, by which it turns: in y and in z.
fn turn(mode: usize, x: f64) -> [f64; 2] {
    match mode {
        0 | 1 => [cantilever(mode, x)[1], 0.0],
        2 => [0.0, cantilever(0, x)[1]],
        _ => [0.0; 2],
    }
}

/// Stress stiffness of the axial force: a pull of ρ e_x leaves ρA (L - s), one of ρ s e_x leaves ρA (L² - s²) / 2. Loads across
/// the beam leave none: they bend it, and the stresses of bending cancel in the section.
fn geometric_stiffness() -> GeometricStiffness {
    let of = |mu: usize, nu: usize, force: &dyn Fn(f64) -> f64| {
        let product = |x: f64| turn(mu, x).iter().zip(turn(nu, x)).map(|(a, b)| a * b).sum::<f64>();
        integral(|x| force(x) * product(x))
    };
    let (uniform, linear) =
        (|x: f64| LINE_MASS * LENGTH * (1.0 - x), |x: f64| 0.5 * LINE_MASS * LENGTH * LENGTH * (1.0 - x * x));
    let list = |entry: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
        (0..4).map(|mu| (0..4).map(|nu| entry(mu, nu)).collect()).collect()
    };
    let along = |load: f64| [[load, 0.0, 0.0], [0.0; 3], [0.0; 3]];
    GeometricStiffness {
        uniform_load: list(&|mu, nu| of(mu, nu, &uniform))
            .iter()
            .map(|row| row.iter().map(|load| [*load, 0.0, 0.0]).collect())
            .collect(),
        linear_load: list(&|mu, nu| of(mu, nu, &linear))
            .iter()
            .map(|row| row.iter().map(|load| along(*load)).collect())
            .collect(),
        marker_loads: Vec::new(),
    }
}

fn beam() -> ReducedBody {
    let point = |x: f64| [LENGTH * x, 0.0, 0.0];
    let moment = |a: &dyn Fn(f64) -> [f64; 3], b: &dyn Fn(f64) -> [f64; 3]| {
        let entry = |i: usize, j: usize| LINE_MASS * integral(|x| a(x)[i] * b(x)[j]);
        std::array::from_fn::<_, 3, _>(|i| std::array::from_fn::<_, 3, _>(|j| entry(i, j)))
    };
    let first = |a: &dyn Fn(f64) -> [f64; 3]| std::array::from_fn(|i| LINE_MASS * integral(|x| a(x)[i]));
    let mut second_moment = moment(&point, &point);
    second_moment[1][1] = ROTARY * LENGTH;
    second_moment[2][2] = ROTARY * LENGTH;
    let bending = |k: usize| {
        let norm = integral(|x| cantilever(k, x)[0].powi(2));
        BENDING * (ROOTS[k] / LENGTH).powi(4) * norm
    };
    let stretch = |x: f64| 1.5 * (1.0 - x * x) / LENGTH;
    let stiffness = [bending(0), bending(1), bending(0), AXIAL * integral(|x| stretch(x).powi(2))];
    let frequency = |mu: usize| {
        (stiffness[mu] / (LINE_MASS * integral(|x| shape(mu, x).iter().map(|u| u * u).sum()))).sqrt()
    };
    ReducedBody {
        schema_version: SCHEMA_VERSION,
        title: "spin-up beam of Simo and Vu-Quoc, clamped at its frame".to_owned(),
        units: "m, kg, s, N".to_owned(),
        provenance: Provenance {
            tool: "ffrf".to_owned(),
            tool_version: "0.1.0".to_owned(),
            sources: Vec::new(),
            notes: Vec::new(),
        },
        modes: (0..4)
            .map(|mu| Mode {
                kind: if mu < 3 { ModeKind::Clamped } else { ModeKind::Attachment },
                frequency_hz: (mu < 3).then(|| frequency(mu) / std::f64::consts::TAU),
            })
            .collect(),
        inertia: Inertia {
            mass: LINE_MASS * LENGTH,
            first_moment: first(&point),
            modal_first_moment: (0..4).map(|mu| first(&|x| shape(mu, x))).collect(),
            second_moment,
            position_mode_moment: (0..4).map(|mu| moment(&point, &|x| shape(mu, x))).collect(),
            mode_mode_moment: (0..4)
                .map(|mu| (0..4).map(|nu| moment(&|x| shape(mu, x), &|x| shape(nu, x))).collect())
                .collect(),
        },
        stiffness: (0..4)
            .map(|mu| (0..4).map(|nu| if mu == nu { stiffness[mu] } else { 0.0 }).collect())
            .collect(),
        damping: vec![vec![0.0; 4]; 4],
        geometric_stiffness: Some(geometric_stiffness()),
        second_order_terms: Default::default(),
        stress_markers: Vec::new(),
        section_markers: Vec::new(),
        markers: vec![Marker {
            name: "TIP".to_owned(),
            coupling: None,
            nodes: Vec::new(),
            position: point(1.0),
            translation: (0..4).map(|mu| shape(mu, 1.0)).collect(),
            rotation: (0..4)
                .map(|mu| match mu {
                    0 | 1 => [0.0, 0.0, cantilever(mu, 1.0)[1]],
                    2 => [0.0, -cantilever(0, 1.0)[1], 0.0],
                    _ => [0.0; 3],
                })
                .collect(),
        }],
    }
}

fn model_path() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/spin_up_beam.ffrf.json")
}

/// The committed model is the one of these formulas; numbers may differ by what libraries differ in the last bits.
#[test]
fn the_model_of_the_beam_is_that_of_its_formulas() {
    if std::env::var_os("FFRF_UPDATE_GOLDEN").is_some() {
        let text = serde_json::to_string_pretty(&beam()).unwrap();
        std::fs::write(model_path(), format!("{text}\n")).unwrap();
    }
    let (committed, made) = (ReducedBody::read(model_path()).unwrap(), beam());
    let numbers = |body: &ReducedBody| -> Vec<f64> {
        let inertia = &body.inertia;
        let pairs = inertia.mode_mode_moment.iter().flatten().flatten().flatten();
        let positions = inertia.position_mode_moment.iter().flatten().flatten();
        let rows = body.stiffness.iter().flatten().chain(inertia.modal_first_moment.iter().flatten());
        let marker = &body.markers[0];
        let shapes = marker.translation.iter().chain(&marker.rotation).flatten();
        let geometric = body.geometric_stiffness.as_ref().unwrap();
        let loads = geometric.uniform_load.iter().flatten().flatten();
        let loads = loads.chain(geometric.linear_load.iter().flatten().flatten().flatten());
        pairs
            .chain(loads)
            .chain(positions)
            .chain(rows)
            .chain(shapes)
            .chain(inertia.second_moment.iter().flatten())
            .copied()
            .collect()
    };
    for (committed, made) in numbers(&committed).iter().zip(numbers(&made)) {
        assert!(
            (committed - made).abs() <= 1e-11 * made.abs().max(1e-3),
            "{committed} {made}: FFRF_UPDATE_GOLDEN=1 renews it"
        );
    }
    // 3.516 √(EI / ρA L⁴) = 3.80 rad/s
    let first = ROOTS[0].powi(2) * (BENDING / (LINE_MASS * LENGTH.powi(4))).sqrt();
    near("first bending frequency", first, 3.7978, 1e-4);
}

/// How the angle of the scene begins.
const ANGLE: &str = "angle = \"0.4*(((t + 15";
/// The key of the body.
const MODEL: &str = "model = \"../spin_up_beam.ffrf.json\"";

/// The scene with another angle, without geometric stiffness.
fn unstiffened(share: f64, duration: f64) -> Run {
    let text = scene_text("spin_up_beam.toml");
    assert!(text.contains(ANGLE) && text.contains(MODEL));
    let text = text
        .replace("angle = \"", &format!("angle = \"{share}*("))
        .replace("/2))\" }", "/2)))\" }")
        .replace(MODEL, &format!("{MODEL}\nfidelity = \"unstiffened\""))
        .replace("duration = 20.0", &format!("duration = {duration:?}"));
    run_text(&text, &model_path().parent().unwrap().join("scenes"))
}

/// ρA Ω² L³ / 3 EA
fn extension_at(speed: f64) -> f64 {
    LINE_MASS * speed * speed * LENGTH.powi(3) / (3.0 * AXIAL)
}

fn largest(run: &Run, column: &str) -> f64 {
    run.column(column).iter().fold(0.0_f64, |most, q| most.max(q.abs()))
}

#[test]
fn without_stiffening_the_beam_is_sound_below_its_first_frequency() {
    let run = unstiffened(0.5, 15.0);
    assert_eq!(run.summary.spin, Vec::new());
    let speed = run.last("beam.angular_velocity.z");
    near("speed", speed, 3.0, 1e-9);
    // What the extension adds to the radius is Ω² ρA L² / EA, below 1e-4 of it; bending still swings.
    let extension = extension_at(speed);
    near("extension", run.last("beam.modal_coordinates.4"), extension, 2e-2 * extension);
    let bent = largest(&run, "beam.modal_coordinates.1");
    assert!(bent > 0.05 && bent < 1.5, "bends back by {bent} m at most");
    let out = largest(&run, "beam.modal_coordinates.3");
    assert!(out < 1e-12, "out of the plane: {out}");
}

#[test]
fn without_stiffening_the_run_above_the_first_frequency_says_that_it_means_nothing() {
    let run = unstiffened(1.0, 12.0);
    let [warning] = &run.summary.spin[..] else { panic!("{:?}", run.summary.spin) };
    eprintln!("{warning}");
    assert!(!warning.is_stiffened && warning.to_string().contains("without geometric stiffening"));
    near("critical speed", warning.critical, 3.7978, 1e-4);
    // the drive passes it between the sample before, 0.1 s earlier, and this one
    let rate = |t: f64| 0.4 * (t - 7.5 / std::f64::consts::PI * (std::f64::consts::TAU * t / 15.0).sin());
    assert!(rate(warning.time) > warning.critical && rate(warning.time - 0.11) < warning.critical);
    // and it is seen: the tip bends by more than the beam is long, where the beam of nature comes back to straight
    let bent = run.last("beam.modal_coordinates.1").abs();
    eprintln!("bends by {bent} m");
    assert!(bent > LENGTH, "{bent} m");
}

/// Above its first frequency, the beam with geometric stiffness bends back while it is spun up, as far as published, and comes
/// to the steady state of the closed form: straight, and longer by ρA Ω² L³ / 3 EA.
#[test]
fn with_stiffening_the_beam_reaches_its_closed_form_steady_state() {
    let run = run_scene("spin_up_beam.toml", &[]);
    assert_eq!(run.summary.spin, Vec::new());
    let speed = run.last("beam.angular_velocity.z");
    near("speed", speed, 6.0, 1e-9);
    let extension = extension_at(speed);
    near("closed form", extension, 5.14e-4, 1e-6);
    let late = run.column("beam.modal_coordinates.4");
    let late = &late[late.len() - 21..];
    let mean = late.iter().sum::<f64>() / late.len() as f64;
    near("extension", mean, extension, 5e-3 * extension);
    let bending = run.column("beam.modal_coordinates.1");
    let most = bending.iter().fold(0.0_f64, |most, q| most.min(*q));
    eprintln!("bends back by {most} m at most, extension {mean:e} m");
    // Simo and Vu-Quoc, figure 8: about 0.6 m at 6.5 s, two modes of bending here
    assert!((-0.65..-0.5).contains(&most), "{most} m");
    let left = bending[bending.len() - 21..].iter().fold(0.0_f64, |most, q| most.max(q.abs()));
    assert!(left < 0.01 * most.abs(), "comes back to straight but for {left} m");
}
