//! Short quadrature rules that are exact for stiffness and mass of elements with straight edges.

use super::shapes;

/// A point of a quadrature rule on the reference element.
#[derive(Clone, Copy)]
pub(super) struct ReferencePoint {
    pub at: [f64; 3],
    pub weight: f64,
}

/// 2 x 2 x 2 Gauss points: exact for stiffness and mass of a parallelepiped.
pub(super) fn hexahedron8() -> Vec<ReferencePoint> {
    let abscissa = 1.0 / 3.0_f64.sqrt();
    let points = shapes::HEXAHEDRON[..8]
        .iter()
        .map(|corner| ReferencePoint { at: corner.map(|x| x * abscissa), weight: 1.0 });
    points.collect()
}

/// Four points of degree 2 (Hammer and Stroud 1956): exact for stiffness and mass.
pub(super) fn tetrahedron4() -> Vec<ReferencePoint> {
    let near = (5.0 - 5.0_f64.sqrt()) / 20.0;
    let far = (5.0 + 3.0 * 5.0_f64.sqrt()) / 20.0;
    [[near, near, near], [far, near, near], [near, far, near], [near, near, far]]
        .map(|at| ReferencePoint { at, weight: 1.0 / 24.0 })
        .to_vec()
}

/// 3 x 3 x 3 Gauss points: exact for stiffness and mass of a parallelepiped.
pub(super) fn hexahedron20() -> Vec<ReferencePoint> {
    let far = 0.6_f64.sqrt();
    let line = [(-far, 5.0 / 9.0), (0.0, 8.0 / 9.0), (far, 5.0 / 9.0)];
    let mut points = Vec::with_capacity(27);
    for (z, c) in line {
        for (y, b) in line {
            points.extend(line.map(|(x, a)| ReferencePoint { at: [x, y, z], weight: a * b * c }));
        }
    }
    points
}

/// Fourteen points of degree 5 (Walkington 2000; Grundmann and Moeller's kind): exact for stiffness and mass.
pub(super) fn tetrahedron10() -> Vec<ReferencePoint> {
    const VERTICES: [(f64, f64); 2] = [
        (0.310_885_919_263_300_6, 0.112_687_925_718_015_85),
        (0.092_735_250_310_891_23, 0.073_493_043_116_361_95),
    ];
    const EDGE: (f64, f64) = (0.045_503_704_125_649_65, 0.042_546_020_777_081_466);
    let mut points = Vec::with_capacity(14);
    let mut add = |volume: [f64; 4], weight: f64| {
        points.push(ReferencePoint { at: [volume[1], volume[2], volume[3]], weight: weight / 6.0 });
    };
    for (near, weight) in VERTICES {
        for k in 0..4 {
            let mut volume = [near; 4];
            volume[k] = 1.0 - 3.0 * near;
            add(volume, weight);
        }
    }
    let (near, weight) = EDGE;
    for i in 0..4 {
        for k in i + 1..4 {
            let mut volume = [near; 4];
            volume[i] = 0.5 - near;
            volume[k] = 0.5 - near;
            add(volume, weight);
        }
    }
    points
}

/// Three points in the triangle times two along ζ: exact for stiffness and mass of a prism.
pub(super) fn wedge6() -> Vec<ReferencePoint> {
    let height = 1.0 / 3.0_f64.sqrt();
    let triangle = [[1.0 / 6.0, 1.0 / 6.0], [2.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 2.0 / 3.0]];
    let at = |z: f64| triangle.map(|[x, y]| ReferencePoint { at: [x, y, z], weight: 1.0 / 6.0 });
    [at(-height), at(height)].concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums of up to 27 products of order one.
    const ROUND_OFF: f64 = 1e-14;

    fn factorial(n: u32) -> f64 {
        (1..=n).map(f64::from).product()
    }

    /// x^a y^b z^c over the reference tetrahedron has the integral a! b! c! / (a + b + c + 3)!.
    #[test]
    fn rules_of_the_tetrahedron_are_exact_to_their_degree() {
        for (rule, degree) in [(tetrahedron4(), 2), (tetrahedron10(), 5)] {
            for (a, b, c) in (0..=degree)
                .flat_map(|a| (0..=degree - a).map(move |b| (a, b)))
                .flat_map(|(a, b)| (0..=degree - a - b).map(move |c| (a, b, c)))
            {
                let sum: f64 = rule
                    .iter()
                    .map(|point| {
                        let [x, y, z] = point.at;
                        point.weight * x.powi(a as i32) * y.powi(b as i32) * z.powi(c as i32)
                    })
                    .sum();
                let exact = factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 3);
                assert!((sum - exact).abs() < ROUND_OFF, "{a} {b} {c}: {sum} for {exact}");
            }
        }
    }

    #[test]
    fn rules_of_hexahedron_and_wedge_are_exact_to_their_degree() {
        let even = |n: i32| if n % 2 == 0 { 2.0 / f64::from(n + 1) } else { 0.0 };
        for (a, b, c) in [(0, 0, 0), (4, 4, 4), (5, 2, 4), (2, 0, 4), (4, 1, 0)] {
            let sum: f64 = hexahedron20()
                .iter()
                .map(|point| point.weight * point.at[0].powi(a) * point.at[1].powi(b) * point.at[2].powi(c))
                .sum();
            assert!((sum - even(a) * even(b) * even(c)).abs() < ROUND_OFF, "{a} {b} {c}");
        }
        for (a, b, c) in [(0, 0, 0), (2, 0, 2), (1, 1, 2), (0, 2, 3), (1, 0, 1)] {
            let sum: f64 = wedge6()
                .iter()
                .map(|point| point.weight * point.at[0].powi(a) * point.at[1].powi(b) * point.at[2].powi(c))
                .sum();
            let triangle = factorial(a as u32) * factorial(b as u32) / factorial((a + b) as u32 + 2);
            assert!((sum - triangle * even(c)).abs() < ROUND_OFF, "{a} {b} {c}");
        }
    }
}
