//! The stack that a step takes: it succeeds in a thread that has no more.

use ffrf::mechanism::{Assembly, Mechanism};

use crate::bodies::{Pendulum, Rod, SliderCrank, SliderCrankState, WholeRod};
use crate::chain::Chain;

/// Takes steps of both kinds in a thread with a stack of so many bytes; a larger need ends the whole test program.
fn steps_within<A>(bytes: usize, mut mechanism: Mechanism<A>)
where
    A: Assembly<f64> + Send + 'static,
    A::State: Send + 'static,
{
    // what the thread itself needs before and after the closure
    const THREAD: usize = 16 << 10;
    let steps = move || {
        mechanism.step_rk4(2e-6).unwrap();
        mechanism.step_linearly_implicit(1e-5).unwrap();
    };
    std::thread::Builder::new().stack_size(THREAD + bytes).spawn(steps).unwrap().join().unwrap();
}

#[test]
fn a_step_fits_into_the_stated_stack() {
    let pendulum = Pendulum::new(WholeRod);
    steps_within(64 << 10, pendulum.in_motion(pendulum.at_rest()));
    let crank = SliderCrank::new(Rod);
    steps_within(96 << 10, crank.in_motion(SliderCrankState::stretched(&crank)));
    let chain = Chain::new([Rod; 5]);
    steps_within(160 << 10, chain.in_motion(chain.at_rest()));
}
