//! Each misprint of Section 8 put back into the equations of motion: what it does to a free body.
//!
//! `cargo test -p ffrf-fe --test equations misprints -- --nocapture` prints the table of `docs/theory/errata.md`.

use faer::Mat;
use faer::linalg::solvers::Solve;
use ffrf_fe::formulations::gcms::apply_mass;
use ffrf_fe::formulations::rotation::{cross, dot, skew};

use crate::bodies::{Body, State, each_state};
use crate::check::{as_vector, column, largest, scaled};
use crate::nodal;
use crate::s7_inertia::{inertia_of, inertia_printed, inertia_vector};
use crate::s7_projection::{deformed_moment, modal_mass, modal_moments};

/// What is printed wrongly; the default is all corrected.
#[derive(Clone, Copy, Default)]
struct Print {
    /// + m r̃ in M_tr, (163), (203).
    plus_lever: bool,
    /// r = a - q b, (204).
    minus_modes: bool,
    /// 2 q Θ_μ, (204).
    twice_theta: bool,
    /// tr T I - T, (207).
    transposed_theta: bool,
    /// Θ_μν in Θ_μ^d, (205).
    order: bool,
    /// + ω·ϑ_μν in L_ff, (209).
    sign_of_l_ff: bool,
    /// ax without one half, (78), used in (208).
    double_vector: bool,
    /// ω × Θ ω, (175), first form.
    undeformed: bool,
}

const VARIANTS: [(&str, Print); 12] = {
    const NONE: Print = Print {
        plus_lever: false,
        minus_modes: false,
        twice_theta: false,
        transposed_theta: false,
        order: false,
        sign_of_l_ff: false,
        double_vector: false,
        undeformed: false,
    };
    [
        ("all corrected", NONE),
        ("(163), (203): + m r̃", Print { plus_lever: true, ..NONE }),
        ("(204): r = a - q b", Print { minus_modes: true, ..NONE }),
        ("(163) and (204) together", Print { plus_lever: true, minus_modes: true, ..NONE }),
        ("(204), (205): 2 q Θ_μ", Print { twice_theta: true, ..NONE }),
        ("(207): tr T I - T, order corrected", Print { transposed_theta: true, ..NONE }),
        ("(205): Θ_μν for Θ_νμ", Print { order: true, ..NONE }),
        ("(205) and (207) together", Print { transposed_theta: true, order: true, ..NONE }),
        ("(209): sign of L_ff", Print { sign_of_l_ff: true, ..NONE }),
        ("(78) without ½ in (208)", Print { double_vector: true, ..NONE }),
        ("(175): Θ for Θ_rr", Print { undeformed: true, ..NONE }),
        (
            "Section 8 as printed",
            Print {
                plus_lever: true,
                minus_modes: true,
                twice_theta: true,
                transposed_theta: true,
                order: true,
                sign_of_l_ff: true,
                ..NONE
            },
        ),
    ]
};

impl Print {
    fn tensor(self, t: &Mat<f64>) -> Mat<f64> {
        if self.transposed_theta { inertia_printed(t) } else { inertia_of(t) }
    }

    fn vector(self, t: &Mat<f64>) -> Mat<f64> {
        scaled(if self.double_vector { 2.0 } else { 1.0 }, &inertia_vector(t))
    }

    fn lever(self, body: &Body, state: &State) -> Mat<f64> {
        &state.a * deformed_moment(body, state, if self.minus_modes { -1.0 } else { 1.0 })
    }

    fn inertia(self, body: &Body, state: &State) -> Mat<f64> {
        let mut theta = inertia_of(&body.t());
        for mu in 0..body.mode_count() {
            let single = self.tensor(&body.t_mu(mu));
            let mirrored = if self.twice_theta { single.clone() } else { single.transpose().to_owned() };
            theta += scaled(state.q[mu], &(single + mirrored));
            for nu in 0..body.mode_count() {
                theta += scaled(state.q[mu] * state.q[nu], &self.tensor(&body.t_munu(mu, nu)));
            }
        }
        state.rotate(&theta)
    }

    fn mass_matrix(self, body: &Body, state: &State) -> Mat<f64> {
        let modes = body.mode_count();
        let lever =
            scaled(if self.plus_lever { 1.0 } else { -1.0 }, &skew(as_vector(&self.lever(body, state))));
        let mut coupling = Mat::zeros(3, modes);
        for mu in 0..modes {
            let mut vector = self.vector(&body.t_mu(mu));
            for nu in 0..modes {
                vector += scaled(state.q[nu], &self.vector(&body.t_munu(nu, mu)));
            }
            coupling.as_mut().submatrix_mut(0, mu, 3, 1).copy_from(&state.a * vector);
        }
        let mut mass = Mat::zeros(6 + modes, 6 + modes);
        for (row, col, content) in [
            (0, 0, scaled(body.m(), &Mat::identity(3, 3))),
            (0, 3, lever),
            (0, 6, &state.a * modal_moments(body)),
            (3, 6, coupling),
            (6, 6, modal_mass(body)),
        ] {
            let (rows, columns) = (content.nrows(), content.ncols());
            mass.as_mut().submatrix_mut(row, col, rows, columns).copy_from(&content);
            mass.as_mut().submatrix_mut(col, row, columns, rows).copy_from(content.transpose());
        }
        mass.as_mut().submatrix_mut(3, 3, 3, 3).copy_from(self.inertia(body, state));
        mass
    }

    fn gyroscopic(self, body: &Body, state: &State) -> Mat<f64> {
        let modes = body.mode_count();
        let omega = skew(as_vector(&state.omega));
        let b_rate = &state.a * modal_moments(body) * column(&state.q_dot);
        let t = &omega * &omega * self.lever(body, state) + scaled(2.0, &(&omega * b_rate));
        let theta =
            if self.undeformed { state.rotate(&inertia_of(&body.t())) } else { self.inertia(body, state) };
        let mut r = &omega * theta * &state.omega;
        let mut forces = Mat::zeros(6 + modes, 1);
        for mu in 0..modes {
            let mut coupling = self.tensor(&body.t_mu(mu));
            let mut coriolis = 0.0;
            for nu in 0..modes {
                let pair = if self.order { body.t_munu(mu, nu) } else { body.t_munu(nu, mu) };
                coupling += scaled(state.q[nu], &self.tensor(&pair));
                let vector = &state.a * self.vector(&body.t_munu(mu, nu));
                let l_ff = -dot(as_vector(&state.omega), as_vector(&vector));
                coriolis += 2.0 * state.q_dot[nu] * if self.sign_of_l_ff { -l_ff } else { l_ff };
            }
            let momentum = state.rotate(&coupling) * &state.omega;
            r += scaled(2.0 * state.q_dot[mu], &momentum);
            forces[(6 + mu, 0)] = coriolis - dot(as_vector(&momentum), as_vector(&state.omega));
        }
        forces.as_mut().submatrix_mut(0, 0, 3, 1).copy_from(t);
        forces.as_mut().submatrix_mut(3, 0, 3, 1).copy_from(r);
        forces
    }
}

/// Defects of a free body that moves by the given equations, each relative to the sum of its nodal contributions.
#[derive(Clone, Copy, Default)]
struct Defects {
    acceleration: f64,
    momentum: f64,
    angular_momentum: f64,
    energy: f64,
    lowest_eigenvalue: f64,
}

fn defects(print: Print, body: &Body, state: &State) -> Defects {
    let modes = body.mode_count();
    let elastic = Mat::from_fn(6 + modes, 1, |i, _| match i {
        6.. => {
            let force = body.shapes.transpose() * (&body.stiffness * (&body.shapes * column(&state.q)));
            force[(i - 6, 0)]
        }
        _ => 0.0,
    });
    let solve = |mass: &Mat<f64>, gyroscopic: &Mat<f64>| {
        mass.partial_piv_lu().solve(scaled(-1.0, &(gyroscopic + &elastic)))
    };
    let truth_mass = nodal::mass_matrix(body, state);
    let truth = solve(&truth_mass, &nodal::gyroscopic(body, state));
    let mass = print.mass_matrix(body, state);
    let found = solve(&mass, &print.gyroscopic(body, state));
    // Exact nodal accelerations, forces and velocities that the found accelerations mean.
    let jacobian = nodal::jacobian(body, state);
    let omega = as_vector(&state.omega);
    let velocities = {
        let mut w = vec![0.3, -0.2, 0.5];
        w.extend(omega);
        w.extend(&state.q_dot);
        &jacobian * column(&w)
    };
    let mut accelerations = &jacobian * &found;
    for node in 0..body.positions.len() {
        let lever = as_vector(&nodal::lever(body, state, node));
        let relative = as_vector(&nodal::relative_velocity(body, state, node));
        let (centripetal, coriolis) = (cross(omega, cross(omega, lever)), cross(omega, relative));
        for i in 0..3 {
            accelerations[(3 * node + i, 0)] += centripetal[i] + 2.0 * coriolis[i];
        }
    }
    let forces = apply_mass(&body.mass, accelerations.as_ref());
    let at = |of: &Mat<f64>, node: usize| [0, 1, 2].map(|i| of[(3 * node + i, 0)]);
    let length = |v: [f64; 3]| dot(v, v).sqrt();
    let (mut sums, mut sizes) = (([0.0; 3], [0.0; 3], 0.0), [0.0; 3]);
    for node in 0..body.positions.len() {
        let force = at(&forces, node);
        let moment = cross(as_vector(&nodal::lever(body, state, node)), force);
        let power = dot(at(&velocities, node), force);
        for i in 0..3 {
            sums.0[i] += force[i];
            sums.1[i] += moment[i];
        }
        sums.2 += power;
        sizes = [sizes[0] + length(force), sizes[1] + length(moment), sizes[2] + power.abs()];
    }
    sums.2 += (0..modes).map(|mu| state.q_dot[mu] * elastic[(6 + mu, 0)]).sum::<f64>();
    let symmetric = Mat::from_fn(6 + modes, 6 + modes, |i, j| 0.5 * (mass[(i, j)] + mass[(j, i)]));
    let lowest = |m: &Mat<f64>| m.self_adjoint_eigenvalues(faer::Side::Lower).expect("eigenvalues")[0];
    Defects {
        acceleration: largest(&(&found - &truth)) / largest(&truth),
        momentum: length(sums.0) / sizes[0],
        angular_momentum: length(sums.1) / sizes[1],
        energy: sums.2.abs() / sizes[2],
        lowest_eigenvalue: lowest(&symmetric) / lowest(&truth_mass),
    }
}

/// Largest defects over the random bodies with more than one mode.
fn worst(print: Print) -> Defects {
    let mut worst = Defects { lowest_eigenvalue: f64::INFINITY, ..Defects::default() };
    each_state(|body, state| {
        if body.name.starts_with("random") && body.mode_count() > 1 {
            let found = defects(print, body, state);
            worst = Defects {
                acceleration: worst.acceleration.max(found.acceleration),
                momentum: worst.momentum.max(found.momentum),
                angular_momentum: worst.angular_momentum.max(found.angular_momentum),
                energy: worst.energy.max(found.energy),
                lowest_eigenvalue: worst.lowest_eigenvalue.min(found.lowest_eigenvalue),
            };
        }
    });
    worst
}

#[test]
fn misprints_of_section_8_and_what_they_do() {
    let table: Vec<_> = VARIANTS.iter().map(|(name, print)| (name, worst(*print))).collect();
    println!("| variant | accelerations | momentum | angular momentum | energy | least eigenvalue |");
    for (name, d) in &table {
        println!(
            "| {name} | {:.1e} | {:.0e} | {:.0e} | {:.0e} | {:.2} |",
            d.acceleration, d.momentum, d.angular_momentum, d.energy, d.lowest_eigenvalue
        );
    }
    let corrected = table[0].1;
    for defect in [corrected.momentum, corrected.angular_momentum, corrected.energy] {
        assert!(defect < 1e-12, "the corrected equations conserve: {defect:e}");
    }
    assert!(corrected.acceleration < 1e-11, "{:e}", corrected.acceleration);
    for (name, d) in &table[1..] {
        assert!(d.acceleration > 1e-2, "{name} shows in the accelerations");
    }
    // The sign of L_ff is invisible to every conservation law: only accelerations show it.
    let (_, sign) = table.iter().find(|(name, _)| name.contains("L_ff")).expect("in the table");
    assert!(sign.momentum < 1e-12 && sign.angular_momentum < 1e-12 && sign.energy < 1e-12);
}
