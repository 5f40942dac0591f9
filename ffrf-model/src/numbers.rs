//! A walk over every number of a body, with the path of its field.

use crate::ReducedBody;

impl ReducedBody {
    /// The first number of the body that is `wanted`, with the full path of its field; in the order of the file.
    pub fn find_number(&self, wanted: impl Fn(f64) -> bool) -> Option<(String, f64)> {
        let mut walk = Walk { wanted, found: None };
        for (mu, mode) in self.modes.iter().enumerate() {
            walk.scalar(|| format!("modes[{mu}].frequency_hz"), mode.frequency_hz);
        }
        let inertia = &self.inertia;
        walk.scalar(|| "inertia.mass".to_owned(), Some(inertia.mass));
        walk.row(|| "inertia.first_moment".to_owned(), &inertia.first_moment);
        walk.rows(|| "inertia.modal_first_moment".to_owned(), &inertia.modal_first_moment);
        walk.rows(|| "inertia.second_moment".to_owned(), &inertia.second_moment);
        for (mu, matrix) in inertia.position_mode_moment.iter().enumerate() {
            walk.rows(|| format!("inertia.position_mode_moment[{mu}]"), matrix);
        }
        for (mu, row) in inertia.mode_mode_moment.iter().enumerate() {
            for (nu, matrix) in row.iter().enumerate() {
                walk.rows(|| format!("inertia.mode_mode_moment[{mu}][{nu}]"), matrix);
            }
        }
        walk.rows(|| "stiffness".to_owned(), &self.stiffness);
        walk.rows(|| "damping".to_owned(), &self.damping);
        if let Some(geometric) = &self.geometric_stiffness {
            for (mu, row) in geometric.uniform_load.iter().enumerate() {
                walk.rows(|| format!("geometric_stiffness.uniform_load[{mu}]"), row);
            }
            for (mu, row) in geometric.linear_load.iter().enumerate() {
                for (nu, matrix) in row.iter().enumerate() {
                    walk.rows(|| format!("geometric_stiffness.linear_load[{mu}][{nu}]"), matrix);
                }
            }
            for (index, load) in geometric.marker_loads.iter().enumerate() {
                for (mu, row) in load.stiffness.iter().enumerate() {
                    let field = || format!("geometric_stiffness.marker_loads[{index}].stiffness[{mu}]");
                    walk.rows(field, row);
                }
            }
        }
        for (index, marker) in self.markers.iter().enumerate() {
            walk.row(|| format!("markers[{index}].position"), &marker.position);
            walk.rows(|| format!("markers[{index}].translation"), &marker.translation);
            walk.rows(|| format!("markers[{index}].rotation"), &marker.rotation);
        }
        for (index, marker) in self.stress_markers.iter().enumerate() {
            walk.row(|| format!("stress_markers[{index}].position"), &marker.position);
            walk.rows(|| format!("stress_markers[{index}].stress"), &marker.stress);
        }
        for (index, marker) in self.section_markers.iter().enumerate() {
            walk.row(|| format!("section_markers[{index}].position"), &marker.position);
            walk.row(|| format!("section_markers[{index}].normal"), &marker.normal);
            walk.rows(|| format!("section_markers[{index}].force"), &marker.force);
        }
        walk.found
    }
}

/// Looks until something is found; paths are written for that number only.
struct Walk<W> {
    wanted: W,
    found: Option<(String, f64)>,
}

impl<W: Fn(f64) -> bool> Walk<W> {
    fn scalar(&mut self, path: impl Fn() -> String, number: Option<f64>) {
        if self.found.is_none() {
            self.found = number.filter(|number| (self.wanted)(*number)).map(|number| (path(), number));
        }
    }

    fn row(&mut self, path: impl Fn() -> String, row: &[f64]) {
        for (index, &number) in row.iter().enumerate() {
            self.scalar(|| format!("{}[{index}]", path()), Some(number));
        }
    }

    fn rows<R: AsRef<[f64]>>(&mut self, path: impl Fn() -> String, rows: &[R]) {
        for (index, row) in rows.iter().enumerate() {
            self.row(|| format!("{}[{index}]", path()), row.as_ref());
        }
    }
}
