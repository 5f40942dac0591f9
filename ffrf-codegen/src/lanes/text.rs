//! Tables and functions as text.

use std::fmt::Write as _;

use super::kernels_text::{Form, KernelText};
use super::{LaneTables, ModalFactors, ModalMatrix, MomentTables, Table};
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
    let (modes, groups) = (tables.modes, tables.groups);
    let (name, generics) = (scalar.type_name(), scalar.generics());
    let (coordinates, space) = (format!("&[{name}; {modes}]"), format!("&[{name}; 3]"));
    let form = Form::of(scalar);
    let state = format!("support::lanes::State<{}, {groups}>", form.register_scalar(name));
    let arguments = [form.input("q"), form.value("omega"), form.input("q_dot")].join(", ");
    // Few modes: one function is fastest. Many: what all kernels share is kept once, and the state is not moved.
    let (inline, function, place, result, body) = if modes <= LARGEST_INLINE {
        let result = format!(" -> {state}");
        ("always", "state", String::new(), result, format!("BODY.state({arguments})"))
    } else {
        let place = format!("\n        state: &mut {state},");
        ("never", "write_state", place, String::new(), format!("BODY.write_state({arguments}, state);"))
    };
    let _ = write!(
        text,
        "
    /// What follows from a state before forces are known: deformed invariants and quadratic velocity vector.
    #[inline({inline})]
    fn {function}{generics}(
        q: {coordinates},
        omega: {space},
        q_dot: {coordinates},{place}
    ){result} {{
        {body}
    }}
"
    );
    let zero = form.zero();
    let kernels = KernelText {
        modes,
        scalar,
        parameters: String::new(),
        preparation: "",
        loops: "BODY",
        state: evaluation(modes, 2, "omega", "q_dot"),
        state_at_rest: evaluation(modes, 2, &format!("&[{zero}; 3]"), &format!("&[{zero}; {modes}]")),
        net_force: form.input("force"),
    };
    text.push_str(&kernels.functions(document));
    text
}

/// The statements that make the variable `state`, so many levels deep.
fn evaluation(modes: usize, level: usize, omega: &str, q_dot: &str) -> String {
    let indent = "    ".repeat(level);
    if modes <= LARGEST_INLINE {
        format!("{indent}let state = state(q, {omega}, {q_dot});\n")
    } else {
        format!(
            "{indent}let mut state = support::lanes::State::zero();
{indent}write_state(q, {omega}, {q_dot}, &mut state);\n"
        )
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
            let force = support::array(force);
{}            BODY.write_equations_of_motion(
                &state,
                q,
                q_dot,
                force,
                support::columns_mut(mass_matrix),
                support::array_mut(quadratic_velocity),
                support::array_mut(acceleration),
            );
        }}
",
        evaluation(modes, 3, "support::array(omega)", "q_dot")
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
    let eliminated_first_moment = if tables.eliminated_first_moment == tables.modal_first_moment {
        modal_first_moment.clone()
    } else {
        optional(
            "ELIMINATED_FIRST_MOMENT",
            "L⁻¹ (m B)ᵀ with Θ_ff = L D Lᵀ. Layout: group, axis, lane.",
            &tables.eliminated_first_moment,
        )
    };
    let mut matrix = |name: &str, meaning: &str, matrix: &ModalMatrix| match matrix {
        ModalMatrix::Zero => "support::lanes::ModalMatrix::Zero".to_owned(),
        ModalMatrix::Identity => "support::lanes::ModalMatrix::Identity".to_owned(),
        ModalMatrix::Diagonal(table) => {
            item(name, &format!("{meaning}. Layout: group, lane."), table);
            format!("support::lanes::ModalMatrix::Diagonal(&{name})")
        }
        ModalMatrix::Dense(table) => {
            item(name, &format!("{meaning}. Layout: group, mode, lane."), table);
            format!("support::lanes::ModalMatrix::Dense(&{name})")
        }
    };
    let modal_mass = matrix("MODAL_MASS", "Θ_ff", &tables.modal_mass);
    let trace = if tables.trace == tables.modal_mass {
        modal_mass.clone()
    } else {
        matrix("TRACE", "tr T_μν", &tables.trace)
    };
    let stiffness = matrix("STIFFNESS", "K_ff", &tables.stiffness);
    let damping = matrix("DAMPING", "D_ff", &tables.damping);
    let modal_factors = match &tables.modal_factors {
        ModalFactors::Identity => "support::lanes::ModalFactors::Identity".to_owned(),
        ModalFactors::Diagonal(table) => {
            item("INVERSE_MODAL_MASS", "Θ_ff⁻¹. Layout: group, lane.", table);
            "support::lanes::ModalFactors::Diagonal(&INVERSE_MODAL_MASS)".to_owned()
        }
        ModalFactors::Triangular { inverse_pivots, lower } => {
            item("INVERSE_PIVOTS", "D⁻¹ with Θ_ff = L D Lᵀ. Layout: group, lane.", inverse_pivots);
            item("LOWER", "L + Lᵀ without its diagonal. Layout: group, mode, lane.", lower);
            "support::lanes::ModalFactors::Triangular { inverse_pivots: &INVERSE_PIVOTS, lower: &LOWER }"
                .to_owned()
        }
    };
    // A constant, so that other crates that use the body see what is left out; its tables stand once, in statics.
    let (kind, moments) = match moments(tables, scalar) {
        Some((kind, table)) => {
            let _ = writeln!(
                text,
                "    /// T_νμ in the order in which the loops read them.\n    static MOMENTS: {kind} = {table};\n"
            );
            (format!("&{kind}"), "&MOMENTS")
        }
        None => ("()".to_owned(), "()"),
    };
    let array = |numbers: &[f64]| row(numbers, scalar);
    let list = |numbers: Option<[f64; 3]>| match numbers {
        Some(numbers) => format!("::core::option::Option::Some({})", array(&numbers)),
        None => "::core::option::Option::None".to_owned(),
    };
    let (first_moment, translation_lower) = (list(tables.first_moment), list(tables.translation_lower));
    let mass = literal(tables.mass, scalar);
    let _ = writeln!(
        text,
        "    /// The body in lanes: {groups} groups of 4 for {modes} modes; table of moments {} bytes.
    const BODY: support::lanes::LaneBody<{name}, {modes}, {groups}, {kind}> = support::lanes::LaneBody {{
        mass: {mass},
        first_moment: {first_moment},
        modal_first_moment: {modal_first_moment},
        inertia: {},
        translation_factors: support::lanes::Factors {{
            inverse_pivots: {},
            lower: {translation_lower},
        }},
        eliminated_first_moment: {eliminated_first_moment},
        position_mode_even: {position_mode_even},
        position_mode_odd: {position_mode_odd},
        trace: {trace},
        modal_mass: {modal_mass},
        modal_factors: {modal_factors},
        stiffness: {stiffness},
        damping: {damping},
        moments: {moments},
    }};",
        tables.moment_bytes(scalar),
        array(&tables.inertia),
        array(&tables.translation_inverse_pivots),
    );
    text
}

/// Type and value of the table of moments.
fn moments(tables: &LaneTables, scalar: ScalarType) -> Option<(String, String)> {
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
        MomentTables::None => None,
        MomentTables::Whole { eights, fours } => {
            let (pairs, single) = (eights.shape()[0], fours.shape()[0]);
            Some((
                format!("support::lanes::FullTable<{name}, {modes}, {pairs}, {single}>"),
                structure("FullTable", [("eights", eights), ("fours", fours)]),
            ))
        }
        MomentTables::Half { diagonal, below } => {
            let (rows, width, tiles) = (diagonal.shape()[0], diagonal.shape()[2], below.shape()[0]);
            Some((
                format!("support::lanes::HalfTable<{name}, {width}, {rows}, {tiles}>"),
                structure("HalfTable", [("diagonal", diagonal), ("below", below)]),
            ))
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
