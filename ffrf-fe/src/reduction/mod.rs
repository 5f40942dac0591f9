//! From [`FeModel`](crate::FeModel) and [`ModeBasis`](crate::ModeBasis) to [`ffrf_model::ReducedBody`].
