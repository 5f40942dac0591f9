//! The Pareto front of error and cost.

/// The places of those that no other beats in both numbers, by rising cost. What is not finite is never among them.
pub fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..points.len()).filter(|k| points[*k].0.is_finite() && points[*k].1.is_finite()).collect();
    order.sort_by(|a, b| points[*a].0.total_cmp(&points[*b].0).then(points[*a].1.total_cmp(&points[*b].1)));
    let mut best = f64::INFINITY;
    order.retain(|k| {
        let better = points[*k].1 < best;
        if better {
            best = points[*k].1;
        }
        better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::front;

    #[test]
    fn only_what_nothing_beats_is_left() {
        let points = [
            (1.0, 5.0),
            (2.0, 5.0),
            (2.0, 3.0),
            (3.0, 4.0),
            (4.0, 1.0),
            (f64::NAN, 0.0),
            (9.0, f64::INFINITY),
        ];
        assert_eq!(front(&points), [0, 2, 4]);
        assert!(front(&[]).is_empty());
    }
}
