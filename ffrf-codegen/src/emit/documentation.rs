//! The doc comments of generated functions.

use crate::formulate::KernelKind;

/// What it is, shape, units, frame and source, one line each.
pub(super) fn of(kind: KernelKind, mode_count: usize) -> Vec<String> {
    let size = 6 + mode_count;
    let columns = format!("{size} x {size}, symmetric, column by column");
    let vector = format!("{size}: translation 3, rotation 3, modes {mode_count}");
    let modal = format!("{mode_count} x {mode_count}, symmetric, column by column");
    let units = "kg, kg m, kg m² and their modal kin";
    let forces = "N, N m, modal forces";
    let (title, shape, units, source) = match kind {
        KernelKind::MassMatrix => ("Mass matrix M(q).", columns, units, "(203), body-resolved"),
        KernelKind::QuadraticVelocity => (
            "Quadratic velocity vector Q(q, ω, q̇), on the left-hand side.",
            vector,
            forces,
            "(209), signs and index order corrected",
        ),
        KernelKind::ForwardDynamics => (
            "Accelerations [α; ω̇; q̈] under a generalised force, elastic and damping forces included.",
            vector,
            "m/s², rad/s², 1/s²",
            "(203), q̈ eliminated first, the mass matrix never formed",
        ),
        KernelKind::EquationsOfMotion => (
            "Mass matrix, quadratic velocity vector and accelerations in one pass.",
            format!("{size} x {size}, {size}, {size}"),
            "as of the three",
            "(203), (209)",
        ),
        KernelKind::KineticEnergy => {
            ("Kinetic energy.", "scalar".to_owned(), "J", "½ (v · P + ω · L + q̇ · p)")
        }
        KernelKind::ElasticEnergy => ("Elastic energy.", "scalar".to_owned(), "J", "½ qᵀ K q"),
        KernelKind::LinearMomentum => ("Linear momentum.", "3".to_owned(), "N s", "m v + ω × m r + m B q̇"),
        KernelKind::AngularMomentum => {
            ("Angular momentum about the frame origin.", "3".to_owned(), "N m s", "m r × v + Θ_rr ω + Θ_rf q̇")
        }
        KernelKind::InternalForce => (
            "Elastic and damping forces, on the left-hand side.",
            mode_count.to_string(),
            "modal forces",
            "K q + D q̇",
        ),
        KernelKind::GravityForce => {
            ("Generalised force of uniform gravity g.", vector, forces, "[m g; m r × g; m b_μ · g]")
        }
        KernelKind::StiffnessMatrix => {
            ("Modal stiffness K_ff.", modal, "modal force per unit modal coordinate", "Ψᵀ K Ψ")
        }
        KernelKind::DampingMatrix => {
            ("Modal damping D_ff.", modal, "modal force per unit modal rate", "the model")
        }
        KernelKind::AccelerationJacobian => (
            "Accelerations w and their derivatives with respect to q, q̇, ω and force; that to the velocity is zero.",
            format!("{size}; columns of {size}: {mode_count}, {mode_count}, 3, {size}"),
            "those of w, per unit of the variable",
            "∂w/∂x = -M⁻¹ ∂R/∂x (implicit function theorem), ∂w/∂force = M⁻¹",
        ),
        KernelKind::ResidualJacobian => (
            "Residual M w + Q + K q + D q̇ - force and its derivatives with respect to q, q̇, ω and w.",
            format!("{size}; columns of {size}: {mode_count}, {mode_count}, 3, {size}"),
            "those of forces, per unit of the variable",
            "(203), differentiated symbolically; ∂R/∂w = M, ∂R/∂force = -I, ∂R/∂v = 0",
        ),
    };
    vec![
        title.to_owned(),
        String::new(),
        format!("Shape: {shape}. Units: {units}. Frame: body."),
        format!("Source: {source}."),
    ]
}
