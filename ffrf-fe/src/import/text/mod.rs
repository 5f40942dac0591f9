//! Bytes of a file and the numbers in them: whole files with their hash and place in messages, tokens, decimals.

pub(crate) mod compressed;
pub(crate) mod cursor;
pub(crate) mod ordinary;
mod provenance;
pub(crate) mod source;

pub use provenance::source_file;
