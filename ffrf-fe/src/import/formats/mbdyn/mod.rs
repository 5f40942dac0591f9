//! MBDyn's modal data files, which hold a reduced body.

mod read;
mod records;

pub use read::read_mbdyn;
