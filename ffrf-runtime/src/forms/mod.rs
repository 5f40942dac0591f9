//! The paper's two forms of the equations of motion, made from the body-resolved one that the kernels compute.
//!
//! | form | unknowns | source |
//! | --- | --- | --- |
//! | body-resolved | [Aᵀp̈; ω̇; q̈], ω in the body frame | `docs/theory/README.md`; [`FlexibleBody`](crate::FlexibleBody) |
//! | [`InertialForm`] | [p̈; A ω̇; q̈] | (203) with (204)-(209), corrected |
//! | [`EulerParameterForm`] | [p̈; θ̈; q̈] | (214)-(217), corrected |
//!
//! Both are congruence transformations: with w = Z y + (terms without y), the mass matrix becomes Zᵀ M Z and forces
//! become Zᵀ f. No extra velocity terms arise: A ω̇ is the whole rate of the inertial components of ω, because
//! ω × ω = 0, and ω̇ = Ḡ θ̈ because Ḡ̇ θ̇ = 0. For time integration the body-resolved form is the cheaper one.

mod euler_parameters;
mod inertial;

pub use euler_parameters::{EulerParameterForm, angular_velocity_matrix};
pub use inertial::{InertialForm, to_body, to_inertial};
