//! What a linearly implicit stage adds to an evaluation.

/// What a linearly implicit stage adds to an evaluation.
#[derive(Debug)]
pub struct ImplicitTerms<'a, I, T> {
    /// γ h. Units: s.
    pub gamma_h: T,
    /// What is subtracted from the rates.
    pub subtracted: Option<&'a I>,
    /// With soft rows: the increment that has led to the state, in whose chart the rates of all places see the end of the stage.
    pub chart: Option<&'a I>,
}

impl<I, T: Copy> Clone for ImplicitTerms<'_, I, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<I, T: Copy> Copy for ImplicitTerms<'_, I, T> {}
