//! The sources in C that an FMU may hold.

/// The sources of an FMU.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sources {
    /// Name in the folder `sources`, and text; what is compiled comes first.
    pub files: Vec<(String, String)>,
    /// How many of the files are compiled.
    pub compiled: usize,
    /// What tells FMUs apart: two with the same token do the same.
    pub token: String,
}
