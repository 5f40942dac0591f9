//! Tables and functions as text.

use std::fmt::Write as _;

use super::LaneTables;
use super::tables::{Diagonal, Storage};
use crate::ScalarType;
use crate::emit::literal;
use crate::formulate::KernelKind;

/// Up to this number of modes, the common part of the kernels is inlined into each of them.
const LARGEST_INLINE: usize = 16;

/// The kernels that loops compute; the others cost no more than M operations per entry and stay statements.
pub(crate) const IN_LANES: [KernelKind; 6] = [
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
    let (modes, size, scalar) = (tables.modes, 6 + tables.modes, scalar.name());
    let (coordinates, space, vector) =
        (format!("&[{scalar}; {modes}]"), format!("&[{scalar}; 3]"), format!("[{scalar}; {size}]"));
    let net = match tables.internal {
        Some(_) => "q, q_dot, force",
        None => "q, q_dot, &support::lanes::net_force(force, &internal_force(q, q_dot))",
    };
    // Few modes: one function is fastest. Many: what all kernels share is kept once.
    let inline = if modes <= LARGEST_INLINE { "#[inline(always)]" } else { "#[inline(never)]" };
    let groups = tables.groups;
    let _ = write!(
        text,
        "
    /// What follows from a state before forces are known: deformed invariants and quadratic velocity vector.
    {inline}
    fn state(
        q: {coordinates},
        omega: {space},
        q_dot: {coordinates},
    ) -> support::lanes::State<{scalar}, {groups}> {{
        BODY.state(q, *omega, q_dot)
    }}
"
    );
    for kind in IN_LANES {
        let state = format!("q: {coordinates}, omega: {space}, q_dot: {coordinates}");
        let moving = format!("q: {coordinates}, velocity: {space}, omega: {space}, q_dot: {coordinates}");
        let at = "&state(q, omega, q_dot)";
        let (inputs, result, arguments) = match kind {
            KernelKind::MassMatrix => (
                format!("q: {coordinates}"),
                format!("[{vector}; {size}]"),
                format!("&state(q, &[0.0; 3], &[0.0; {modes}])"),
            ),
            KernelKind::QuadraticVelocity => (state, vector.clone(), at.to_owned()),
            KernelKind::ForwardDynamics => {
                (format!("{state}, force: &{vector}"), vector.clone(), format!("{at}, {net}"))
            }
            KernelKind::EquationsOfMotion => (
                format!("{state}, force: &{vector}"),
                format!("([{vector}; {size}], {vector}, {vector})"),
                format!("{at}, {net}"),
            ),
            KernelKind::AngularMomentum => {
                (moving, format!("[{scalar}; 3]"), format!("{at}, velocity, omega"))
            }
            _ => (moving, scalar.to_owned(), format!("{at}, velocity, omega, q_dot")),
        };
        text.push('\n');
        for line in document(kind) {
            let _ = writeln!(text, "    /// {line}");
        }
        let name = kind.name();
        let _ = write!(
            text,
            "    #[inline]
    fn {name}(
        {},
    ) -> {result} {{
        BODY.{name}({arguments})
    }}
",
            inputs.replace(", ", ",\n        ").replace(",\n        &", ", &")
        );
    }
    text
}

/// The method of the trait that writes its results in place.
pub(crate) fn trait_method(tables: &LaneTables, scalar: ScalarType) -> String {
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
    let (modes, groups, name) = (tables.modes, tables.groups, scalar.name());
    let mut text = String::new();
    let mut item = |name: &str, meaning: &str, kind: String, value: String| {
        let _ = writeln!(text, "    /// {meaning}\n    static {name}: {kind} = {value};\n");
        format!("::core::option::Option::Some(&{name})")
    };
    let none = || "::core::option::Option::None".to_owned();
    let padded = 4 * groups;
    let modal_first_moment = tables.modal_first_moment.as_ref().map_or_else(none, |rows| {
        item(
            "MODAL_FIRST_MOMENT",
            "m b_μ. Units: kg m per unit modal coordinate. Layout: group, axis, lane.",
            format!("[[[{name}; 4]; 3]; {groups}]"),
            lanes(padded, 3, scalar, |mu, k| rows.get(mu).map_or(0.0, |row| row[k])),
        )
    });
    let position_mode_even = tables.position_mode_even.as_ref().map_or_else(none, |rows| {
        item(
            "POSITION_MODE_EVEN",
            "tr T_μ, yy, zz, xy + yx, xz + zx, yz + zy of T_μ. Layout: group, component, lane.",
            format!("[[[{name}; 4]; 6]; {groups}]"),
            lanes(padded, 6, scalar, |mu, k| rows.get(mu).map_or(0.0, |row| row[k])),
        )
    });
    let position_mode_odd = tables.position_mode_odd.as_ref().map_or_else(none, |rows| {
        item(
            "POSITION_MODE_ODD",
            "ϑ_μ. Layout: group, axis, lane.",
            format!("[[[{name}; 4]; 3]; {groups}]"),
            lanes(padded, 3, scalar, |mu, k| rows.get(mu).map_or(0.0, |row| row[k])),
        )
    });
    let mut diagonal = |name: &str, meaning: &str, diagonal: &Diagonal| match diagonal {
        Diagonal::Zero => "support::lanes::Diagonal::Zero".to_owned(),
        Diagonal::Identity => "support::lanes::Diagonal::Identity".to_owned(),
        Diagonal::Entries(entries) => {
            let rows: Vec<String> = (0..groups)
                .map(|g| row(4, scalar, |k| entries.get(4 * g + k).copied().unwrap_or(0.0)))
                .collect();
            let kind = format!("[[{}; 4]; {groups}]", scalar.name());
            item(name, meaning, kind, nested(&rows, 2));
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
    let array = |numbers: &[f64]| row(numbers.len(), scalar, |k| numbers[k]);
    let first_moment = tables
        .first_moment
        .map_or_else(none, |moment| format!("::core::option::Option::Some({})", array(&moment)));
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
    let (modes, name) = (tables.modes, scalar.name());
    let moment = |component, mu, nu| tables.moments.at(component, mu, nu);
    match tables.storage {
        Storage::None => ("()".to_owned(), "()".to_owned()),
        Storage::Whole { pairs, single } => {
            let group = |start: usize, width: usize| {
                let columns: Vec<String> = (0..modes)
                    .map(|nu| {
                        let rows: Vec<String> =
                            (0..8).map(|c| row(width, scalar, |lane| moment(c, start + lane, nu))).collect();
                        nested(&rows, 5)
                    })
                    .collect();
                nested(&columns, 4)
            };
            let eights: Vec<String> = (0..pairs).map(|pair| group(8 * pair, 8)).collect();
            let fours: Vec<String> = (0..single).map(|_| group(8 * pairs, 4)).collect();
            (
                format!("support::lanes::FullTable<{name}, {modes}, {pairs}, {single}>"),
                format!(
                    "support::lanes::FullTable {{\n            eights: {},\n            fours: {},\n        }}",
                    nested(&eights, 3),
                    nested(&fours, 3)
                ),
            )
        }
        Storage::Half { width, rows } => {
            // Diagonal k of a block: row r, column (r + k) mod width.
            let tile = |component: usize, block_row: usize, block_column: usize, indent: usize| {
                let diagonals: Vec<String> = (0..width)
                    .map(|k| {
                        row(width, scalar, |r| {
                            moment(component, width * block_row + r, width * block_column + (r + k) % width)
                        })
                    })
                    .collect();
                nested(&diagonals, indent)
            };
            let diagonal: Vec<String> =
                (0..rows).map(|h| nested(&(0..8).map(|c| tile(c, h, h, 5)).collect::<Vec<_>>(), 4)).collect();
            let mut below = Vec::new();
            for column in 0..rows {
                for components in [0..2, 2..4, 4..5, 5..6, 6..7, 7..8] {
                    for block_row in column + 1..rows {
                        below.extend(components.clone().map(|c| tile(c, block_row, column, 4)));
                    }
                }
            }
            (
                format!("support::lanes::HalfTable<{name}, {width}, {rows}, {}>", below.len()),
                format!(
                    "support::lanes::HalfTable {{\n            diagonal: {},\n            below: {},\n        }}",
                    nested(&diagonal, 3),
                    nested(&below, 3)
                ),
            )
        }
    }
}

/// `[[[lane; 4]; components]; groups]`
fn lanes(padded: usize, components: usize, scalar: ScalarType, at: impl Fn(usize, usize) -> f64) -> String {
    let groups: Vec<String> = (0..padded / 4)
        .map(|g| {
            let rows: Vec<String> =
                (0..components).map(|k| row(4, scalar, |lane| at(4 * g + lane, k))).collect();
            nested(&rows, 3)
        })
        .collect();
    nested(&groups, 2)
}

fn row(count: usize, scalar: ScalarType, at: impl Fn(usize) -> f64) -> String {
    let entries: Vec<String> = (0..count).map(|k| literal(at(k), scalar)).collect();
    format!("[{}]", entries.join(", "))
}

/// The entries in brackets, one a line, at a level of indentation.
fn nested(entries: &[String], level: usize) -> String {
    if entries.is_empty() {
        return "[]".to_owned();
    }
    let indent = "    ".repeat(level);
    let mut text = String::from("[\n");
    for entry in entries {
        let _ = writeln!(text, "{indent}{entry},");
    }
    let _ = write!(text, "{}]", "    ".repeat(level - 1));
    text
}
