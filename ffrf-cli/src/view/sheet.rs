//! Every mode of a body, side by side, as one drawing for documents.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use ffrf_host::picture::Shape;
use ffrf_model::ReducedBody;

use super::projection::{Colour, Projection};
use crate::animation::mode_name;
use crate::markup::escaped;

/// One picture. Units: px.
const PICTURE: [usize; 2] = [360, 240];
const TITLE: usize = 26;
const COLUMNS: usize = 4;
const HEAD: usize = 34;
const FOOT: usize = 44;
/// Points of a picture for each px: sharp on fine screens and in print.
const FINENESS: usize = 2;
/// Largest displacement that is drawn, relative to the size of the part.
const DRAWN: f64 = 0.07;

/// Viridis by five of its colours, linear.
const VIRIDIS: [Colour; 5] = [
    [0.0546, 0.0, 0.0869],
    [0.0399, 0.0824, 0.2632],
    [0.0111, 0.2888, 0.2674],
    [0.1113, 0.5924, 0.1220],
    [0.9828, 0.8046, 0.0143],
];

fn colour(share: f64) -> Colour {
    let place = share.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let below = (place as usize).min(VIRIDIS.len() - 2);
    let above = place - below as f64;
    [0, 1, 2].map(|k| VIRIDIS[below][k] + above * (VIRIDIS[below + 1][k] - VIRIDIS[below][k]))
}

/// The drawing (SVG). `shape`: the surface of the body, with as many modes.
pub fn draw(body: &ReducedBody, shape: &Shape) -> Result<String> {
    let count = shape.modes.len().max(1);
    let columns = count.min(COLUMNS);
    let rows = count.div_ceil(COLUMNS);
    let (width, height) = (columns * PICTURE[0], HEAD + rows * (PICTURE[1] + TITLE) + FOOT);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" fill=\"#22262b\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n\
         <text x=\"{}\" y=\"23\" font-size=\"17\" text-anchor=\"middle\">{}</text>\n",
        width / 2,
        escaped(&body.title)
    );
    let projection =
        Projection::around(shape.points.iter().copied(), PICTURE.map(|points| points * FINENESS), 0.09);
    let drawn = DRAWN * size(shape);
    let still = vec![[0.0; 3]; shape.points.len()];
    for mode in 0..count {
        let [x, y] = [(mode % COLUMNS) * PICTURE[0], HEAD + (mode / COLUMNS) * (PICTURE[1] + TITLE)];
        let moved = shape.modes.get(mode).unwrap_or(&still);
        let picture = png(projection.draw(triangles(shape, moved, drawn)))?;
        let name = body.modes.get(mode).map_or_else(|| "at rest".to_owned(), |one| mode_name(one, mode + 1));
        let [picture_width, picture_height] = PICTURE;
        let _ = write!(
            svg,
            "<text x=\"{}\" y=\"{}\" font-size=\"14\" text-anchor=\"middle\">{}</text>\n\
             <image x=\"{x}\" y=\"{}\" width=\"{picture_width}\" height=\"{picture_height}\" \
             href=\"data:image/png;base64,{}\"/>\n",
            x + picture_width / 2,
            y + 18,
            escaped(&name),
            y + TITLE,
            BASE64_STANDARD.encode(picture)
        );
    }
    svg.push_str(&scale(width, height - FOOT));
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// What the colours mean.
fn scale(width: usize, y: usize) -> String {
    let mut text = String::from("<defs><linearGradient id=\"displacement\">");
    for (k, stop) in ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"].iter().enumerate() {
        let _ = write!(text, "<stop offset=\"{}%\" stop-color=\"{stop}\"/>", 25 * k);
    }
    let left = width / 2 - 100;
    let _ = write!(
        text,
        "</linearGradient></defs>\n<rect x=\"{left}\" y=\"{}\" width=\"200\" height=\"10\" fill=\"url(#displacement)\"/>\n\
         <g font-size=\"12\"><text x=\"{}\" y=\"{}\" text-anchor=\"end\">0</text><text x=\"{}\" y=\"{}\">largest displacement \
         of the mode</text></g>\n",
        y + 16,
        left - 6,
        y + 26,
        left + 206,
        y + 26
    );
    text
}

/// From one corner of the box around the part at rest to the other.
fn size(shape: &Shape) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in &shape.points {
        for axis in 0..3 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    low.iter().zip(high).map(|(low, high)| (high - low).powi(2)).sum::<f64>().sqrt()
}

/// The surface moved by a mode, at most by `drawn`, coloured by how far.
fn triangles<'a>(
    shape: &'a Shape,
    moved: &'a [[f64; 3]],
    drawn: f64,
) -> impl Iterator<Item = [([f64; 3], Colour); 3]> + 'a {
    let length = |moved: &[f64; 3]| moved.iter().map(|x| x * x).sum::<f64>().sqrt();
    let most = moved.iter().map(length).fold(0.0, f64::max);
    let factor = if most > 0.0 { drawn / most } else { 0.0 };
    shape.triangles.iter().map(move |corners| {
        corners.map(|corner| {
            let [point, by] = [shape.points.as_slice(), moved]
                .map(|list| list.get(corner as usize).copied().unwrap_or_default());
            let share = if most > 0.0 { length(&by) / most } else { 0.0 };
            ([0, 1, 2].map(|axis| point[axis] + factor * by[axis]), colour(share))
        })
    })
}

fn png((width, height, bytes): (usize, usize, Vec<u8>)) -> Result<Vec<u8>> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let written = (|| {
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&bytes)?;
        writer.finish()
    })();
    written.context("a picture of a mode")?;
    Ok(file)
}
