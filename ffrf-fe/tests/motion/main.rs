//! Motion in absolute coordinates (ACF), generalised modes (GCMS) and the floating frame: laws and equivalence.
#![allow(clippy::expect_used, reason = "a test fails by panicking, in its helpers too")]

mod beam;
mod conservation;
mod elastic_force;
mod equivalence;
mod modes;
mod oracle;
mod tolerances;
mod validity;
