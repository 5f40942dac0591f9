//! Motion in absolute coordinates (ACF), generalised modes (GCMS) and the floating frame: laws and equivalence.

mod beam;
mod conservation;
mod elastic_force;
mod equivalence;
mod modes;
mod tolerances;
