//! Pictures as SVG, with one set of colours.

mod campbell;
mod histories;
mod trade;
mod transfer;

use std::path::Path;

use anyhow::{Result, bail};
use plotters::coord::CoordTranslate;
use plotters::prelude::{
    ChartContext, Color as _, DrawingAreaErrorKind, DrawingBackend, IntoFont as _, RGBColor,
    SeriesLabelPosition, TextStyle, WHITE,
};

pub use campbell::draw as draw_campbell;
pub use histories::{Panel, draw as draw_histories};
pub use trade::{COST_OPERATIONS, COST_TIME, TradePoint, draw_pareto, draw_work_precision};
pub use transfer::{Curve, draw as draw_transfer};

/// Axes, frames and text.
const GREY: RGBColor = RGBColor(60, 60, 60);
/// Light lines of a mesh.
const PALE: RGBColor = RGBColor(228, 228, 228);
/// Colours of lines, told apart by people who see colours differently. Source: Okabe and Ito, Color universal design (2008).
const LINES: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(0, 0, 0),
];

/// Refuses names of pictures in formats that are not written.
pub fn refuse_other_pictures(path: &Path) -> Result<()> {
    match path.extension() {
        Some(ending) if ending == "svg" => Ok(()),
        _ => bail!("{}: expected the name of a picture that ends in .svg", path.display()),
    }
}

/// The colour of line `index`.
fn colour(index: usize) -> RGBColor {
    LINES[index % LINES.len()]
}

/// Text of a size in pixels.
fn text(size: i32) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&GREY)
}

/// The names of the series, in a frame that lets lines shine through.
fn draw_series_names<'a, DB: DrawingBackend + 'a, CT: CoordTranslate>(
    chart: &mut ChartContext<'a, DB, CT>,
    position: SeriesLabelPosition,
) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
    chart
        .configure_series_labels()
        .position(position)
        .background_style(WHITE.mix(0.85))
        .label_font(text(13))
        .border_style(PALE)
        .draw()
}
