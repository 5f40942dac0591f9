//! Quadrature rules on the reference elements.

/// Gauss points and weights on [-1, 1], three points: exact to degree 5.
const LINE_3: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// Gauss points and weights on [-1, 1], four points: exact to degree 7 (Abramowitz & Stegun, table 25.4).
const LINE_4: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_3, 0.652_145_154_862_546_2),
    (0.339_981_043_584_856_3, 0.652_145_154_862_546_2),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Points and weights on [-1, 1]³, 27 of them: exact for mass and second moments of a parallelepiped.
pub(super) fn hexahedron() -> Vec<([f64; 3], f64)> {
    let mut rule = Vec::with_capacity(27);
    for (z, c) in LINE_3 {
        for (y, b) in LINE_3 {
            rule.extend(LINE_3.map(|(x, a)| ([x, y, z], a * b * c)));
        }
    }
    rule
}

/// Points and weights on the unit tetrahedron, 64 of them: exact to degree 5.
///
/// The cube [0, 1]³ collapsed by x = u, y = v (1 - u), z = w (1 - u)(1 - v) with Jacobian (1 - u)²(1 - v); the four
/// Gauss points in each direction carry degree 7, of which the Jacobian takes two.
pub(super) fn tetrahedron() -> Vec<([f64; 3], f64)> {
    let unit = LINE_4.map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w));
    let mut rule = Vec::with_capacity(64);
    for (u, a) in unit {
        for (v, b) in unit {
            rule.extend(unit.map(|(w, c)| {
                let at = [u, v * (1.0 - u), w * (1.0 - u) * (1.0 - v)];
                (at, a * b * c * (1.0 - u) * (1.0 - u) * (1.0 - v))
            }));
        }
    }
    rule
}
