//! One reader per file format. Matrix files are told apart by [`matrix_file`], node files by what the user names.

pub(crate) mod ansys;
mod body;
pub(crate) mod calculix;
pub(crate) mod deck;
mod dense_matrix;
mod listed_matrix;
pub(crate) mod matrix_file;
mod matrix_market;
mod mbdyn;
pub(crate) mod mesh;
pub(crate) mod nastran;
mod npy_header;
mod npz_archive;
pub(crate) mod numpy;
mod sid;
pub(crate) mod text_table;

pub use dense_matrix::{read_mode_shapes, read_square_matrix};
pub use matrix_file::read_matrix;
pub use mbdyn::read_mbdyn;
pub use sid::read_sid;
