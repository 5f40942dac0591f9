//! Steps just below and just above the limit of stability.

use ffrf::{
    FlexibleBody, FreeBody, FreeSystem, GeneralisedAlpha, ModalVector, StepError, StepReport, System,
    step_linearly_implicit, step_rk4, step_symplectic_euler,
};

use crate::row;
use crate::settings::{Rod, largest};
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::BOUNDED;

const STEPS: usize = 20_000;

/// What `largest_stable_step` is made with: for every damping ratio, see `ffrf-model/src/stable_step.rs`.
const RADIUS: f64 = 2.785;

/// The highest mode of the rod.
const HIGHEST: usize = 3;

pub fn section() -> Section {
    let undamped = 8.0_f64.sqrt() / RADIUS;
    let euler = 2.0 / RADIUS;
    Section {
        title: "Steps at 0.99 and 1.01 of the limit of stability",
        text: "The free connecting rod (4 modes, undamped) vibrates in its highest mode for 20,000 steps: its largest amplitude \
               over the first. `largest_stable_step` holds for any damping; without damping the limit of RK4 is 2√2 over the \
               highest frequency, that of symplectic Euler 2. Beyond it the motion grows until it leaves the number type, and \
               the step is refused with the limit. Implicit methods take a thousand and a million times as much.",
        rows: vec![
            row!("RK4, 0.99 of `largest_stable_step`", runge_kutta, 0.99),
            row!("RK4, 0.99 of 2√2/ω", runge_kutta, 0.99 * undamped),
            row!("RK4, 1.01 of 2√2/ω", runge_kutta, 1.01 * undamped),
            row!("symplectic Euler, 0.99 of 2/ω", symplectic_euler, 0.99 * euler),
            row!("symplectic Euler, 1.01 of 2/ω", symplectic_euler, 1.01 * euler),
            row!("linearly implicit, 1e6 of 2√2/ω", linearly_implicit, 1e6 * undamped),
            row!("generalised-α, 1e3 of 2√2/ω", generalised_alpha, 1e3 * undamped),
        ],
    }
}

type Rods<'a> = FreeSystem<'a, Rod, ()>;

fn run<T: Real>(
    share: f64,
    mut method: impl FnMut(
        &Rods<'_>,
        &FreeBody<Rod, T>,
        T,
    ) -> Result<(<Rods<'static> as System<T>>::State, StepReport<T>), StepError>,
) -> Figure {
    let rest = FlexibleBody::<T>::undeformed(&Rod);
    let mut q = rest;
    q.as_mut_slice()[HIGHEST] = T::of(1e-6);
    let mut body = FreeBody::new(Rod).with_deformation(q, rest);
    let step = FlexibleBody::<T>::largest_stable_step(&Rod).unwrap() * T::of(share);
    let mut most = 0.0;
    for _ in 0..STEPS {
        match method(&FreeSystem { body: &Rod, load: &() }, &body, step) {
            Ok((state, _)) => body.state = state,
            Err(error) => return refused(error),
        }
        most = largest([most, body.state.modal_coordinates.largest().double() / 1e-6]);
    }
    below::<T>(most, BOUNDED)
}

fn runge_kutta<T: Real>(share: f64) -> Figure {
    run::<T>(share, |system, body, step| step_rk4(system, &body.state, T::zero(), step))
}

fn symplectic_euler<T: Real>(share: f64) -> Figure {
    run::<T>(share, |system, body, step| step_symplectic_euler(system, &body.state, T::zero(), step))
}

fn linearly_implicit<T: Real>(share: f64) -> Figure {
    run::<T>(share, |system, body, step| step_linearly_implicit(system, &body.state, T::zero(), step))
}

fn generalised_alpha<T: Real>(share: f64) -> Figure {
    let method = GeneralisedAlpha::new();
    let mut memory = None;
    run::<T>(share, |system, body, step| {
        let memory = match &mut memory {
            Some(memory) => memory,
            none => none.insert(method.start(system, &body.state, T::zero(), step)?),
        };
        method.step(system, memory, &body.state, T::zero(), step)
    })
}
