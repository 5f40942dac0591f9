//! Constant tables as static items.

use crate::ScalarType;
use crate::emit::literal::literal;
use crate::emit::writer::Writer;
use crate::lanes::{LaneTables, ModalFactors, ModalMatrix, MomentTables, Table};

const NONE: &str = "::core::option::Option::None";

/// Writes the tables, and the body in lanes that refers to them.
pub(super) fn statics(writer: &mut Writer, tables: &LaneTables, scalar: ScalarType) {
    let mut items = Items { writer, scalar };
    let modal_first_moment = items.optional(
        "MODAL_FIRST_MOMENT",
        "m b_μ. Units: kg m per unit modal coordinate. Layout: group, axis, lane.",
        tables.modal_first_moment.as_ref(),
    );
    let position_mode_even = items.optional(
        "POSITION_MODE_EVEN",
        "tr T_μ, yy, zz, xy + yx, xz + zx, yz + zy of T_μ. Layout: group, component, lane.",
        tables.position_mode_even.as_ref(),
    );
    let position_mode_odd = items.optional(
        "POSITION_MODE_ODD",
        "ϑ_μ. Layout: group, axis, lane.",
        tables.position_mode_odd.as_ref(),
    );
    let eliminated_first_moment = if tables.eliminated_first_moment == tables.modal_first_moment {
        modal_first_moment.clone()
    } else {
        items.optional(
            "ELIMINATED_FIRST_MOMENT",
            "L⁻¹ (m B)ᵀ with Θ_ff = L D Lᵀ. Layout: group, axis, lane.",
            tables.eliminated_first_moment.as_ref(),
        )
    };
    let modal_mass = items.matrix("MODAL_MASS", "Θ_ff", &tables.modal_mass);
    let trace = if tables.trace == tables.modal_mass {
        modal_mass.clone()
    } else {
        items.matrix("TRACE", "tr T_μν", &tables.trace)
    };
    let stiffness = items.matrix("STIFFNESS", "K_ff", &tables.stiffness);
    let damping = items.matrix("DAMPING", "D_ff", &tables.damping);
    let modal_factors = items.factors(&tables.modal_factors);
    let second_order_odd = items.optional(
        "SECOND_ORDER_ODD",
        "-ϑ(Γ_μν), geometric stiffness of angular acceleration. Layout: group, mode, axis, lane.",
        tables.second_order_odd.as_ref(),
    );
    let moments = items.moments(tables);
    let array = |numbers: &[f64]| row(numbers, scalar);
    let list = |numbers: Option<[f64; 3]>| numbers.map_or(NONE.to_owned(), |numbers| some(&array(&numbers)));
    let translation_factors = format!(
        "support::lanes::Factors {{\n    inverse_pivots: {},\n    lower: {},\n}}",
        array(&tables.translation_inverse_pivots),
        list(tables.translation_lower)
    );
    let (modes, groups, name) = (tables.modes, tables.groups, scalar.constant_type_name());
    let (kind, moments) = match moments {
        Some(kind) => (format!("&{kind}"), "&MOMENTS"),
        None => ("()".to_owned(), "()"),
    };
    let bytes = tables.moment_bytes(scalar);
    writer.documentation([format!(
        "The body in lanes: {groups} groups of 4 for {modes} modes; table of moments {bytes} bytes."
    )]);
    // A constant, so that other crates that use the body see what is left out; its tables stand once, in statics.
    let head = format!(
        "const BODY: support::lanes::LaneBody<{name}, {modes}, {groups}, {kind}> = support::lanes::LaneBody {{"
    );
    writer.block(&head, "};", |writer| {
        for (field, value) in [
            ("registers", "support::lanes::Compiled".to_owned()),
            ("mass", literal(tables.mass, scalar)),
            ("first_moment", list(tables.first_moment)),
            ("modal_first_moment", modal_first_moment),
            ("inertia", array(&tables.inertia)),
            ("translation_factors", translation_factors),
            ("eliminated_first_moment", eliminated_first_moment),
            ("position_mode_even", position_mode_even),
            ("position_mode_odd", position_mode_odd),
            ("trace", trace),
            ("modal_mass", modal_mass),
            ("modal_factors", modal_factors),
            ("stiffness", stiffness),
            ("damping", damping),
            ("moments", moments.to_owned()),
            ("second_order_odd", second_order_odd),
        ] {
            writer.line(format!("{field}: {value},"));
        }
    });
}

/// Static items, and how the body refers to them.
struct Items<'a> {
    writer: &'a mut Writer,
    scalar: ScalarType,
}

impl Items<'_> {
    fn item(&mut self, name: &str, meaning: &str, table: &Table) {
        let kind = array_type(table.shape(), self.scalar);
        self.writer.documentation([meaning]);
        self.writer.line(format!("static {name}: {kind} = {};", nested(table, self.scalar)));
        self.writer.blank();
    }

    fn optional(&mut self, name: &str, meaning: &str, table: Option<&Table>) -> String {
        match table {
            Some(table) => {
                self.item(name, meaning, table);
                some(&format!("&{name}"))
            }
            None => NONE.to_owned(),
        }
    }

    fn matrix(&mut self, name: &str, meaning: &str, matrix: &ModalMatrix) -> String {
        match matrix {
            ModalMatrix::Zero => "support::lanes::ModalMatrix::Zero".to_owned(),
            ModalMatrix::Identity => "support::lanes::ModalMatrix::Identity".to_owned(),
            ModalMatrix::Diagonal(table) => {
                self.item(name, &format!("{meaning}. Layout: group, lane."), table);
                format!("support::lanes::ModalMatrix::Diagonal(&{name})")
            }
            ModalMatrix::Dense(table) => {
                self.item(name, &format!("{meaning}. Layout: group, mode, lane."), table);
                format!("support::lanes::ModalMatrix::Dense(&{name})")
            }
        }
    }

    fn factors(&mut self, factors: &ModalFactors) -> String {
        let kind = "support::lanes::ModalFactors";
        match factors {
            ModalFactors::Identity => format!("{kind}::Identity"),
            ModalFactors::Diagonal(table) => {
                self.item("INVERSE_MODAL_MASS", "Θ_ff⁻¹. Layout: group, lane.", table);
                format!("{kind}::Diagonal(&INVERSE_MODAL_MASS)")
            }
            ModalFactors::Triangular { inverse_pivots, lower } => {
                self.item("INVERSE_PIVOTS", "D⁻¹ with Θ_ff = L D Lᵀ. Layout: group, lane.", inverse_pivots);
                self.item("LOWER", "L + Lᵀ without its diagonal. Layout: group, mode, lane.", lower);
                format!("{kind}::Triangular {{ inverse_pivots: &INVERSE_PIVOTS, lower: &LOWER }}")
            }
        }
    }

    /// The table of moments, if there is one; returns its type.
    fn moments(&mut self, tables: &LaneTables) -> Option<String> {
        let (modes, name) = (tables.modes, self.scalar.constant_type_name());
        let (kind, generics, fields) = match &tables.moments {
            MomentTables::None => return None,
            MomentTables::Whole { eights, fours } => {
                let (pairs, single) = (eights.shape()[0], fours.shape()[0]);
                let generics = format!("<{name}, {modes}, {pairs}, {single}>");
                ("support::lanes::FullTable", generics, [("eights", eights), ("fours", fours)])
            }
            MomentTables::Half { diagonal, below } => {
                let (rows, width, tiles) = (diagonal.shape()[0], diagonal.shape()[2], below.shape()[0]);
                let generics = format!("<{name}, {width}, {rows}, {tiles}>");
                ("support::lanes::HalfTable", generics, [("diagonal", diagonal), ("below", below)])
            }
        };
        self.writer.documentation(["T_νμ in the order in which the loops read them."]);
        self.writer.block(&format!("static MOMENTS: {kind}{generics} = {kind} {{"), "};", |writer| {
            for (field, table) in fields {
                writer.line(format!("{field}: {},", nested(table, self.scalar)));
            }
        });
        self.writer.blank();
        Some(format!("{kind}{generics}"))
    }
}

fn some(value: &str) -> String {
    format!("::core::option::Option::Some({value})")
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

/// A table in brackets, an innermost array a line.
fn nested(table: &Table, scalar: ScalarType) -> String {
    fn write(shape: &[usize], entries: &[f64], level: usize, scalar: ScalarType, text: &mut String) {
        match shape {
            [] | [0, ..] => text.push_str("[]"),
            [_] => text.push_str(&row(entries, scalar)),
            [count, inner @ ..] => {
                text.push_str("[\n");
                for part in entries.chunks((entries.len() / count).max(1)) {
                    text.push_str(&"    ".repeat(level + 1));
                    write(inner, part, level + 1, scalar, text);
                    text.push_str(",\n");
                }
                text.push_str(&"    ".repeat(level));
                text.push(']');
            }
        }
    }
    let mut text = String::new();
    write(table.shape(), table.entries(), 0, scalar, &mut text);
    text
}
