//! A flexible body held at a marker against the eigenproblem of its model under the same constraints.

use ffrf_host::analysis::{Drives, eigenmodes, linearise};
use ffrf_host::{HostBody, HostModal};
use ffrf_model::ReducedBody;
use ffrf_runtime::{FlexibleBody as _, Observables as _, State};
use nalgebra::{Cholesky, DMatrix, Vector3};

use crate::{close, scene};

#[test]
fn the_rod_held_at_its_big_end_vibrates_as_its_model_says() {
    let text = "[simulation]\nduration = 1.0\nstep = 1e-6\n[bodies.rod]\nmodel = \"../conrod.ffrf.json\"\n\
         [joints.clamp]\nkind = \"fixed\"\nfirst = \"ground\"\nfirst_position = [-0.04740099151709372, 0.0, 0.0]\nsecond = \"rod.BIG_END\"\n";
    let scene = scene(text);
    let (state, missed) = scene.assembled().unwrap();
    assert!(missed[0] < 1e-9, "{missed:?}");
    let modes = eigenmodes(&linearise(&scene, 0.0, &state, Drives::Held).unwrap().a).unwrap();

    // K φ = λ M φ on the motions [v; ω; q̇] that leave the marker at rest, at the undeformed state
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/conrod.ffrf.json");
    let model = ReducedBody::read(&path).unwrap();
    let marker = model.markers.iter().find(|marker| marker.name == "BIG_END").unwrap();
    let body = HostBody::new(&model, &ffrf_codegen::fidelity::Fidelity::Full);
    let count = model.mode_count();
    let n = 6 + count;
    let mut mass = DMatrix::zeros(n, n);
    let rest = State::<HostModal>::at_rest(&body);
    let prepared = body.prepare(&rest.modal_coordinates, &Vector3::zeros(), &rest.modal_rates);
    let rigid = prepared.rigid_mass();
    mass.view_mut((0, 0), (6, 6)).copy_from(&rigid);
    for mu in 0..count {
        for axis in 0..3 {
            let entries =
                [model.inertia.modal_first_moment[mu][axis], prepared.rotation_modal_coupling[axis].0[mu]];
            for (block, entry) in entries.into_iter().enumerate() {
                mass[(3 * block + axis, 6 + mu)] = entry;
                mass[(6 + mu, 3 * block + axis)] = entry;
            }
        }
        for nu in 0..count {
            let moment = &model.inertia.mode_mode_moment[mu][nu];
            mass[(6 + mu, 6 + nu)] = moment[0][0] + moment[1][1] + moment[2][2];
        }
    }
    let stiffness = DMatrix::from_fn(count, count, |i, j| model.stiffness[i][j]);
    // rigid motion follows from the modes: ω = -rotation q̇, v = -(ω × x + translation q̇)
    let mut followed = DMatrix::zeros(n, count);
    for mu in 0..count {
        let omega = -Vector3::from(marker.rotation[mu]);
        let velocity =
            -(omega.cross(&Vector3::from(marker.position)) + Vector3::from(marker.translation[mu]));
        for axis in 0..3 {
            followed[(axis, mu)] = velocity[axis];
            followed[(3 + axis, mu)] = omega[axis];
        }
        followed[(6 + mu, mu)] = 1.0;
    }
    let root = Cholesky::new(followed.transpose() * mass * followed).unwrap().l();
    let half = root.solve_lower_triangular(&stiffness).unwrap();
    let mut values: Vec<f64> = root
        .solve_lower_triangular(&half.transpose())
        .unwrap()
        .symmetric_eigen()
        .eigenvalues
        .iter()
        .copied()
        .collect();
    values.sort_by(f64::total_cmp);
    assert!(body.mass() > 0.0);
    assert_eq!(modes.len(), count);
    for (mode, value) in modes.iter().zip(values) {
        // the lowest eigenvalue is some 1e-3 of the highest in frequency, 1e-6 in λ²
        close("frequency", mode.frequency_hz(), value.sqrt() / std::f64::consts::TAU, 1e-9);
    }
}
