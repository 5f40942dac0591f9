//! What was found, as lines for people.

use std::fmt::Write;

use super::Found;
use super::program::Subject;
use crate::arguments::{Core, TargetScalar};

/// What every number of the report means.
pub const ASSUMPTIONS: &str = "\
Instructions are exact counts of the emulator (the most of 32 calls, reading the clock included), which does not model
cycles: the share of a tick assumes one instruction per cycle. Flash is what a program has more than the same program
without the work. Stack is what one call touches, found by painting, without the 104 bytes of an interrupt; at most what the
machine code can take along its deepest way of calls. No program here can allocate or panic, or it would not have linked.
";

/// Rate of a controller's tick. Units: Hz.
const TICK: f64 = 1e3;

impl Core {
    /// Name, and a clock that is usual for it. Units: MHz.
    pub(crate) fn clock(self) -> (&'static str, f64) {
        match self {
            Self::CortexM4F => ("cortex-m4f", 168.0),
            Self::CortexM7 => ("cortex-m7", 480.0),
        }
    }
}

/// One block of the report.
pub fn text(subject: &Subject, core: Core, scalar: TargetScalar, found: &Found) -> String {
    let (name, clock) = core.clock();
    let scalar = match scalar {
        TargetScalar::F32 => "f32",
        TargetScalar::F64 => "f64",
    };
    let mut text = format!("{name}, {scalar}: {}\n", subject.title);
    let base = found.baseline.sizes;
    let mut line = |what: &str, rest: String| {
        let _ = writeln!(text, "  {what:<26}{rest}");
    };
    let flash = |program: &super::Program| {
        let (code, tables) =
            (program.sizes.code.saturating_sub(base.code), program.sizes.tables.saturating_sub(base.tables));
        format!("{:>8} bytes: {code} of code, {tables} of tables", code + tables)
    };
    if let Some((program, run)) = &found.kernels {
        line("flash of all kernels", flash(program));
        for one in &run.measured {
            line(&one.name, format!("{:>8} instructions, {} bytes of stack", one.most, one.stack));
        }
    }
    line("flash of the step", flash(&found.step));
    let variables = found.step.sizes.variables.saturating_sub(base.variables);
    line(
        "static RAM",
        format!("{variables:>8} bytes; model and state take {} where they are kept", found.run.state),
    );
    for one in &found.run.measured {
        let bound = match &found.bound {
            Ok(bound) => format!("at most {bound}"),
            Err(error) => format!("without a bound: {}", crate::report::chain(error)),
        };
        line("stack of a step", format!("{:>8} bytes, {bound}", one.stack));
        line("instructions of a step", format!("{:>8}, {} on average", one.most, one.mean));
        let share = one.most as f64 * TICK / (clock * 1e6);
        line("share of a 1 kHz tick", format!("{:>7.1} % at {clock} MHz", 100.0 * share));
    }
    text.push('\n');
    text
}
