//! The numbers of a mechanism as constant tables of C.

mod bodies;
mod compliance;
mod composition;
mod constants;
mod forces;
mod numbers;
mod places;

pub(super) use self::bodies::prepare;
pub(super) use self::constants::constants;
pub(super) use self::numbers::Numbers;
use super::MechanismSubject;

/// The tables.
pub(super) fn tables(subject: &MechanismSubject<'_>, numbers: &Numbers) -> String {
    let mut text = format!("static const real gravity[3] = {};\n\n", numbers.list(&subject.model.gravity));
    text.push_str(&bodies::bodies(subject, numbers));
    text.push_str(&places::places(subject, numbers));
    text.push_str(&forces::forces(subject, numbers));
    text.push_str(&forces::sensors(subject, numbers));
    text.push_str(&bodies::beginning(subject, numbers));
    text.push_str(&composition::composition(subject, numbers));
    text
}
