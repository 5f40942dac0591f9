//! The method `check` of a body whose invariants come at run time: which checks its layout asks for.

use super::parameters::fields;
use crate::GenerateOptions;
use crate::emit::writer::Writer;
use crate::invariants::{Invariant, Structure};
use crate::layout::Layout;

const DOCUMENTATION: &str = "\
Whether the invariants can be those of a body: call it once, before the simulation.

In this order: every number is finite; m > 0; T is symmetric without a negative direction, its inertia tensor
positive definite; Θ_ff = [tr T_μν] is what the layout says and positive definite; T_μ and T_μν mirror
themselves as the layout says, and T_νμ = T_μνᵀ; K_ff and D_ff are symmetric and not negative on the
diagonal; the mass matrix at q = 0 is positive definite, so no mode is rigid motion or follows from others.
Relative to their size, numbers agree within 1e-9 (single precision 2e-6); a pivot counts as positive above
1e-13 for rigid motion and above 1e-10 for modes (single precision 2e-6). That T_μν come from one field of
displacements is not checked beyond this. Only the entries that the layout leaves open are known here.

Errors: the first that is wrong, with field, index, the number found and what was expected. Panics: never.";

/// `impl NAME { pub fn check }`: calls into the runtime, one per field and property.
pub(super) fn inherent_method(
    writer: &mut Writer,
    mode_count: usize,
    layout: &Layout,
    options: &GenerateOptions,
) {
    let (scalar, size) = (options.scalar.constant_type_name(), 6 + mode_count);
    writer.line("#[allow(dead_code, clippy::all, clippy::pedantic, clippy::nursery)]");
    writer.block(&format!("impl {} {{", options.name), "}", |writer| {
        writer.documentation(DOCUMENTATION.lines());
        let head = "pub fn check(&self) -> ::core::result::Result<(), ::ffrf::InvariantError> {";
        writer.block(head, "}", |writer| {
            writer.line("use ::ffrf::generated_support::checks;");
            for invariant in fields(layout) {
                writer.line(format!("checks::finite(\"{0}\", &self.{0})?;", invariant.name()));
            }
            for call in properties(mode_count, layout) {
                writer.line(call);
            }
            writer.line(format!(
                "let undeformed = ::ffrf::nalgebra::SVector::<{scalar}, {mode_count}>::zeros();"
            ));
            writer.line(format!(
                "checks::mass_matrix(&::ffrf::DenseForms::<{mode_count}, {size}, {scalar}>::mass_matrix(self, &undeformed))"
            ));
        });
    });
}

/// The checks of single invariants. Θ_ff comes before the moments that are measured by it.
fn properties(mode_count: usize, layout: &Layout) -> Vec<String> {
    use Invariant::{
        Damping, FirstMoment, LinearLoadStiffness, Mass, ModalFirstMoment, ModalMass, ModeModeMoment,
        PositionModeMoment, SecondMoment, Stiffness, UniformLoadStiffness,
    };
    let order = [
        Mass,
        SecondMoment,
        ModalMass,
        PositionModeMoment,
        ModeModeMoment,
        Stiffness,
        Damping,
        UniformLoadStiffness,
        LinearLoadStiffness,
    ];
    let mut calls = Vec::new();
    for invariant in order {
        let (name, structure) = (invariant.name(), layout[invariant]);
        match invariant {
            ModalMass => {
                let check = modal_mass(layout);
                calls.push(format!("let _modal_mass: [f64; {mode_count}] = checks::{check};"));
            }
            _ if !layout.is_data(invariant) => {}
            Mass => calls.push(format!("checks::mass(self.{name})?;")),
            SecondMoment => {
                calls.push(format!("let _second_moment_trace = checks::second_moment(&self.{name})?;"));
            }
            PositionModeMoment => calls.push(format!(
                "checks::position_mode_moment(&self.{name}, {}, _second_moment_trace, &_modal_mass)?;",
                mirror(structure)
            )),
            ModeModeMoment => calls.push(format!(
                "checks::mode_mode_moment(&self.{name}, {}, &_modal_mass)?;",
                mirror(structure)
            )),
            Stiffness | Damping => {
                calls.push(format!("checks::modal_matrix(\"{name}\", &self.{name})?;"));
            }
            UniformLoadStiffness | LinearLoadStiffness => {
                calls.push(format!("checks::load_stiffness(\"{name}\", &self.{name})?;"));
            }
            // Any finite vector can be one of these.
            FirstMoment | ModalFirstMoment => {}
        }
    }
    calls
}

/// Where the diagonal of Θ_ff comes from.
fn modal_mass(layout: &Layout) -> String {
    let moments = Invariant::ModeModeMoment;
    if layout.is_data(Invariant::ModalMass) {
        "modal_mass(&self.modal_mass)?".to_owned()
    } else if layout.is_data(moments) && layout[moments] != Structure::Antisymmetric {
        let declared = match layout[Invariant::ModalMass] {
            Structure::Identity => "Identity",
            Structure::Diagonal => "Diagonal",
            _ => "Symmetric",
        };
        format!("modal_mass_of_moments(&self.{}, checks::ModalMass::{declared})?", moments.name())
    } else {
        "unit_modal_mass()".to_owned()
    }
}

fn mirror(structure: Structure) -> &'static str {
    match structure {
        Structure::Diagonal | Structure::Symmetric => "checks::Mirror::Symmetric",
        Structure::Antisymmetric => "checks::Mirror::Antisymmetric",
        _ => "checks::Mirror::Dense",
    }
}
