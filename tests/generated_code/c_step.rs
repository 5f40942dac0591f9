//! Whole steps of free bodies in C against the same steps in Rust.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::fmt::Write as _;

use ffrf::nalgebra::{Quaternion, RealField, SVector, UnitQuaternion, Vector3};
use ffrf::{FlexibleBody, FreeBody, Gravity};
use ffrf_codegen::{GeneratedC, generate_c};

use crate::bodies::all;
use crate::c_program::{last_places, printed};
use crate::{general_m2, rigid, single_m3};

/// Steps that are compared.
const STEPS: usize = 200;
/// What C may differ by from Rust after each of them, in units in the last place of the largest number of the state. Both do
/// the same operations in the same order, but for those of products of quaternions and vectors in nalgebra. Each step adds
/// some round-off of its own, which the motion of these bodies does not magnify.
const LAST_PLACES: f64 = 1.0;

/// A state of M modes as numbers: position, orientation, q, velocity, omega, q_dot.
fn start(modes: usize) -> Vec<f64> {
    let mut list = vec![0.25, -0.5, 1.0, 0.5, 0.5, -0.5, 0.5];
    list.extend((0..modes).map(|k| 0.0625 * (k as f64 - 0.75)));
    list.extend([1.0, 0.5, -2.0, 0.75, -1.5, 0.25]);
    list.extend((0..modes).map(|k| 0.125 - 0.25 * k as f64));
    list
}

/// Units: m/s².
const GRAVITY: [f64; 3] = [0.5, -9.75, 1.0];

/// The states of the same steps in Rust, exact as doubles.
fn in_rust<B, T, const M: usize>(body: B, step: f64) -> Vec<Vec<f64>>
where
    T: RealField + Copy + Into<f64>,
    B: FlexibleBody<T, Modal = SVector<T, M>>,
{
    let number = |x: f64| ffrf::nalgebra::convert::<f64, T>(x);
    let mut free = FreeBody::new(body);
    free.state.set_numbers(&mut start(M).into_iter().map(number));
    let [w, x, y, z] = [0.5, 0.5, -0.5, 0.5].map(number);
    free.state.orientation = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    let gravity = Gravity { acceleration: Vector3::from(GRAVITY.map(number)) };
    (0..STEPS)
        .map(|_| {
            free.step_rk4(number(step), &gravity).unwrap();
            free.state.numbers().map(Into::into).collect()
        })
        .collect()
}

/// A program that steps and prints every state to its last bit, once it has seen what is refused.
fn program(code: &GeneratedC, modes: usize, single: bool, step: f64) -> String {
    let (prefix, kind) = (&code.prefix, if single { "float" } else { "double" });
    let list = |numbers: &[f64]| {
        let numbers: Vec<String> = numbers.iter().map(|x| format!("({kind}){x:?}")).collect();
        format!("{{{}}}", numbers.join(", "))
    };
    let all = start(modes);
    let mut fields = vec![list(&all[..3]), list(&all[3..7])];
    if modes > 0 {
        fields.push(list(&all[7..7 + modes]));
    }
    fields.extend([list(&all[7 + modes..10 + modes]), list(&all[10 + modes..13 + modes])]);
    if modes > 0 {
        fields.push(list(&all[13 + modes..]));
    }
    let mut text = format!(
        "#include \"{prefix}.h\"\n#include <stdio.h>\n#include <string.h>\n\nint main(void)\n{{\n    const {kind} gravity[3] = {};\n    \
         {prefix}_state state = {{{}}};\n    {prefix}_state before = state;\n    {kind} wrong = 0;\n    int k;\n    int n;\n",
        list(&GRAVITY),
        fields.join(", ")
    );
    let _ = write!(
        text,
        "    if ({prefix}_step_rk4(gravity, ({kind})0, &state) != 0) {{ return 2; }}\n    \
         if ({prefix}_step_rk4(gravity, -({kind})1, &state) != 0) {{ return 3; }}\n    \
         wrong = ({kind})1 / wrong;\n    \
         if ({prefix}_step_rk4(gravity, wrong, &state) != 0) {{ return 4; }}\n    \
         if (memcmp(&state, &before, sizeof state) != 0) {{ return 5; }}\n    \
         before.velocity[1] = wrong - wrong;\n    \
         if ({prefix}_step_rk4(gravity, ({kind}){step:?}, &before) != 0) {{ return 6; }}\n    \
         for (n = 0; n < {STEPS}; n++) {{\n        \
         if ({prefix}_step_rk4(gravity, ({kind}){step:?}, &state) != 1) {{ return 7; }}\n"
    );
    let mut show = |field: &str, count: usize| {
        if count > 0 {
            let _ = writeln!(
                text,
                "        for (k = 0; k < {count}; k++) {{ printf(\"%.17g \", (double)state.{field}[k]); }}"
            );
        }
    };
    show("position", 3);
    show("orientation", 4);
    show("q", modes);
    show("velocity", 3);
    show("omega", 3);
    show("q_dot", modes);
    text.push_str("        printf(\"\\n\");\n    }\n    return 0;\n}\n");
    text
}

fn compare(name: &str, modes: usize, epsilon: f64, step: f64, expected: &[Vec<f64>]) {
    let (_, body, options) = all().into_iter().find(|(known, ..)| *known == name).unwrap();
    let code = generate_c(&body, &options).unwrap();
    let program = program(&code, modes, epsilon > f64::EPSILON, step);
    let Some(found) = printed(&code.prefix, [&code.header, &code.source, &code.single], &program) else {
        return;
    };
    assert_eq!(found.len(), STEPS);
    let mut worst = 0.0_f64;
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        let places = last_places(found, expected, epsilon);
        assert!(places.is_finite());
        worst = worst.max(places / (index + 1) as f64);
    }
    eprintln!("{name}: at most {worst:.3} units in the last place a step");
    assert!(worst <= LAST_PLACES, "{name}: {worst} units in the last place a step");
    let moved = expected[STEPS - 1].iter().zip(&expected[0]).any(|(a, b)| (a - b).abs() > 0.01);
    assert!(moved, "{name} stands still");
}

#[test]
fn steps_in_c_are_those_of_rust() {
    let step = 1.0 / 1024.0;
    let single = f64::from(f32::EPSILON);
    compare("general_m2", 2, f64::EPSILON, step, &in_rust::<_, f64, 2>(general_m2::GeneralBody, step));
    compare("single_m3", 3, single, step, &in_rust::<_, f32, 3>(single_m3::SingleBody, step));
    compare("rigid", 0, f64::EPSILON, step, &in_rust::<_, f64, 0>(rigid::RigidBody, step));
}
