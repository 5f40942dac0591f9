//! The implementations of the traits: nalgebra outside, arrays inside.

use super::in_place::{self, is_in_place};
use super::lanes;
use super::markers;
use super::method::{Types, method};
use crate::ScalarType;
use crate::emit::Subject;
use crate::emit::listing::Listing;
use crate::emit::writer::Writer;
use crate::fidelity::EnergyTerm;
use crate::formulate::{Interface, JACOBIANS, KERNELS, Signature};
use crate::invariants::Invariant;

/// One implementation for each trait; for every scalar if the body is generic.
///
/// `listings` are the kernels that are printed as statements; a matrix over the modes may be a diagonal there.
pub(super) fn implementations(writer: &mut Writer, subject: &Subject<'_>, listings: &[Listing]) {
    let types = Types::of(subject);
    let signatures: Vec<(Interface, Signature)> = KERNELS
        .iter()
        .chain(&JACOBIANS)
        .map(|definition| {
            let printed = listings.iter().find(|listing| listing.signature.name == definition.signature.name);
            (definition.interface, printed.map_or(definition.signature, |listing| listing.signature))
        })
        .collect();
    let block = |writer: &mut Writer, interface: Interface, more: &dyn Fn(&mut Writer)| {
        let members: Vec<&Signature> = signatures
            .iter()
            .filter(|(known, _)| *known == interface)
            .map(|(_, signature)| signature)
            .collect();
        implementation(writer, subject, &types.trait_path(interface), |writer| {
            if interface == Interface::FlexibleBody {
                associated(writer, &types);
            }
            for (position, signature) in members.iter().enumerate() {
                if position > 0 || interface == Interface::FlexibleBody {
                    writer.blank();
                }
                let is_printed = listings.iter().any(|listing| listing.signature.name == signature.name);
                if is_printed && is_in_place(signature) {
                    in_place::methods(writer, &types, interface, signature);
                } else {
                    let takes_registers =
                        !is_printed && lanes::takes_registers(subject.lanes, subject.options.scalar);
                    method(writer, &types, interface, signature, takes_registers);
                }
            }
            more(writer);
        });
    };
    block(writer, Interface::FlexibleBody, &|writer| {
        stiffened(writer, subject);
        stable_step(writer, subject);
        markers::bent_marker(writer, subject, &types.marker(), &types.modal());
    });
    writer.blank();
    block(writer, Interface::Observables, &|_| {});
    writer.blank();
    block(writer, Interface::DenseForms, &|writer| {
        if let Some(lanes) = subject.lanes {
            lanes::trait_method(writer, &types, lanes, subject.options.scalar);
        }
    });
    writer.blank();
    implementation(writer, subject, &format!("::ffrf::NamedMarkers<{}>", types.scalar), |writer| {
        markers::trait_methods(writer, subject, &types.marker());
    });
    if subject.options.jacobians {
        writer.blank();
        block(writer, Interface::FlexibleBodyJacobians, &|_| {});
    }
}

fn implementation(writer: &mut Writer, subject: &Subject<'_>, path: &str, write: impl FnOnce(&mut Writer)) {
    let options = subject.options;
    writer.line("#[automatically_derived]");
    writer.block(&format!("impl{} {path} for {} {{", options.scalar.generics(), options.name), "}", write);
}

/// The type of modal vectors, and their zero.
fn associated(writer: &mut Writer, types: &Types) {
    writer.line(format!("type Modal = {};", types.modal()));
    writer.blank();
    writer.line("#[inline]");
    writer.block(&format!("fn undeformed(&self) -> {} {{", types.modal()), "}", |writer| {
        writer.line("::ffrf::nalgebra::SVector::zeros()");
    });
}

/// The method that tells that the stress of accelerations changes the stiffness, where it does.
fn stiffened(writer: &mut Writer, subject: &Subject<'_>) {
    let layout = &subject.report.layout;
    let of = |invariant, term| layout.is_data(invariant) && subject.options.fidelity.keeps(term);
    let is_stiffened = of(Invariant::LinearLoadStiffness, EnergyTerm::AngularAccelerationStiffening)
        || of(Invariant::UniformLoadStiffness, EnergyTerm::LinearAccelerationStiffening);
    if is_stiffened {
        writer.blank();
        writer.line("#[inline]");
        writer.block("fn is_stiffened(&self) -> bool {", "}", |writer| writer.line("true"));
    }
}

/// The method that knows the largest stable step of a body whose numbers are known and which vibrates.
fn stable_step(writer: &mut Writer, subject: &Subject<'_>) {
    let step = subject.model.and_then(|model| model.largest_stable_step());
    if step.is_none_or(|step| !step.is_finite()) {
        return;
    }
    let scalar = subject.options.scalar;
    let step = match scalar {
        ScalarType::F64 => "Self::LARGEST_STABLE_STEP".to_owned(),
        ScalarType::F32 => "Self::LARGEST_STABLE_STEP as f32".to_owned(),
        ScalarType::Generic => "support::constant(Self::LARGEST_STABLE_STEP)".to_owned(),
    };
    writer.blank();
    writer.line("#[inline]");
    let head = format!("fn largest_stable_step(&self) -> ::core::option::Option<{}> {{", scalar.type_name());
    writer.block(&head, "}", |writer| writer.line(format!("::core::option::Option::Some({step})")));
}
