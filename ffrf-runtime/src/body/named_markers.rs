//! Markers by name, for bodies that have some.

use nalgebra::RealField;

use super::{FlexibleBody, Marker, SectionMarker, StressMarker};

/// The markers of a body by their names in the model. Generated bodies have each as a constant as well.
pub trait NamedMarkers<T: RealField + Copy = f64>: FlexibleBody<T> {
    /// The names, in the order of the model.
    fn marker_names(&self) -> &'static [&'static str];
    /// The marker called `name`, or `None`. A search by name: look markers up before the simulation starts.
    fn marker(&self, name: &str) -> Option<Marker<Self::Modal, T>>;
    /// The names of the stress markers, in the order of the model.
    fn stress_marker_names(&self) -> &'static [&'static str] {
        &[]
    }
    /// The stress marker called `name`, or `None`.
    fn stress_marker(&self, name: &str) -> Option<StressMarker<Self::Modal, T>> {
        let _ = name;
        None
    }
    /// The names of the section markers, in the order of the model.
    fn section_marker_names(&self) -> &'static [&'static str] {
        &[]
    }
    /// The section marker called `name`, or `None`.
    fn section_marker(&self, name: &str) -> Option<SectionMarker<Self::Modal, T>> {
        let _ = name;
        None
    }
}
