//! What the mean-axis (Tisserand) conditions make zero is written as zero.

use ffrf_model::{Inertia, Matrix3, Mode, ModeKind};

use crate::tolerances::MEAN_AXIS_ROUND_OFF;

/// Clears b_μ and the antisymmetric part ϑ_μ of T_μ for computed free-free modes, component modes in mean axes among them.
///
/// Those modes are orthogonal to the rigid-body motions, so b_μ = 0 and ϑ_μ = 0 but for round-off. A mode whose
/// numbers are larger than that keeps them, and so does every mode that a user supplied.
pub(crate) fn clear(inertia: &mut Inertia, modes: &[Mode]) {
    let root_trace = |matrix: &Matrix3| (matrix[0][0] + matrix[1][1] + matrix[2][2]).max(0.0).sqrt();
    let (translation, position) = (inertia.mass.max(0.0).sqrt(), root_trace(&inertia.second_moment));
    for (mu, mode) in modes.iter().enumerate() {
        let scale = root_trace(&inertia.mode_mode_moment[mu][mu]);
        let moment = &mut inertia.position_mode_moment[mu];
        let first = &mut inertia.modal_first_moment[mu];
        let odd = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| (moment[i][j] - moment[j][i]).abs());
        let holds = first.iter().all(|b| b.abs() <= MEAN_AXIS_ROUND_OFF * translation * scale)
            && odd.iter().all(|&x| x <= MEAN_AXIS_ROUND_OFF * position * scale);
        if matches!(mode.kind, ModeKind::FreeFree | ModeKind::Component) && holds {
            *first = [0.0; 3];
            *moment = [0, 1, 2].map(|i| [0, 1, 2].map(|j| 0.5 * moment[i][j] + 0.5 * moment[j][i]));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inertia(noise: f64) -> Inertia {
        Inertia {
            mass: 1.0,
            first_moment: [0.0; 3],
            modal_first_moment: vec![[noise, 0.0, 0.0]],
            second_moment: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            position_mode_moment: vec![[[0.1, 0.2 + noise, 0.0], [0.2, 0.1, 0.0], [0.0, 0.0, 0.1]]],
            mode_mode_moment: vec![vec![[[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]]],
        }
    }

    #[test]
    fn round_off_of_computed_free_free_modes_is_cleared_and_nothing_else() {
        let mode = |kind| [Mode { kind, frequency_hz: None }];
        let mut cleared = inertia(1e-14);
        clear(&mut cleared, &mode(ModeKind::FreeFree));
        assert_eq!(cleared.modal_first_moment[0], [0.0; 3]);
        assert_eq!(cleared.position_mode_moment[0][0][1], cleared.position_mode_moment[0][1][0]);
        for (noise, kind) in [(1e-14, ModeKind::User), (1e-14, ModeKind::Clamped), (1e-9, ModeKind::FreeFree)]
        {
            let mut kept = inertia(noise);
            clear(&mut kept, &mode(kind));
            assert_eq!(kept, inertia(noise));
        }
    }
}
