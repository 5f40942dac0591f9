//! Line charts as SVG: panels below each other, with their legend beside them.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

/// Eight colours that differ for colour-blind eyes as well (Okabe and Ito).
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(90, 90, 90),
    RGBColor(0, 0, 0),
];
const WIDTH: u32 = 1100;
const LEGEND_WIDTH: u32 = 210;
const PANEL_HEIGHT: u32 = 340;

/// A named line.
pub struct Line {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

impl Line {
    pub fn new(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self { name: name.into(), points: points.into_iter().collect() }
    }
}

/// One chart.
pub struct Panel {
    pub title: String,
    pub x: String,
    pub y: String,
    pub lines: Vec<Line>,
}

/// Draws the panels below each other.
pub fn draw(path: &Path, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new(path, (WIDTH, PANEL_HEIGHT * panels.len() as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    for (area, panel) in root.split_evenly((panels.len(), 1)).iter().zip(panels) {
        let (chart, legend) = area.split_horizontally(WIDTH - LEGEND_WIDTH);
        draw_lines(&chart, panel)?;
        for (i, (line, colour)) in coloured(panel).enumerate() {
            let y = 60 + 22 * i as i32;
            legend.draw(&PathElement::new([(4, y), (26, y)], colour.stroke_width(3)))?;
            legend.draw(&Text::new(line.name.as_str(), (34, y - 7), ("sans-serif", 14)))?;
        }
    }
    root.present()?;
    Ok(())
}

fn coloured(panel: &Panel) -> impl Iterator<Item = (&Line, &RGBColor)> {
    panel.lines.iter().zip(COLOURS.iter().cycle())
}

fn draw_lines(area: &DrawingArea<SVGBackend, Shift>, panel: &Panel) -> Result<(), Box<dyn Error>> {
    let points = || panel.lines.iter().flat_map(|line| &line.points);
    let x = range(points().map(|point| point.0), 0.0);
    let y = range(points().map(|point| point.1), 0.06);
    let mut chart = ChartBuilder::on(area)
        .caption(&panel.title, ("sans-serif", 17))
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(86)
        .build_cartesian_2d(x.0..x.1, y.0..y.1)?;
    let instant = |value: &f64| short(*value, x.1 - x.0);
    let number = |value: &f64| short(*value, y.1 - y.0);
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc(&panel.x)
        .y_desc(&panel.y)
        .x_label_formatter(&instant)
        .y_label_formatter(&number)
        .y_labels(7)
        .label_style(("sans-serif", 13))
        .axis_desc_style(("sans-serif", 14))
        .draw()?;
    for (line, colour) in coloured(panel) {
        chart.draw_series(LineSeries::new(line.points.iter().copied(), colour.stroke_width(1)))?;
    }
    Ok(())
}

/// Smallest interval that holds the values, widened by a part of its length on both sides.
fn range(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if low < high {
        (low - margin * (high - low), high + margin * (high - low))
    } else if low.is_finite() {
        (low - 1.0, high + 1.0)
    } else {
        (0.0, 1.0)
    }
}

/// A label: decimal where that is short, otherwise with an exponent.
fn short(value: f64, span: f64) -> String {
    if value.abs() < 1e-9 * span {
        "0".to_owned()
    } else if (1e-2..1e4).contains(&span) {
        let digits = (2.0 - span.log10().floor()).clamp(0.0, 4.0) as usize;
        let text = format!("{value:.digits$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{value:.1e}")
    }
}
