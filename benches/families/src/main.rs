//! The connecting rod in free tumbling flight, as every member of a family: time per step, and error of its attitude and tip.
//!
//! usage: families [ROUNDS] prints a Markdown table; families count NAME STEPS takes so many steps and prints nothing, for
//! callgrind; families --list prints the names. See `benches/families.sh`.

use std::time::Instant;

use ffrf::nalgebra::{RealField, Vector3, convert, try_convert};
use ffrf::{FamilyMember, FamilyVisitor, FreeBody, ModalVector, Observables};

ffrf::flexible_body! {
    /// The steel connecting rod of `models/conrod`.
    family rods {
        model: "../../models/conrod.ffrf.json",
        modes: [0, 2, 4, 8],
        fidelity: [full, linear, constant],
        scalar: [f64, f32],
    }
}

/// Units: s. The highest of eight modes allows an explicit step of 56 µs.
const STEP: f64 = 1e-5;
/// Simulated time. Units: s.
const DURATION: f64 = 0.02;

/// The rod at 150 rad/s, bent by a tenth of a millimetre in its first mode.
fn flying<T: RealField + Copy, B: Observables<T> + Copy>(body: B) -> FreeBody<B, T> {
    let spin: Vector3<T> = Vector3::new(40.0, 90.0, 120.0).map(convert);
    let mut body = FreeBody::new(body).with_spin(spin);
    if let Some(first) = body.state.modal_coordinates.as_mut_slice().first_mut() {
        *first = convert(1e-4);
    }
    body
}

fn fly<T: RealField + Copy, B: Observables<T> + Copy>(body: &mut FreeBody<B, T>, step: f64, steps: usize) {
    for _ in 0..steps {
        body.step_rk4(convert(step), &()).expect("a finite state");
    }
}

/// Where a point of the body is that was half a metre off the origin along x: attitude as a length.
fn shown<T: RealField + Copy, B: Observables<T>>(body: &FreeBody<B, T>) -> Vector3<f64> {
    let arm: Vector3<T> = Vector3::new(0.5, 0.0, 0.0).map(convert);
    (body.state.position + body.state.to_inertial(&arm)).map(|x| try_convert(x).unwrap_or(f64::NAN))
}

/// One line of the table.
struct Line {
    member: FamilyMember,
    nanoseconds: f64,
    error: f64,
}

struct Table {
    rounds: usize,
    exact: Vector3<f64>,
    lines: Vec<Line>,
}

impl FamilyVisitor for Table {
    fn visit<T: RealField + Copy, B: Observables<T> + Copy>(&mut self, member: FamilyMember, body: B) {
        let mut flight = flying(body);
        fly(&mut flight, STEP, (DURATION / STEP).round() as usize);
        let error = (shown(&flight) - self.exact).norm() / 0.5;
        let mut nanoseconds = f64::INFINITY;
        for _ in 0..self.rounds {
            let mut flight = flying(body);
            let begin = Instant::now();
            fly(&mut flight, STEP, 200);
            nanoseconds = nanoseconds.min(begin.elapsed().as_nanos() as f64 / 200.0);
        }
        self.lines.push(Line { member, nanoseconds, error });
    }
}

/// Steps of one member and nothing else.
struct Count {
    name: String,
    steps: usize,
}

impl FamilyVisitor for Count {
    fn visit<T: RealField + Copy, B: Observables<T> + Copy>(&mut self, member: FamilyMember, body: B) {
        if member.name == self.name {
            let mut flight = flying(body);
            fly(&mut flight, STEP, self.steps);
            assert!(flight.state.is_finite());
        }
    }
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["--list"] => rods::MEMBERS.iter().for_each(|member| println!("{}", member.name)),
        ["count", name, steps] => {
            let steps = steps.parse().expect("a number of steps");
            rods::for_each(&mut Count { name: name.to_owned(), steps });
        }
        _ => table(words.first().map_or(200, |rounds| rounds.parse().expect("a number of rounds"))),
    }
}

fn table(rounds: usize) {
    let mut whole = flying::<f64, _>(rods::M8FullF64);
    fly(&mut whole, STEP / 8.0, (8.0 * DURATION / STEP).round() as usize);
    let mut table = Table { rounds, exact: shown(&whole), lines: Vec::new() };
    rods::for_each(&mut table);
    println!("| member | modes | fidelity | scalar | ns per step | error |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for Line { member: FamilyMember { name, modes, fidelity, scalar }, nanoseconds, error } in &table.lines {
        println!("| {name} | {modes} | {fidelity} | {scalar} | {nanoseconds:.0} | {error:.1e} |");
    }
}
