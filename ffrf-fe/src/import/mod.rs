//! Readers: files of FE codes to [`FeModel`](crate::FeModel).
