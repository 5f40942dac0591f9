//! Which position of a marker a force turns the body about, and a constraint turns with.

/// The lever arm of a marker: where the deformed body has it, or where the undeformed body had it.
///
/// A choice of the theory, for [`force_about`](super::force_about) and
/// [`marker_velocity_jacobian`](super::marker_velocity_jacobian); the runtime's loads and joints use the deformed one.
///
/// `Undeformed` is what the paper writes in (199)-(201) and (215). It saves x + Ψ q, 3M multiplications and 3M + 3
/// additions per call (nothing where the position of the marker is needed anyway), and is wrong by Ψ q × f̄ in the moment
/// of a force and by ω × Ψ q in the velocity that a constraint sees: of first order in the deflection over the distance from
/// the frame origin. Energy balances only if force and velocity use the same lever arm, `Deformed`.
/// Measured: `docs/theory/lever_arms.md`, printed by `cargo test -p ffrf --test macro_bodies lever_arms -- --nocapture`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LeverArm {
    /// x + Ψ q: exact. Source: (199)-(201) and (215) with the terms P_fr.
    #[default]
    Deformed,
    /// x: the terms P_fr are dropped. Source: (199)-(201) and (215) as printed.
    Undeformed,
}
