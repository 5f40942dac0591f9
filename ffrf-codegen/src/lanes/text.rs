//! Tables and functions as text.

use std::fmt::Write as _;

use super::{Diagonal, LaneTables, MomentTables, Table};
use crate::ScalarType;
use crate::emit::literal;
use crate::formulate::KernelKind;

/// Up to this number of modes, the common part of the kernels is inlined into each of them.
const LARGEST_INLINE: usize = 16;

/// The kernels that loops compute; the others cost no more than M operations per entry and stay statements.
pub const IN_LANES: [KernelKind; 6] = [
    KernelKind::MassMatrix,
    KernelKind::QuadraticVelocity,
    KernelKind::ForwardDynamics,
    KernelKind::EquationsOfMotion,
    KernelKind::KineticEnergy,
    KernelKind::AngularMomentum,
];

/// The static items and the functions, with the documentation that `document` gives for each.
pub(crate) fn functions(
    tables: &LaneTables,
    scalar: ScalarType,
    document: impl Fn(KernelKind) -> Vec<String>,
) -> String {
    let mut text = statics(tables, scalar);
    let (modes, size, groups) = (tables.modes, 6 + tables.modes, tables.groups);
    let (name, generics) = (scalar.type_name(), scalar.generics());
    let (coordinates, space, vector) =
        (format!("&[{name}; {modes}]"), format!("&[{name}; 3]"), format!("[{name}; {size}]"));
    let form = Form::of(scalar);
    let [q, q_dot, velocity, omega] = ["q", "q_dot", "velocity", "omega"].map(|name| form.input(name));
    let net = match tables.internal {
        Some(_) => form.input("force"),
        None => {
            let internal = form.input("&internal_force(q, q_dot)");
            format!("&support::lanes::net_force({}, {internal})", form.input("force"))
        }
    };
    // Few modes: one function is fastest. Many: what all kernels share is kept once.
    let inline = if modes <= LARGEST_INLINE { "#[inline(always)]" } else { "#[inline(never)]" };
    let _ = write!(
        text,
        "
    /// What follows from a state before forces are known: deformed invariants and quadratic velocity vector.
    {inline}
    fn state{generics}(
        q: {coordinates},
        omega: {space},
        q_dot: {coordinates},
    ) -> support::lanes::State<{}, {groups}> {{
        BODY.state({q}, {}, {q_dot})
    }}
",
        form.register_scalar(name),
        form.value("omega")
    );
    for kind in IN_LANES {
        let state = format!("q: {coordinates}, omega: {space}, q_dot: {coordinates}");
        let moving = format!("q: {coordinates}, velocity: {space}, omega: {space}, q_dot: {coordinates}");
        let at = "&state(q, omega, q_dot)";
        let zero = form.zero();
        let (inputs, result, arguments) = match kind {
            KernelKind::MassMatrix => (
                format!("q: {coordinates}"),
                format!("[{vector}; {size}]"),
                format!("&state(q, &[{zero}; 3], &[{zero}; {modes}])"),
            ),
            KernelKind::QuadraticVelocity => (state, vector.clone(), at.to_owned()),
            KernelKind::ForwardDynamics => {
                (format!("{state}, force: &{vector}"), vector.clone(), format!("{at}, {q}, {q_dot}, {net}"))
            }
            KernelKind::EquationsOfMotion => (
                format!("{state}, force: &{vector}"),
                format!("([{vector}; {size}], {vector}, {vector})"),
                format!("{at}, {q}, {q_dot}, {net}"),
            ),
            KernelKind::AngularMomentum => {
                (moving, format!("[{name}; 3]"), format!("{at}, {velocity}, {omega}"))
            }
            _ => (moving, name.to_owned(), format!("{at}, {velocity}, {omega}, {q_dot}")),
        };
        text.push('\n');
        for line in document(kind) {
            let _ = writeln!(text, "    /// {line}");
        }
        let function = kind.name();
        let _ = write!(
            text,
            "    #[inline]
    fn {function}{generics}(
        {},
    ) -> {result} {{
        {}
    }}
",
            inputs.replace(", ", ",\n        ").replace(",\n        &", ", &"),
            form.result(kind, &format!("BODY.{function}({arguments})"))
        );
    }
    text
}

/// How values get into the loops and out of them.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// The scalars of the loops are those of the functions.
    Plain,
    /// Any number type is wrapped on its way in and unwrapped on its way out.
    Wrapped,
}

impl Form {
    fn of(scalar: ScalarType) -> Self {
        if scalar == ScalarType::Generic { Self::Wrapped } else { Self::Plain }
    }

    /// The scalar type of the loops.
    fn register_scalar(self, name: &str) -> String {
        match self {
            Self::Plain => name.to_owned(),
            Self::Wrapped => format!("support::lanes::Real<{name}>"),
        }
    }

    /// A reference to an array, as an argument of the loops.
    fn input(self, reference: &str) -> String {
        match self {
            Self::Plain => reference.to_owned(),
            Self::Wrapped => format!("&support::lanes::reals({reference})"),
        }
    }

    /// What a reference to an array points to, as an argument of the loops.
    fn value(self, reference: &str) -> String {
        match self {
            Self::Plain => format!("*{reference}"),
            Self::Wrapped => format!("support::lanes::reals({reference})"),
        }
    }

    fn zero(self) -> &'static str {
        match self {
            Self::Plain => "0.0",
            Self::Wrapped => "support::constant(0.0)",
        }
    }

    /// The result of a kernel from that of the loops.
    fn result(self, kind: KernelKind, call: &str) -> String {
        match (self, kind) {
            (Self::Plain, _) => call.to_owned(),
            (Self::Wrapped, KernelKind::MassMatrix) => format!("{call}.map(support::lanes::numbers)"),
            (Self::Wrapped, KernelKind::EquationsOfMotion) => format!(
                "let (mass_matrix, quadratic_velocity, acceleration) = {call};
        (
            mass_matrix.map(support::lanes::numbers),
            support::lanes::numbers(quadratic_velocity),
            support::lanes::numbers(acceleration),
        )"
            ),
            (Self::Wrapped, KernelKind::KineticEnergy) => format!("{call}.0"),
            (Self::Wrapped, _) => format!("support::lanes::numbers({call})"),
        }
    }
}

/// The method of the trait that writes its results in place; a generic body has none, as its results are moved anyway.
pub(crate) fn trait_method(tables: &LaneTables, scalar: ScalarType) -> String {
    if scalar == ScalarType::Generic {
        return String::new();
    }
    let (modes, size, scalar) = (tables.modes, 6 + tables.modes, scalar.name());
    let vector = |size: usize| format!("&::ffrf::nalgebra::SVector<{scalar}, {size}>");
    let (coordinates, forces) = (vector(modes), vector(size));
    let force = match tables.internal {
        Some(_) => "support::array(force)",
        None => "&support::lanes::net_force(support::array(force), &internal_force(q, q_dot))",
    };
    format!(
        "
        #[inline]
        fn write_equations_of_motion(
            &self,
            q: {coordinates},
            omega: &::ffrf::nalgebra::Vector3<{scalar}>,
            q_dot: {coordinates},
            force: {forces},
            mass_matrix: &mut ::ffrf::nalgebra::SMatrix<{scalar}, {size}, {size}>,
            quadratic_velocity: &mut ::ffrf::nalgebra::SVector<{scalar}, {size}>,
            acceleration: &mut ::ffrf::nalgebra::SVector<{scalar}, {size}>,
        ) {{
            let (q, q_dot) = (support::array(q), support::array(q_dot));
            let force = {force};
            BODY.write_equations_of_motion(
                &state(q, support::array(omega), q_dot),
                q,
                q_dot,
                force,
                support::columns_mut(mass_matrix),
                support::array_mut(quadratic_velocity),
                support::array_mut(acceleration),
            );
        }}
"
    )
}

fn statics(tables: &LaneTables, scalar: ScalarType) -> String {
    let (modes, groups, name) = (tables.modes, tables.groups, scalar.constant_type_name());
    let mut text = String::new();
    let mut item = |name: &str, meaning: &str, table: &Table| {
        let (kind, value) = (array_type(table.shape(), scalar), nested(table, 2, scalar));
        let _ = writeln!(text, "    /// {meaning}\n    static {name}: {kind} = {value};\n");
    };
    let mut optional = |name: &str, meaning: &str, table: &Option<Table>| match table {
        Some(table) => {
            item(name, meaning, table);
            format!("::core::option::Option::Some(&{name})")
        }
        None => "::core::option::Option::None".to_owned(),
    };
    let modal_first_moment = optional(
        "MODAL_FIRST_MOMENT",
        "m b_μ. Units: kg m per unit modal coordinate. Layout: group, axis, lane.",
        &tables.modal_first_moment,
    );
    let position_mode_even = optional(
        "POSITION_MODE_EVEN",
        "tr T_μ, yy, zz, xy + yx, xz + zx, yz + zy of T_μ. Layout: group, component, lane.",
        &tables.position_mode_even,
    );
    let position_mode_odd =
        optional("POSITION_MODE_ODD", "ϑ_μ. Layout: group, axis, lane.", &tables.position_mode_odd);
    let mut diagonal = |name: &str, meaning: &str, diagonal: &Diagonal| match diagonal {
        Diagonal::Zero => "support::lanes::Diagonal::Zero".to_owned(),
        Diagonal::Identity => "support::lanes::Diagonal::Identity".to_owned(),
        Diagonal::Entries(table) => {
            item(name, meaning, table);
            format!("support::lanes::Diagonal::Entries(&{name})")
        }
    };
    let trace = diagonal("TRACE", "tr T_μμ. Layout: group, lane.", &tables.trace);
    let modal_mass = diagonal("MODAL_MASS", "Θ_ff. Layout: group, lane.", &tables.modal_mass);
    let modal_compliance =
        diagonal("MODAL_COMPLIANCE", "Θ_ff⁻¹. Layout: group, lane.", &tables.modal_compliance);
    let (stiffness, damping) = match &tables.internal {
        Some([stiffness, damping]) => (
            diagonal("STIFFNESS", "K_ff. Layout: group, lane.", stiffness),
            diagonal("DAMPING", "D_ff. Layout: group, lane.", damping),
        ),
        None => (diagonal("", "", &Diagonal::Zero), diagonal("", "", &Diagonal::Zero)),
    };
    let (kind, moments) = moments(tables, scalar);
    let array = |numbers: &[f64]| row(numbers, scalar);
    let first_moment = match tables.first_moment {
        Some(moment) => format!("::core::option::Option::Some({})", array(&moment)),
        None => "::core::option::Option::None".to_owned(),
    };
    let mass = literal(tables.mass, scalar);
    let _ = writeln!(
        text,
        "    /// The body in lanes: {groups} groups of 4 for {modes} modes; table of moments {} bytes.
    static BODY: support::lanes::LaneBody<{name}, {modes}, {groups}, {kind}> = support::lanes::LaneBody {{
        mass: {mass},
        first_moment: {first_moment},
        modal_first_moment: {modal_first_moment},
        inertia: {},
        translation_compliance: {},
        position_mode_even: {position_mode_even},
        position_mode_odd: {position_mode_odd},
        trace: {trace},
        modal_mass: {modal_mass},
        modal_compliance: {modal_compliance},
        stiffness: {stiffness},
        damping: {damping},
        moments: {moments},
    }};",
        tables.moment_bytes(scalar),
        array(&tables.inertia),
        array(&tables.translation_compliance),
    );
    text
}

/// Type and value of the table of moments.
fn moments(tables: &LaneTables, scalar: ScalarType) -> (String, String) {
    let (modes, name) = (tables.modes, scalar.constant_type_name());
    let structure = |kind: &str, fields: [(&str, &Table); 2]| {
        let mut text = format!("support::lanes::{kind} {{\n");
        for (field, table) in fields {
            let _ = writeln!(text, "            {field}: {},", nested(table, 3, scalar));
        }
        text.push_str("        }");
        text
    };
    match &tables.moments {
        MomentTables::None => ("()".to_owned(), "()".to_owned()),
        MomentTables::Whole { eights, fours } => {
            let (pairs, single) = (eights.shape()[0], fours.shape()[0]);
            (
                format!("support::lanes::FullTable<{name}, {modes}, {pairs}, {single}>"),
                structure("FullTable", [("eights", eights), ("fours", fours)]),
            )
        }
        MomentTables::Half { diagonal, below } => {
            let (rows, width, tiles) = (diagonal.shape()[0], diagonal.shape()[2], below.shape()[0]);
            (
                format!("support::lanes::HalfTable<{name}, {width}, {rows}, {tiles}>"),
                structure("HalfTable", [("diagonal", diagonal), ("below", below)]),
            )
        }
    }
}

/// `[[[f64; 4]; 3]; 2]` for the shape 2, 3, 4.
fn array_type(shape: &[usize], scalar: ScalarType) -> String {
    shape
        .iter()
        .rev()
        .fold(scalar.constant_type_name().to_owned(), |inner, length| format!("[{inner}; {length}]"))
}

fn row(numbers: &[f64], scalar: ScalarType) -> String {
    let entries: Vec<String> = numbers.iter().map(|number| literal(*number, scalar)).collect();
    format!("[{}]", entries.join(", "))
}

/// A table in brackets, an innermost array a line; `level` is the indentation of its entries.
fn nested(table: &Table, level: usize, scalar: ScalarType) -> String {
    fn write(shape: &[usize], entries: &[f64], level: usize, scalar: ScalarType, text: &mut String) {
        match shape {
            [] | [0, ..] => text.push_str("[]"),
            [_] => text.push_str(&row(entries, scalar)),
            [count, inner @ ..] => {
                text.push_str("[\n");
                for part in entries.chunks((entries.len() / count).max(1)) {
                    text.push_str(&"    ".repeat(level));
                    write(inner, part, level + 1, scalar, text);
                    text.push_str(",\n");
                }
                text.push_str(&"    ".repeat(level - 1));
                text.push(']');
            }
        }
    }
    let mut text = String::new();
    write(table.shape(), table.entries(), level, scalar, &mut text);
    text
}
