//! The method `check` of a body whose invariants come at run time: which checks its layout asks for.

use super::parameters::fields;
use crate::GenerateOptions;
use crate::layout::{Layout, Structure};

/// `impl NAME { pub fn check }`: calls into the runtime, one per field and property.
pub(super) fn inherent_method(mode_count: usize, layout: &Layout, options: &GenerateOptions) -> String {
    let scalar = options.scalar.constant_type_name();
    let names: Vec<&str> = fields(mode_count, layout, scalar).into_iter().map(|(name, ..)| name).collect();
    let has = |name: &str| names.contains(&name);
    let mut lines: Vec<String> =
        names.iter().map(|name| format!("checks::finite(\"{name}\", &self.{name})?;")).collect();
    lines.push("checks::mass(self.mass)?;".to_owned());
    lines.push("let _second_moment_trace = checks::second_moment(&self.second_moment)?;".to_owned());
    let modal_mass = if has("modal_mass") {
        "modal_mass(&self.modal_mass)?".to_owned()
    } else if has("mode_mode_moment") && !matches!(layout.mode_mode_moment, Structure::Antisymmetric) {
        let declared = match layout.modal_mass {
            Structure::Identity => "Identity",
            Structure::Diagonal => "Diagonal",
            _ => "Symmetric",
        };
        format!("modal_mass_of_moments(&self.mode_mode_moment, checks::ModalMass::{declared})?")
    } else {
        "unit_modal_mass()".to_owned()
    };
    lines.push(format!("let _modal_mass: [f64; {mode_count}] = checks::{modal_mass};"));
    if has("position_mode_moment") {
        lines.push(format!(
            "checks::position_mode_moment(&self.position_mode_moment, {}, _second_moment_trace, &_modal_mass)?;",
            mirror(layout.position_mode_moment)
        ));
    }
    if has("mode_mode_moment") {
        lines.push(format!(
            "checks::mode_mode_moment(&self.mode_mode_moment, {}, &_modal_mass)?;",
            mirror(layout.mode_mode_moment)
        ));
    }
    for name in ["stiffness", "damping"] {
        if has(name) {
            lines.push(format!("checks::modal_matrix(\"{name}\", &self.{name})?;"));
        }
    }
    let size = 6 + mode_count;
    lines.push(format!("let undeformed = ::ffrf::nalgebra::SVector::<{scalar}, {mode_count}>::zeros();"));
    lines.push(format!(
        "checks::mass_matrix(&::ffrf::FlexibleBody::<{mode_count}, {size}, {scalar}>::mass_matrix(self, &undeformed))"
    ));
    format!(
        "#[allow(dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl {} {{
    /// Whether the invariants can be those of a body: call it once, before the simulation.
    ///
    /// In this order: every number is finite; m > 0; T is symmetric without a negative direction, its inertia tensor
    /// positive definite; Θ_ff = [tr T_μν] is what the layout says and positive definite; T_μ and T_μν mirror
    /// themselves as the layout says, and T_νμ = T_μνᵀ; K_ff and D_ff are symmetric and not negative on the
    /// diagonal; the mass matrix at q = 0 is positive definite, so no mode is rigid motion or follows from others.
    /// Relative to their size, numbers agree within 1e-9 (single precision 2e-6); a pivot counts as positive above
    /// 1e-13 for rigid motion and above 1e-10 for modes (single precision 2e-6). That T_μν come from one field of
    /// displacements is not checked beyond this. Only the entries that the layout leaves open are known here.
    ///
    /// Errors: the first that is wrong, with field, index, the number found and what was expected. Panics: never.
    pub fn check(&self) -> ::core::result::Result<(), ::ffrf::InvariantError> {{
        use ::ffrf::generated_support::checks;
        {}
    }}
}}
",
        options.name,
        lines.join("\n        ")
    )
}

fn mirror(structure: Structure) -> &'static str {
    match structure {
        Structure::Diagonal | Structure::Symmetric => "checks::Mirror::Symmetric",
        Structure::Antisymmetric => "checks::Mirror::Antisymmetric",
        _ => "checks::Mirror::Dense",
    }
}
