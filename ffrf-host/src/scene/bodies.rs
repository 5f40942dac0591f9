//! Bodies of a scene and their initial states.

use std::path::Path;

use ffrf_codegen::fidelity::Fidelity;
use ffrf_model::ReducedBody;
use ffrf_runtime::{FlexibleBody, State, rotation};
use nalgebra::{DVector, Matrix3, Vector3};

use super::file::{BodyTable, FidelityValue};
use super::names::NamedBody;
use super::{SceneError, SceneModel};
use crate::{HostBody, HostModal};

/// The body of a table, with its model file looked for in `folder`, and its initial state.
pub(super) fn body(
    name: &str,
    table: &BodyTable,
    folder: &Path,
) -> Result<(NamedBody, State<HostModal>), SceneError> {
    let key = format!("bodies.{name}");
    let named = match (&table.model, table.mass) {
        (Some(model), None) => flexible(name, &key, table, &folder.join(model))?,
        (None, Some(mass)) => rigid(name, &key, table, mass)?,
        (Some(_), Some(_)) => {
            return Err(SceneError::value(key, "either `model` (flexible) or `mass` (rigid)", "both"));
        }
        (None, None) => {
            return Err(SceneError::value(key, "either `model` (flexible) or `mass` (rigid)", "neither"));
        }
    };
    let state = state(&key, table, &named.body)?;
    Ok((named, state))
}

fn flexible(name: &str, key: &str, table: &BodyTable, path: &Path) -> Result<NamedBody, SceneError> {
    for (given, what) in [
        (table.center_of_mass.is_some(), "center_of_mass"),
        (table.inertia.is_some(), "inertia"),
        (!table.markers.is_empty(), "markers"),
    ] {
        if given {
            return Err(SceneError::value(
                format!("{key}.{what}"),
                "nothing: the model has its own",
                "a value",
            ));
        }
    }
    let refused = |source| SceneError::Model {
        key: format!("{key}.model"),
        path: path.to_owned(),
        source: Box::new(source),
    };
    let mut model = ReducedBody::read(path).map_err(refused)?;
    if let Some(modes) = &table.modes {
        model = model.with_selected_modes(&modes.0).map_err(refused)?;
    }
    let fidelity = fidelity(key, table.fidelity.as_ref())?;
    fidelity
        .check_held(model.second_order_terms)
        .map_err(|error| SceneError::Key { key: format!("{key}.fidelity"), message: error.to_string() })?;
    Ok(NamedBody {
        name: name.to_owned(),
        body: HostBody::new(&model, &fidelity),
        model: Some(SceneModel { model: model.clone(), fidelity }),
        marker_names: model.markers.iter().map(|marker| marker.name.clone()).collect(),
        markers: HostBody::markers(&model),
        stress_markers: {
            let names = model.stress_markers.iter().map(|marker| marker.name.clone());
            names.zip(HostBody::stress_markers(&model)).collect()
        },
        section_markers: {
            let names = model.section_markers.iter().map(|marker| marker.name.clone());
            names.zip(HostBody::section_markers(&model)).collect()
        },
    })
}

fn rigid(name: &str, key: &str, table: &BodyTable, mass: f64) -> Result<NamedBody, SceneError> {
    for (given, what) in [
        (table.modes.is_some(), "modes"),
        (table.fidelity.is_some(), "fidelity"),
        (table.surface.is_some(), "surface"),
        (table.modal_coordinates.is_some(), "modal_coordinates"),
        (table.modal_rates.is_some(), "modal_rates"),
    ] {
        if given {
            return Err(SceneError::value(
                format!("{key}.{what}"),
                "nothing: a rigid body has no modes",
                "a value",
            ));
        }
    }
    if !(mass > 0.0 && mass.is_finite()) {
        return Err(SceneError::value(format!("{key}.mass"), "a positive mass", mass));
    }
    let Some(rows) = table.inertia else {
        return Err(SceneError::value(format!("{key}.inertia"), "three rows of three numbers", "nothing"));
    };
    let inertia = Matrix3::from_fn(|i, j| rows[i][j]);
    let asymmetry = (inertia - inertia.transpose()).amax();
    if asymmetry.is_nan() || asymmetry > 1e-9 * inertia.amax() {
        return Err(SceneError::value(
            format!("{key}.inertia"),
            "a symmetric tensor",
            format!("entries that differ by {asymmetry:e}"),
        ));
    }
    let principal = inertia.symmetric_eigenvalues();
    let (least, sum) = (principal.min(), principal.sum());
    // a moment is at most the sum of the other two; round-off of the numbers as written is allowed
    if !(least > 0.0 && principal.max() <= (sum - principal.max()) * (1.0 + 1e-6)) {
        return Err(SceneError::value(
            format!("{key}.inertia"),
            "positive principal moments, each at most the sum of the other two",
            format!("{:e}, {:e}, {:e}", principal[0], principal[1], principal[2]),
        ));
    }
    let center = table.center_of_mass.map_or_else(Vector3::zeros, Vector3::from);
    let body = HostBody::rigid(mass, center, &inertia);
    let markers = table
        .markers
        .values()
        .map(|position| ffrf_runtime::Marker::rigid(Vector3::from(*position), &body.undeformed()))
        .collect();
    Ok(NamedBody {
        name: name.to_owned(),
        marker_names: table.markers.keys().cloned().collect(),
        markers,
        stress_markers: Vec::new(),
        model: None,
        section_markers: Vec::new(),
        body,
    })
}

fn fidelity(key: &str, value: Option<&FidelityValue>) -> Result<Fidelity, SceneError> {
    let key = format!("{key}.fidelity");
    match value {
        None => Ok(Fidelity::Full),
        Some(FidelityValue::Level(name)) => {
            Fidelity::from_name(name).map_err(|error| SceneError::Key { key, message: error.to_string() })
        }
        Some(FidelityValue::Terms(names)) => Fidelity::from_term_names(names.iter().map(String::as_str))
            .map_err(|error| SceneError::Key { key, message: error.to_string() }),
    }
}

fn state(key: &str, table: &BodyTable, body: &HostBody) -> Result<State<HostModal>, SceneError> {
    let modes = body.mode_count();
    let modal = |what: &str, list: &Option<Vec<f64>>| match list {
        None => Ok(HostModal::zeros(modes)),
        Some(list) if list.len() == modes => Ok(HostModal(DVector::from_column_slice(list))),
        Some(list) => Err(SceneError::value(
            format!("{key}.{what}"),
            format!("{modes} numbers, one for each mode"),
            list.len(),
        )),
    };
    let mut state = State::at_rest(body);
    state.position = table.position.into();
    if let Some(parameters) = table.orientation {
        state.orientation = rotation::from_euler_parameters(parameters).ok_or_else(|| {
            SceneError::value(
                format!("{key}.orientation"),
                "four numbers, not all zero",
                format!("{parameters:?}"),
            )
        })?;
    }
    state.velocity = table.velocity.into();
    state.angular_velocity = table.angular_velocity.into();
    state.modal_coordinates = modal("modal_coordinates", &table.modal_coordinates)?;
    state.modal_rates = modal("modal_rates", &table.modal_rates)?;
    if state.is_finite() {
        Ok(state)
    } else {
        Err(SceneError::value(key, "finite numbers", "infinity or nan"))
    }
}
