//! Speed for accuracy: one scene in many configurations, their errors against a reference and what they cost.
//!
//! ```text
//! Study (scene, all modes) ──Reference (error control, own error known)──┐
//!   └─ Variant (modes, fidelity) ── run (scalar, integrator, step) ── History ── errors, cost ── Outcome
//! ```
//!
//! Which outcomes are kept, and where, is the caller's business: [`sweep`] asks for none that is there already.

mod bounds;
mod channel;
mod configuration;
mod cost;
mod effort;
mod error;
mod front;
mod held;
mod march;
mod modes;
mod outcome;
mod plan;
mod reference;
mod scene_modes;
mod study;
mod sweep;
mod trajectory;
mod usual;

pub use bounds::{ForceSize, MotionLimits, term_bound};
pub use channel::{Channel, Quantity};
pub use configuration::{Axes, Configuration};
pub use cost::StaticCost;
pub use error::TradeoffError;
pub use front::front;
pub use modes::Modes;
pub use outcome::{Finding, INSTRUCTIONS_PER_OPERATION, Measured, Outcome, run};
pub use plan::{
    Affordable, Candidate, Choice, ModeUse, Motion, Operations, Pilot, Plan, PlanOptions, PlanWithin,
    Ranking, StepBudget, TermUse, Truncation, plan, plan_again_within, plan_within,
};
pub use reference::{Reference, ReferenceOptions};
pub use scene_modes::{ModeValues, SceneModes};
pub use study::{Study, Variant};
pub use sweep::{Done, sweep};
pub use trajectory::History;
