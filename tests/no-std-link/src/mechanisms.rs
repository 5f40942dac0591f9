//! Mechanisms of `mechanism!`: a chain that is a tree, and a driven slider-crank whose loop has redundant rows.

use ffrf::mechanism::{Assembly, Constrained, Mechanism, Treatment};
use ffrf::nalgebra::Vector3;
use ffrf::{
    EnergyMomentum, GeneralisedAlpha, Wrench, flexible_body, mechanism, step_dormand_prince, step_exponential,
    step_linearly_implicit_euler, step_symplectic_euler,
};

flexible_body! {
    /// The steel connecting rod of `models/conrod`.
    pub struct Rod { model: "../../models/conrod.ffrf.json", modes: ..4 }
}

/// Where the rod's big end is from its frame. Units: m.
const BIG_END: f64 = -0.04740099151709372;
/// Where its small end is.
const SMALL_END: f64 = 0.10225900184225423;

mechanism! {
    /// A crank, a flexible rod, a piston.
    pub struct SliderCrank {
        bodies: {
            crank: rigid {
                mass: 0.5,
                center_of_mass: [0.01, 0.0, 0.0],
                inertia: [2e-4, 4e-4, 5e-4],
                markers: { PIN: [0.04, 0.0, 0.0] },
            },
            rod: Rod,
            piston: rigid { mass: 0.3, inertia: [1e-4, 1e-4, 1e-4] },
        },
        gravity: [0.0, 0.0, -9.81],
        joints: {
            main: revolute(ground, crank, axis: z),
            big_end: revolute(crank.PIN, rod.BIG_END, axis: z),
            small_end: spherical(rod.SMALL_END, piston),
            guide: prismatic(ground, piston, axis: x),
        },
        drives: { motor: angle(main, polynomial: [0.0, 100.0]) },
        controls: { lift: 0.1 },
        forces: {
            coil: torsion_spring(big_end, stiffness: 1.0, damping: 0.01),
            rub: friction(guide, coefficient: 0.1, speed: 0.1),
            own: user(|model, _, ports| {
                let wrench = Wrench { force: Vector3::z() * model.lift, moment: Vector3::zeros() };
                ports.rod.push_at(&Rod::SMALL_END, &wrench);
            }),
        },
        sensors: { stroke: position(piston), bearing: reaction_force(main), turn: angle(main) },
    }
}

mechanism! {
    /// Three rods in a row.
    pub struct Chain {
        bodies: { links: [Rod; 3] },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            first: revolute(ground, links[0].BIG_END, axis: z),
            hinges: for i in 0..2 { revolute(links[i].SMALL_END, links[i + 1].BIG_END, axis: z) },
        },
        forces: {
            wind: force(links[2].SMALL_END, value: [0.1, 0.0, 0.0]),
            bearings: for i in 0..2 { friction(hinges[i], coefficient: 0.1, radius: 0.01, speed: 1.0) },
        },
        sensors: { turns: for i in 0..2 { angle(hinges[i]) }, end: position(links[2].SMALL_END), shock: acceleration(links[2].SMALL_END) },
    }
}

/// Every integrator takes steps, joints stay met, saved states come back.
pub fn they_move() -> bool {
    let model = SliderCrank::new(Rod);
    let mut state = model.at_rest();
    state.rod.position.x = 0.04 - BIG_END;
    state.piston.position.x = 0.04 - BIG_END + SMALL_END;
    let mut crank = model.met_in(&state).in_motion(state);
    if crank.assemble().is_err() || !every_integrator(&mut crank, 2e-6) {
        return false;
    }
    let mut iterated = crank;
    iterated.model.treatment = Treatment::Index3;
    let iterating = implicit_methods(&mut iterated, 2e-6);
    let restored = model.state_from_array(&crank.state.to_array());
    let turned = (model.turn(&crank.state) - 100.0 * crank.time).abs() < 1e-9;
    let pulled = model.bearing(crank.time, &crank.state).is_ok_and(|force| force.norm() > 1.0);
    let chain = Chain::new([Rod; 3]);
    let mut state = chain.at_rest();
    for (link, place) in state.links.iter_mut().zip([0.0, 1.0, 2.0]) {
        link.position.x = place * (SMALL_END - BIG_END) - BIG_END;
    }
    let mut falling = chain.in_motion(state);
    let before = chain.end(&falling.state);
    restored == crank.state
        && turned
        && pulled
        && model.stroke(&crank.state).x < 0.04 - BIG_END + SMALL_END
        && falling.assemble().is_ok()
        && every_integrator(&mut falling, 2e-6)
        && iterating
        && chain.end(&falling.state).y < before.y
        && chain.turns(&falling.state).iter().all(|turn| turn.abs() < 1.0)
        && chain.shock(falling.time, &falling.state).is_ok_and(|shock| shock.y < -1.0)
}

fn every_integrator<A: Assembly<f64>>(mechanism: &mut Mechanism<A>, step: f64) -> bool {
    let fine = |report: Result<ffrf::StepReport, ffrf::StepError>| {
        report.is_ok_and(|report| report.drift.position < 1e-9)
    };
    for _ in 0..20 {
        let all = fine(mechanism.step_rk4(step))
            && fine(mechanism.step_linearly_implicit(10.0 * step))
            && fine(mechanism.step_with(step, step_dormand_prince))
            && fine(mechanism.step_with(0.1 * step, step_symplectic_euler))
            && fine(mechanism.step_with(step, step_linearly_implicit_euler));
        if !all {
            return false;
        }
    }
    true
}

/// Methods that iterate: joints met at the end of each step, and no exponential step where joints hold what modes move.
fn implicit_methods<A: Assembly<f64>>(mechanism: &mut Mechanism<A>, step: f64) -> bool {
    let method = GeneralisedAlpha::new();
    let Ok(mut memory) = method.start(&Constrained(&mechanism.model), &mechanism.state, mechanism.time, step)
    else {
        return false;
    };
    for _ in 0..20 {
        let damped = mechanism.step_with(step, |system, state, time, step| {
            method.step(system, &mut memory, state, time, step)
        });
        let kept = mechanism.step_with(step, |system, state, time, step| {
            EnergyMomentum::new().step(system, state, time, step)
        });
        let met = |report: Result<ffrf::StepReport, ffrf::StepError>| {
            report.is_ok_and(|report| report.drift.position < 1e-9 && report.iterations > 0)
        };
        if !met(damped) || !met(kept) {
            return false;
        }
    }
    mechanism.step_with(step, step_exponential) == Err(ffrf::StepError::ModesNotSeparate)
}
