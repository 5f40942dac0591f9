//! Writers of reduced bodies in the formats of other multibody programs.

pub mod mbdyn;
pub mod sid;
