//! Which bodies are generated: layout, number of modes, scalar and strategy.

use ffrf_codegen::{Fidelity, GenerateOptions, ScalarType, Strategy};
use ffrf_model::ReducedBody;

use ffrf_test_kit::random_body::{Modes, random_body};

/// A body to generate.
pub struct Case {
    /// Name of its module.
    pub name: String,
    /// Its invariants.
    pub body: ReducedBody,
    /// How it is generated.
    pub options: GenerateOptions,
}

/// Numbers of modes that are timed.
pub const TIMED: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];
/// Numbers of modes at which lanes are checked: with and without padding, both kinds of table.
pub const CHECKED: [usize; 15] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 16, 17, 20, 21, 33];

/// Numbers of modes around the change-over, in lanes and in statements.
pub const CHANGE_OVER: [usize; 6] = [3, 4, 5, 6, 7, 8];

/// Numbers of modes at which bodies with a dense Θ_ff are timed, in lanes and in statements.
pub const DENSE: [usize; 6] = [3, 4, 5, 6, 8, 16];

/// Every case.
pub fn all() -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |name: String, body: ReducedBody, options: GenerateOptions| {
        cases.push(Case { name, body, options });
    };
    for modes in TIMED {
        let general = body(modes, Modes::Normalised);
        let free = body(modes, Modes::FreeFree);
        let single = GenerateOptions { scalar: ScalarType::F32, ..options() };
        add(format!("general_m{modes}"), general.clone(), options());
        add(format!("single_m{modes}"), general, single);
        add(format!("free_free_m{modes}"), free, options());
    }
    let lanes = || GenerateOptions { strategy: Strategy::Lanes, ..options() };
    for modes in CHECKED {
        add(format!("lanes_m{modes}"), body(modes, Modes::Normalised), lanes());
    }
    let statements = || GenerateOptions { strategy: Strategy::StraightLine, ..options() };
    for modes in CHANGE_OVER {
        add(format!("statements_m{modes}"), body(modes, Modes::Normalised), statements());
    }
    let dense = |modes| random_body(100 + modes as u64, modes, Modes::Random);
    for modes in DENSE {
        add(format!("statements_dense_m{modes}"), dense(modes), statements());
    }
    for modes in DENSE.into_iter().chain([9, 21]) {
        add(format!("lanes_dense_m{modes}"), dense(modes), lanes());
    }
    let single = GenerateOptions { scalar: ScalarType::F32, ..lanes() };
    add("lanes_dense_single_m9".to_owned(), dense(9), single);
    for modes in [3, 9, 21] {
        add(format!("lanes_free_free_m{modes}"), body(modes, Modes::FreeFree), lanes());
        add(format!("lanes_diagonal_m{modes}"), scaled(body(modes, Modes::Normalised)), lanes());
        let linear = GenerateOptions { fidelity: Fidelity::Linear, ..lanes() };
        add(format!("lanes_linear_m{modes}"), body(modes, Modes::Normalised), linear);
        let single = GenerateOptions { scalar: ScalarType::F32, ..lanes() };
        add(format!("lanes_single_m{modes}"), body(modes, Modes::Normalised), single);
    }
    let constant = GenerateOptions { fidelity: Fidelity::Constant, ..lanes() };
    add("lanes_constant_m6".to_owned(), body(6, Modes::Normalised), constant);
    let single = GenerateOptions { scalar: ScalarType::F32, ..lanes() };
    add("lanes_single_m28".to_owned(), body(28, Modes::Normalised), single);
    cases
}

fn options() -> GenerateOptions {
    // Orthogonal up to the rounding of a few hundred products.
    GenerateOptions { layout_tolerance: 1e-12, ..GenerateOptions::default() }
}

/// A random unsymmetric body with a diagonal modal stiffness, as eigenmodes have it.
fn body(modes: usize, kind: Modes) -> ReducedBody {
    let mut body = random_body(100 + modes as u64, modes, kind);
    for (mu, row) in body.stiffness.iter_mut().enumerate() {
        for (nu, entry) in row.iter_mut().enumerate() {
            *entry = if mu == nu { 40.0 + 7.0 * mu as f64 } else { 0.0 };
        }
    }
    body
}

/// The same body with modes of other lengths: Θ_ff is diagonal, not the identity.
fn scaled(mut body: ReducedBody) -> ReducedBody {
    let factor = |mu: usize| 1.0 + 0.125 * (mu % 5) as f64;
    let inertia = &mut body.inertia;
    for mu in 0..inertia.modal_first_moment.len() {
        inertia.modal_first_moment[mu].iter_mut().for_each(|x| *x *= factor(mu));
        inertia.position_mode_moment[mu].as_flattened_mut().iter_mut().for_each(|x| *x *= factor(mu));
        for (nu, moment) in inertia.mode_mode_moment[mu].iter_mut().enumerate() {
            moment.as_flattened_mut().iter_mut().for_each(|x| *x *= factor(mu) * factor(nu));
        }
    }
    body
}
