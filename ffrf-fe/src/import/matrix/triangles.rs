//! The common symmetric matrices without a sort: both triangles stored place by place, or one triangle alone.
//!
//! A symmetric matrix is its own transpose, so lines may be rows or columns here.

use super::sparse_lines::SparseLines;

/// How well the triangles of a matrix agree that stores every entry with its mirror image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Agreement {
    /// Largest difference of mirrored entries.
    pub(crate) deviation: f64,
}

/// Which side of the diagonal has entries: (places before the line's own number, places behind it).
pub(crate) fn sides(lines: &SparseLines) -> (bool, bool) {
    let (mut before, mut behind) = (false, false);
    for line in 0..lines.size() {
        let places = lines.line(line).0;
        before |= places.first().is_some_and(|&place| (place as usize) < line);
        behind |= places.last().is_some_and(|&place| place as usize > line);
    }
    (before, behind)
}

/// Compares the triangles; `None` if some entry has no mirror image.
pub(crate) fn compare(lines: &SparseLines) -> Option<Agreement> {
    let mut deviation = 0.0_f64;
    let values = &lines.values;
    each_pair(lines, |first, second| {
        let (a, b) = (values[first], values[second]);
        if a != b {
            deviation = deviation.max((a - b).abs());
        }
    })?;
    Some(Agreement { deviation })
}

/// Replaces mirrored entries that differ by their mean.
pub(crate) fn average(mut lines: SparseLines) -> SparseLines {
    let mut values = std::mem::take(&mut lines.values);
    let paired = each_pair(&lines, |first, second| {
        let mean = 0.5 * (values[first] + values[second]);
        (values[first], values[second]) = (mean, mean);
    });
    debug_assert!(paired.is_some(), "averaged only after a comparison");
    lines.values = values;
    lines
}

/// Calls `visit` with the positions of each off-diagonal entry and its mirror image, or returns `None` at the first
/// entry without one (the pairs before it have been visited).
///
/// Going through the lines in order, the mirror images in any later line come up in order as well: `next` keeps how
/// far each line has been used.
fn each_pair(lines: &SparseLines, mut visit: impl FnMut(usize, usize)) -> Option<()> {
    let (starts, places) = (&lines.starts, &lines.places);
    let mut next = starts[..lines.size()].to_vec();
    for line in 0..lines.size() {
        let (mut at, end) = (next[line], starts[line + 1]);
        if at < end && places[at] as usize == line {
            at += 1;
        }
        for (first, &place) in (at..end).zip(&places[at..end]) {
            let place = place as usize;
            // A place that lies before the line was not met as anyone's mirror image.
            if place < line {
                return None;
            }
            let second = next[place];
            if second == starts[place + 1] || places[second] as usize != line {
                return None;
            }
            next[place] += 1;
            visit(first, second);
        }
    }
    Some(())
}

/// Both triangles from one.
pub(crate) fn expand(lines: &SparseLines) -> SparseLines {
    let size = lines.size();
    let mut next = vec![0; size + 1];
    for line in 0..size {
        let places = lines.line(line).0;
        next[line + 1] += places.len();
        for &place in places {
            next[place as usize + 1] += usize::from(place as usize != line);
        }
    }
    for line in 0..size {
        next[line + 1] += next[line];
    }
    let starts = next.clone();
    let total = next[size];
    let mut expanded =
        SparseLines { kind: lines.kind, starts, places: vec![0; total], values: vec![0.0; total] };
    let (to_places, to_values) = (&mut expanded.places, &mut expanded.values);
    // Below the diagonal a line's own entries come before the mirrored ones of later lines; above it the mirrored
    // ones of earlier lines come before its own. Either way in the order of this loop.
    for line in 0..size {
        let (places, values) = lines.line(line);
        for (&place, &value) in places.iter().zip(values) {
            let to = next[line];
            next[line] += 1;
            (to_places[to], to_values[to]) = (place, value);
            let place = place as usize;
            if place != line {
                let to = next[place];
                next[place] += 1;
                (to_places[to], to_values[to]) = (line as u32, value);
            }
        }
    }
    expanded
}

/// Drops zeros beside the diagonal.
pub(crate) fn without_zeros(mut lines: SparseLines) -> SparseLines {
    if !lines.values.contains(&0.0) {
        return lines;
    }
    let mut kept = 0;
    let mut begin = 0;
    for line in 0..lines.size() {
        let end = lines.starts[line + 1];
        for at in begin..end {
            let (place, value) = (lines.places[at], lines.values[at]);
            if value != 0.0 || place as usize == line {
                (lines.places[kept], lines.values[kept]) = (place, value);
                kept += 1;
            }
        }
        begin = end;
        lines.starts[line + 1] = kept;
    }
    lines.places.truncate(kept);
    lines.values.truncate(kept);
    lines
}

#[cfg(test)]
mod tests {
    use super::super::sparse_lines::tests::lines;
    use super::*;

    const BOTH: [(u32, u32, f64); 7] =
        [(0, 0, 4.0), (0, 1, -1.0), (0, 3, 0.5), (1, 0, -1.0), (2, 2, 2.0), (3, 0, 0.5), (3, 3, 1.0)];

    #[test]
    fn every_missing_mirror_image_is_noticed() {
        assert_eq!(compare(&lines(&BOTH, 4)), Some(Agreement { deviation: 0.0 }));
        for left_out in 0..BOTH.len() {
            let mut places = BOTH.to_vec();
            let (row, column, _) = places.remove(left_out);
            assert_eq!(compare(&lines(&places, 4)).is_some(), row == column, "without ({row}, {column})");
        }
        for (row, column) in [(1, 2), (2, 1), (3, 1), (3, 2), (2, 3)] {
            let mut places = BOTH.to_vec();
            places.push((row, column, 1.0));
            places.sort_by_key(|entry| (entry.0, entry.1));
            assert_eq!(compare(&lines(&places, 4)), None, "with ({row}, {column})");
        }
    }

    #[test]
    fn the_largest_difference_is_found_and_averaged() {
        let mut places = BOTH;
        places[1].2 = -1.25;
        places[5].2 = 0.625;
        assert_eq!(compare(&lines(&places, 4)), Some(Agreement { deviation: 0.25 }));
        assert_eq!(average(lines(&places, 4)).values, [4.0, -1.125, 0.5625, -1.125, 2.0, 0.5625, 1.0]);
    }

    #[test]
    fn either_triangle_expands_to_both() {
        let wanted = lines(&BOTH, 4);
        for below in [true, false] {
            let triangle: Vec<_> = BOTH
                .into_iter()
                .filter(|entry| if below { entry.0 >= entry.1 } else { entry.0 <= entry.1 })
                .collect();
            let triangle = lines(&triangle, 4);
            assert_eq!(sides(&triangle), (below, !below));
            let both = expand(&triangle);
            assert_eq!(
                (both.starts, both.places, both.values),
                (wanted.starts.clone(), wanted.places.clone(), wanted.values.clone())
            );
        }
        assert_eq!(sides(&wanted), (true, true));
    }

    #[test]
    fn zeros_beside_the_diagonal_are_dropped() {
        let kept = without_zeros(lines(&[(0, 0, 0.0), (0, 1, 0.0), (1, 0, -0.0), (1, 1, 3.0)], 2));
        assert_eq!((kept.starts, kept.places, kept.values), (vec![0, 1, 2], vec![0, 1], vec![0.0, 3.0]));
    }
}
