//! What a rigid body yields to forces: the weights of redundant rows.

/// The accelerations that forces on the frame of a rigid body give, the inverse of its mass matrix. Frame: body.
///
/// With the motion of the centre of mass and L D Lᵀ of the inertia about it the mass matrix is diagonal, as in the runtime's
/// `RigidFrame`; what has no mass or inertia yields nothing, as there. `inertia` is about the frame origin.
/// Shape: 6 x 6, row by row.
pub(super) fn rigid_compliance(mass: f64, first_moment: &[f64; 3], inertia: &[f64; 9]) -> [f64; 36] {
    let [x, y, z] = first_moment.map(|moment| moment / mass);
    let [m_x, m_y, m_z] = *first_moment;
    let [xx, yx, zx, _, yy, zy, _, _, zz] = *inertia;
    let (xx, yy, zz) = (xx - (y * m_y + z * m_z), yy - (x * m_x + z * m_z), zz - (x * m_x + y * m_y));
    let (yx, zx, zy) = (yx + x * m_y, zx + x * m_z, zy + y * m_z);
    let (l21, l31) = (yx / xx, zx / xx);
    let d2 = yy - l21 * yx;
    let left = zy - l31 * yx;
    let l32 = left / d2;
    let masses = [mass, mass, mass, xx, d2, zz - l31 * zx - l32 * left];
    // force and moment in these components; the moment is about the centre of mass
    let components = |force: [f64; 6]| {
        let [f_x, f_y, f_z, r_x, r_y, r_z] = force;
        let first = r_x - (y * f_z - z * f_y);
        let second = r_y - (z * f_x - x * f_z) - l21 * first;
        [f_x, f_y, f_z, first, second, r_z - (x * f_y - y * f_x) - l31 * first - l32 * second]
    };
    let columns: [[f64; 6]; 6] = std::array::from_fn(|axis| {
        components(std::array::from_fn(|entry| if entry == axis { 1.0 } else { 0.0 }))
    });
    let yields = masses.map(|mass| if mass > 0.0 { 1.0 / mass } else { 0.0 });
    std::array::from_fn(|entry| {
        let parts = columns[entry / 6].iter().zip(&columns[entry % 6]).zip(&yields);
        parts.filter(|(_, yields)| **yields > 0.0).map(|((row, column), yields)| row * column * yields).sum()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Some ten operations on numbers of order one.
    const ROUND_OFF: f64 = 1e-13;

    #[test]
    fn it_is_the_inverse_of_the_mass_matrix() {
        let (mass, [x, y, z]) = (1.7, [0.4, -0.3, 0.6]);
        let moment = [mass * x, mass * y, mass * z];
        // about the centre of mass, then about the frame origin
        let (a, b, c) = ([0.9, 0.1, -0.2], [0.1, 0.8, 0.05], [-0.2, 0.05, 0.7]);
        let square = x * x + y * y + z * z;
        let center = [x, y, z];
        let inertia: [f64; 9] = std::array::from_fn(|k| {
            let (i, j) = (k / 3, k % 3);
            let unit = if i == j { square } else { 0.0 };
            [a, b, c][i][j] + mass * (unit - center[i] * center[j])
        });
        let mut matrix = [[0.0; 6]; 6];
        for i in 0..3 {
            matrix[i][i] = mass;
            for j in 0..3 {
                matrix[3 + i][3 + j] = inertia[3 * i + j];
            }
        }
        for (i, j, value) in [
            (4, 2, -moment[0]),
            (5, 1, moment[0]),
            (3, 2, moment[1]),
            (5, 0, -moment[1]),
            (3, 1, -moment[2]),
            (4, 0, moment[2]),
        ] {
            matrix[i][j] = value;
            matrix[j][i] = value;
        }
        let compliance = rigid_compliance(mass, &moment, &inertia);
        for i in 0..6 {
            for j in 0..6 {
                let product: f64 = (0..6).map(|k| matrix[i][k] * compliance[6 * k + j]).sum();
                let unit = if i == j { 1.0 } else { 0.0 };
                assert!((product - unit).abs() < ROUND_OFF, "{i} {j}: {product}");
            }
        }
    }

    #[test]
    fn what_has_no_inertia_yields_nothing() {
        let compliance = rigid_compliance(2.0, &[0.0; 3], &[0.0; 9]);
        assert_eq!(compliance[0], 0.5);
        assert!(compliance.iter().skip(3).all(|entry| entry.is_finite()));
    }
}
