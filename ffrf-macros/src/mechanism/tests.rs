//! Code of mechanisms, committed, and what must hold for it.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use proc_macro2::TokenStream;
use quote::quote;

use super::mechanism;

/// Set to rewrite the committed files.
const UPDATE: &str = "FFRF_UPDATE_GOLDEN";

fn pendulum() -> TokenStream {
    quote! {
        /// A flexible pendulum.
        pub struct Pendulum {
            bodies: { beam: Beam },
            gravity: [0.0, 0.0, -9.81],
            joints: { pin: revolute(ground, beam.ROOT, axis: y) },
            sensors: { tip: position(beam.TIP), load: reaction_force(pin) },
            accelerations: printed::accelerations,
        }
    }
}

fn slider_crank() -> TokenStream {
    quote! {
        /// A slider-crank with a flexible rod, in any number type.
        pub struct SliderCrank {
            bodies: {
                crank: rigid { mass: 0.5, inertia: [2e-4, 4e-4, 5e-4], markers: { PIN: [0.04, 0.0, 0.0] } },
                rod: Rod,
                piston: rigid Piston,
                links: [Rod; 3],
            },
            joints: {
                main: revolute(ground, crank, axis: z),
                big_end: revolute(crank.PIN, rod.BIG_END, axis: z),
                small_end: spherical(rod.SMALL_END, piston.PIN),
                guide: prismatic(ground, piston.PIN, axis: x),
                root: revolute(ground.at([1.0, 0.0, 0.0]), links[0].BIG_END, axis: z),
                hinges: for i in 0..2 { universal(links[i].SMALL_END, links[i + 1].BIG_END, axis: x) },
            },
            drives: { motor: angle(main, polynomial: [0.0, 100.0]) },
            forces: { brake: torsion_spring(big_end, stiffness: 0.0, damping: 1e-3) },
            sensors: { turn: angle(main), bearing: reaction_moment(main), shock: acceleration(piston) },
            scalar: generic,
        }
    }
}

/// The code as people read it.
fn formatted(tokens: &TokenStream) -> String {
    let mut child = Command::new("rustfmt")
        .args(["--edition", "2024", "--config", "max_width=110"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(tokens.to_string().as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "rustfmt refuses the code: {tokens}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn committed_code_is_what_the_macro_expands_to() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/golden");
    let mut stale = Vec::new();
    for (name, input) in [("pendulum_mechanism", pendulum()), ("slider_crank_mechanism", slider_crank())] {
        let tokens = mechanism(input.clone());
        assert_eq!(tokens.to_string(), mechanism(input).to_string(), "the same input, the same code");
        let text = format!(
            "//! Code of a mechanism, committed: see ffrf-macros/src/mechanism/tests.rs.\n\n{}",
            formatted(&tokens)
        );
        let path = folder.join(format!("{name}.rs"));
        if std::fs::read_to_string(&path).unwrap_or_default() != text {
            stale.push(name);
            if std::env::var_os(UPDATE).is_some() {
                std::fs::write(&path, text).unwrap();
            }
        }
    }
    assert!(
        stale.is_empty(),
        "stale: {stale:?}; run `{UPDATE}=1 cargo test -p ffrf-macros` and read the difference"
    );
}

#[test]
fn every_mistake_is_reported_and_the_struct_stays() {
    let tokens = mechanism(quote! {
        pub struct Pendulum {
            bodies: { bar: rigid { mass: 1.0, inertia: [1.0, 1.0, 1.0] } },
            joints: { pin: hinge(ground, bar), other: revolute(ground, rod) },
        }
    })
    .to_string();
    assert!(tokens.contains("unknown kind of joint `hinge`"), "{tokens}");
    assert!(tokens.contains("there is no body `rod`"), "{tokens}");
    assert!(tokens.contains("pub struct Pendulum ;"), "{tokens}");
}
