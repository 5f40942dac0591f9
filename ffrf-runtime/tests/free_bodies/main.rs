//! Free bodies in motion: the laws of their motion, and what each integrator keeps, reports and refuses.

mod flexible_body;
mod held_origin;
mod implicit_methods;
mod pair;
mod reference_trajectory;
mod refusals;
mod rigid_body;
mod single_precision;
mod step_report;
mod stiff_modes;
