//! A flexible slider-crank in a loop of 1 kHz on Linux, with a speed controller: how late the loop wakes, how long a step takes.
//!
//! `cargo build --release --example real_time_loop`, then, on a kernel with PREEMPT_RT,
//! `sudo chrt -f 80 taskset -c 3 target/release/examples/real_time_loop 10` (seconds). See docs/target.md.
#![forbid(unsafe_code)]

use std::process::ExitCode;
use std::time::{Duration, Instant};

ffrf::flexible_body! {
    /// The connecting rod with its four lowest modes.
    pub struct Rod { model: "models/conrod.ffrf.json", modes: ..4 }
}

ffrf::mechanism! {
    /// A crank that a motor turns, a flexible rod, a piston.
    pub struct SliderCrank {
        bodies: {
            crank: rigid {
                mass: 0.5,
                center_of_mass: [0.01, 0.0, 0.0],
                inertia: [2e-4, 4e-4, 5e-4],
                markers: { PIN: [RADIUS, 0.0, 0.0] },
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
        forces: { motor: actuator(main) },
    }
}

/// Radius of the crank. Units: m.
const RADIUS: f64 = 0.04;
/// Tick of the loop and step of the integrator.
const TICK: Duration = Duration::from_millis(1);
/// Before a tick the loop stays awake for so long, where sleeping could wake it too late.
const AWAKE: Duration = Duration::from_micros(100);
/// Speed that the controller holds. Units: rad/s.
const SPEED: f64 = 40.0;
/// Its gain. Units: N m s.
const GAIN: f64 = 0.05;

fn main() -> ExitCode {
    let seconds: Option<u32> = std::env::args().nth(1).map_or(Some(1), |word| word.parse().ok());
    let Some(ticks) = seconds.and_then(|seconds| seconds.checked_mul(1000)).filter(|ticks| *ticks > 0) else {
        eprintln!("usage: real_time_loop [SECONDS]");
        return ExitCode::from(2);
    };
    let model = SliderCrank::new(Rod);
    let mut state = model.at_rest();
    state.rod.position.x = RADIUS - Rod::BIG_END.position.x;
    state.piston.position.x = state.rod.position.x + Rod::SMALL_END.position.x;
    let mut crank = model.in_motion(state);
    // what is recorded is allocated before the loop; the loop itself allocates nothing
    let (mut late, mut taken) = (vec![Duration::ZERO; ticks as usize], vec![Duration::ZERO; ticks as usize]);
    let mut speeds = vec![0.0; ticks as usize];
    let start = Instant::now();
    for tick in 0..ticks {
        let due = start + TICK * (tick + 1);
        wait(due);
        let woken = Instant::now();
        let speed = crank.state.crank.angular_velocity.z;
        crank.model.motor.kind.moment = (SPEED - speed) * GAIN;
        if let Err(error) = crank.step_linearly_implicit(TICK.as_secs_f64()) {
            eprintln!("tick {tick}: {error}");
            return ExitCode::FAILURE;
        }
        speeds[tick as usize] = speed;
        late[tick as usize] = woken - due;
        taken[tick as usize] = woken.elapsed();
    }
    println!("{ticks} ticks of 1 ms");
    if let Some([lowest, mean, highest]) = of_whole_turns(&speeds) {
        println!(
            "crank at {mean:.2} rad/s on the mean of a turn, from {lowest:.2} to {highest:.2} within it"
        );
    }
    println!("{:24} {:>9} {:>9} {:>9} {:>9}", "microseconds", "median", "99 %", "99.9 %", "worst");
    show("woken late by", late);
    show("controller and step", taken);
    ExitCode::SUCCESS
}

/// Lowest speed, mean over the angle and highest speed of the last whole turns, those of a second at most. Units: rad/s.
///
/// The inertia that the motor sees nearly doubles and halves twice a turn, so that the speed swings by a seventh about what the
/// controller holds: without losses its moment does no work in a turn, which makes the mean over the angle the speed asked for.
fn of_whole_turns(speeds: &[f64]) -> Option<[f64; 3]> {
    let tick = TICK.as_secs_f64();
    let second = &speeds[speeds.len().saturating_sub(1000)..];
    let turns = (second.iter().sum::<f64>() * tick / std::f64::consts::TAU).floor();
    let (mut angle, mut of_angle) = (0.0, 0.0);
    let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
    for &speed in second.iter().rev().take_while(|&&speed| {
        angle += speed * tick;
        angle <= turns * std::f64::consts::TAU
    }) {
        of_angle += speed * speed * tick;
        (lowest, highest) = (speed.min(lowest), speed.max(highest));
    }
    (turns > 0.0).then(|| [lowest, of_angle / (turns * std::f64::consts::TAU), highest])
}

/// Sleeps until shortly before `due`, then waits for it.
fn wait(due: Instant) {
    if let Some(time) = due.checked_duration_since(Instant::now() + AWAKE) {
        std::thread::sleep(time);
    }
    while Instant::now() < due {
        std::hint::spin_loop();
    }
}

fn show(what: &str, mut times: Vec<Duration>) {
    times.sort_unstable();
    let at = |share: f64| {
        let place = (share * (times.len() - 1) as f64) as usize;
        times[place].as_secs_f64() * 1e6
    };
    println!("{what:24} {:9.1} {:9.1} {:9.1} {:9.1}", at(0.5), at(0.99), at(0.999), at(1.0));
}
