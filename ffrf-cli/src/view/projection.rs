//! A picture of triangles: parallel projection, hidden surfaces by a depth for each point of the picture.

/// A colour in linear red, green, blue, from 0 to 1.
pub(super) type Colour = [f64; 3];

/// From the part to the viewer.
const VIEW: [f64; 3] = [0.5, -0.75, 0.43];
/// Where light comes from, beside what comes from everywhere.
const LIGHT: [f64; 3] = [0.25, -0.55, 0.8];
const AMBIENT: f64 = 0.45;
/// Points of the picture that are averaged, in each direction: edges are smooth.
const SAMPLES: usize = 2;

/// Where points of a part lie in a picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Projection {
    right: [f64; 3],
    up: [f64; 3],
    view: [f64; 3],
    light: [f64; 3],
    centre: [f64; 2],
    scale: f64,
    size: [usize; 2],
}

impl Projection {
    /// A projection that shows all of these points in a picture of that many points; `margin`: of its height.
    pub(super) fn around(points: impl Iterator<Item = [f64; 3]>, size: [usize; 2], margin: f64) -> Self {
        let view = unit(VIEW);
        let right = unit([-view[1], view[0], 0.0]);
        let up = cross(view, right);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            for (axis, direction) in [right, up].into_iter().enumerate() {
                let place = dot(direction, point);
                low[axis] = low[axis].min(place);
                high[axis] = high[axis].max(place);
            }
        }
        let size = size.map(|points| points * SAMPLES);
        let free = 1.0 - 2.0 * margin;
        let scale = [0, 1].map(|axis| {
            let extent = high[axis] - low[axis];
            if extent > 0.0 { free * size[axis] as f64 / extent } else { f64::INFINITY }
        });
        let scale = scale[0].min(scale[1]);
        Self {
            right,
            up,
            view,
            light: unit(LIGHT),
            centre: [0, 1].map(|axis| 0.5 * (low[axis] + high[axis])),
            scale: if scale.is_finite() { scale } else { 1.0 },
            size,
        }
    }

    /// Column, row and height above the picture.
    fn place(&self, point: [f64; 3]) -> [f64; 3] {
        let [columns, rows] = self.size.map(|points| points as f64);
        [
            0.5 * columns + self.scale * (dot(self.right, point) - self.centre[0]),
            0.5 * rows - self.scale * (dot(self.up, point) - self.centre[1]),
            self.scale * dot(self.view, point),
        ]
    }

    /// Draws triangles, each corner with its colour; bytes of red, green, blue, opacity, row after row.
    pub(super) fn draw(
        &self,
        triangles: impl Iterator<Item = [([f64; 3], Colour); 3]>,
    ) -> (usize, usize, Vec<u8>) {
        let [columns, rows] = self.size;
        let mut depths = vec![f64::NEG_INFINITY; columns * rows];
        let mut colours = vec![[0.0; 3]; columns * rows];
        for corners in triangles {
            let normal = unit(cross(less(corners[1].0, corners[0].0), less(corners[2].0, corners[0].0)));
            // both sides are lit
            let bright = AMBIENT + (1.0 - AMBIENT) * dot(normal, self.light).abs();
            let [a, b, c] = corners.map(|(point, _)| self.place(point));
            let area = edge(a, b, c);
            if area == 0.0 || !area.is_finite() {
                continue;
            }
            let span = |axis: usize, most: usize| {
                let ends = [a[axis], b[axis], c[axis]];
                let low = ends.iter().copied().fold(f64::INFINITY, f64::min).floor().max(0.0);
                let high = ends.iter().copied().fold(f64::NEG_INFINITY, f64::max).ceil().min(most as f64);
                low as usize..high.max(0.0) as usize
            };
            for row in span(1, rows) {
                for column in span(0, columns) {
                    let here = [column as f64 + 0.5, row as f64 + 0.5, 0.0];
                    let shares = [edge(b, c, here), edge(c, a, here), edge(a, b, here)].map(|x| x / area);
                    if shares.iter().any(|share| *share < 0.0) {
                        continue;
                    }
                    let depth = shares[0] * a[2] + shares[1] * b[2] + shares[2] * c[2];
                    let place = row * columns + column;
                    if depth > depths[place] {
                        depths[place] = depth;
                        colours[place] = [0, 1, 2].map(|k| {
                            bright
                                * corners
                                    .iter()
                                    .zip(shares)
                                    .map(|((_, colour), x)| x * colour[k])
                                    .sum::<f64>()
                        });
                    }
                }
            }
        }
        self.averaged(&depths, &colours)
    }

    fn averaged(&self, depths: &[f64], colours: &[Colour]) -> (usize, usize, Vec<u8>) {
        let columns = self.size[0];
        let [width, height] = self.size.map(|points| points / SAMPLES);
        let mut bytes = Vec::with_capacity(4 * width * height);
        for row in 0..height {
            for column in 0..width {
                let places = (0..SAMPLES * SAMPLES).map(|sample| {
                    (row * SAMPLES + sample / SAMPLES) * columns + column * SAMPLES + sample % SAMPLES
                });
                let hit: Vec<usize> = places.filter(|place| depths[*place].is_finite()).collect();
                let mean = |k: usize| {
                    hit.iter().map(|place| colours[*place][k]).sum::<f64>() / hit.len().max(1) as f64
                };
                bytes.extend([0, 1, 2].map(|k| byte(gamma(mean(k)))));
                bytes.push(byte(hit.len() as f64 / (SAMPLES * SAMPLES) as f64));
            }
        }
        (width, height, bytes)
    }
}

fn byte(share: f64) -> u8 {
    (255.0 * share.clamp(0.0, 1.0)).round() as u8
}

/// From linear to the standard colours of screens.
fn gamma(linear: f64) -> f64 {
    linear.max(0.0).powf(1.0 / 2.2)
}

/// Twice the signed area of a triangle in the picture.
fn edge(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn less(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    if length > 0.0 { a.map(|x| x / length) } else { a }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: Colour = [1.0, 0.0, 0.0];
    const BLUE: Colour = [0.0, 0.0, 1.0];

    /// A large triangle across the line of sight, so far towards the viewer.
    fn across(towards: f64, colour: Colour) -> [([f64; 3], Colour); 3] {
        let view = unit(VIEW);
        let right = unit([-view[1], view[0], 0.0]);
        let up = cross(view, right);
        [[-3.0, -2.0], [3.0, -2.0], [0.0, 3.0]]
            .map(|[x, y]| ([0, 1, 2].map(|k| x * right[k] + y * up[k] + towards * view[k]), colour))
    }

    #[test]
    fn what_is_in_front_hides_what_is_behind_in_whatever_order() {
        let (front, back) = (across(1.0, RED), across(-1.0, BLUE));
        let projection = Projection::around(front.iter().map(|corner| corner.0), [40, 30], 0.1);
        for order in [[front, back], [back, front]] {
            let (width, height, bytes) = projection.draw(order.into_iter());
            assert_eq!((width, height, bytes.len()), (40, 30, 4 * 40 * 30));
            let middle = &bytes[4 * (15 * 40 + 20)..][..4];
            assert!(middle[0] > 100 && middle[2] == 0 && middle[3] == 255, "{middle:?}");
            // nothing in the corner
            assert_eq!(bytes[3], 0);
        }
    }

    #[test]
    fn everything_is_in_the_picture_and_touches_its_margin() {
        let triangle = across(0.0, RED);
        let projection = Projection::around(triangle.iter().map(|corner| corner.0), [100, 50], 0.1);
        let places = triangle.map(|(point, _)| projection.place(point));
        let samples = SAMPLES as f64;
        let low = places.iter().map(|place| place[1]).fold(f64::INFINITY, f64::min);
        let high = places.iter().map(|place| place[1]).fold(0.0, f64::max);
        assert!((low - 5.0 * samples).abs() < 1e-9 && (high - 45.0 * samples).abs() < 1e-9);
    }
}
