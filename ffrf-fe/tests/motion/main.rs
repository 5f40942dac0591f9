//! Motion in absolute coordinates (ACF), generalised modes (GCMS) and the floating frame: laws and equivalence.
#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking, in its helpers too")]

mod beam;
mod calculix_section;
mod calculix_stress;
mod conservation;
mod elastic_force;
mod equivalence;
mod load_stiffness;
mod marker_loads;
mod modes;
mod oracle;
mod rotating_beam;
mod rotating_cantilever;
mod section;
mod tolerances;
mod validity;
