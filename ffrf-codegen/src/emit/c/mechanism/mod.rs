//! The time step of a mechanism in C: tables of its numbers about a solver whose text is written once.
//!
//! ```text
//! PREFIX.h    state, inputs, outputs, names of bodies and sensors, the functions with documentation
//! PREFIX.c    kernels of the flexible bodies, tables, and the parts of `solver/` that the mechanism needs
//! ```
//!
//! The solver is that of the runtime's `mechanism` and `integrators`, operation by operation in all that matters.

mod features;
mod header;
mod names;
mod tables;

pub(crate) use self::names::Names;
use self::tables::Numbers;
use super::notation::type_name;
use super::template;
use crate::mechanism::{MechanismModel, MechanismPlan};
use crate::{CodegenError, GenerateOptions};

/// The parts of the solver before the function that [`tables::prepare`] prints, in their order.
const BEFORE: [&str; 4] = [
    include_str!("solver/vectors.c"),
    include_str!("solver/elementary.c"),
    include_str!("solver/elimination.c"),
    include_str!("solver/prepare.c"),
];

/// Those behind it.
const BEHIND: [&str; 12] = [
    include_str!("solver/bodies.c"),
    include_str!("solver/markers.c"),
    include_str!("solver/relations.c"),
    include_str!("solver/forces.c"),
    include_str!("solver/solve.c"),
    include_str!("solver/soft.c"),
    include_str!("solver/accelerate.c"),
    include_str!("solver/step.c"),
    include_str!("solver/methods.c"),
    include_str!("solver/outputs.c"),
    include_str!("solver/observe.c"),
    include_str!("solver/compose.c"),
];

/// What a mechanism is printed from, besides its model.
pub(crate) struct MechanismSubject<'a> {
    /// The model.
    pub(crate) model: &'a MechanismModel,
    /// Name and scalar type.
    pub(crate) options: &'a GenerateOptions,
    /// Names in C.
    pub(crate) names: &'a Names,
    /// Where every number stands; soft links behind the joints.
    pub(crate) plan: &'a MechanismPlan,
    /// The elements that are soft links.
    pub(crate) soft: &'a [usize],
    /// Whether joints close loops.
    pub(crate) has_loops: bool,
    /// The kernels of the flexible bodies.
    pub(crate) kernels: &'a str,
    /// Before the name of the kernel of each body; empty for rigid bodies.
    pub(crate) kernel_of: &'a [String],
}

impl MechanismSubject<'_> {
    /// The most modes of a body.
    fn modes(&self) -> usize {
        self.model.bodies.iter().map(|body| body.kind.mode_count()).max().unwrap_or(0)
    }

    fn type_name(&self) -> &'static str {
        type_name(self.options.scalar)
    }
}

/// Header, source, and both in one text.
///
/// Errors: a number is not finite in the scalar type.
pub(crate) fn mechanism(subject: &MechanismSubject<'_>) -> Result<[String; 3], CodegenError> {
    let (features, numbers) = (features::of(subject), Numbers::new(subject.options.scalar));
    let header = header::header(subject, &features);
    let macro_prefix = subject.names.prefix.to_uppercase();
    // tables are constants, or they are the caller's and their types stand in the header
    let taken = format!("const {}_tables *tables, ", subject.names.prefix);
    let (tables_at, taken) =
        if features.contains("PARAMETERS") { ("work->tables->", taken.as_str()) } else { ("", "") };
    let names = [
        ("@P", subject.names.prefix.as_str()),
        ("@M", macro_prefix.as_str()),
        ("@T", tables_at),
        ("@G", taken),
    ];
    let mut text = String::from("#include <math.h>\n#include <stddef.h>\n\n");
    text.push_str(subject.kernels);
    text.push('\n');
    text.push_str(&tables::constants(subject, &numbers));
    if features.contains("PARAMETERS") {
        text.push_str(&header::aliases(subject, &features));
    } else {
        text.push_str(&header::places(&features, "", "real"));
    }
    text.push_str(&template::filled(include_str!("solver/types.c"), &features, &names));
    text.push_str(&tables::tables(subject, &numbers));
    let mut solver = |parts: &[&str]| {
        for part in parts {
            text.push_str(&template::filled(part, &features, &names));
            text.push('\n');
        }
    };
    solver(&BEFORE);
    solver(&[tables::prepare(subject).as_str()]);
    solver(&BEHIND);
    numbers.verdict()?;
    let banner = header::banner(subject);
    let source = format!("{banner}#include \"{}.h\"\n{text}", subject.names.prefix);
    let single = format!("{header}\n{text}");
    Ok([header, source, single])
}
