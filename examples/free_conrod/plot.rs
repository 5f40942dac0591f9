//! Line charts as SVG: panels below each other, with their legend beside them; linear or double logarithmic.
//!
//! The example `equivalence` draws with this file, too.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
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

/// Size of one panel. Units: pixels.
#[derive(Clone, Copy)]
pub struct Size {
    /// With the legend.
    pub width: u32,
    pub height: u32,
    pub legend_width: u32,
}

/// Axes, and what suits their lines.
#[allow(dead_code)] // each example uses its part
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Axes {
    /// Linear, thin lines: signals that vibrate.
    Signals,
    /// Linear; earlier lines are wider, so that lines upon each other are all seen.
    Linear,
    /// Double logarithmic, with marked points; earlier lines are wider.
    Logarithmic,
}

/// A named line.
pub struct Line {
    pub name: String,
    pub points: Vec<(f64, f64)>,
    /// Which of the colours; its place in the panel if none is given.
    pub colour: Option<usize>,
}

impl Line {
    pub fn new(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self { name: name.into(), points: points.into_iter().collect(), colour: None }
    }

    /// The same colour in every panel for what is the same thing.
    #[allow(dead_code)] // each example uses its part
    pub fn coloured(self, colour: usize) -> Self {
        Self { colour: Some(colour), ..self }
    }
}

/// One chart.
pub struct Panel {
    pub title: String,
    pub x: String,
    pub y: String,
    pub axes: Axes,
    pub lines: Vec<Line>,
}

/// Draws the panels below each other.
pub fn draw(path: &Path, size: Size, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new(path, (size.width, size.height * panels.len() as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    for (area, panel) in root.split_evenly((panels.len(), 1)).iter().zip(panels) {
        let (chart, legend) = area.split_horizontally(size.width - size.legend_width);
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

fn coloured(panel: &Panel) -> impl Iterator<Item = (&Line, &'static RGBColor)> {
    panel.lines.iter().enumerate().map(|(place, line)| {
        let colour = line.colour.unwrap_or(place) % COLOURS.len();
        (line, &COLOURS[colour])
    })
}

fn draw_lines(area: &DrawingArea<SVGBackend, Shift>, panel: &Panel) -> Result<(), Box<dyn Error>> {
    let points = || panel.lines.iter().flat_map(|line| &line.points);
    let margin = if panel.axes == Axes::Logarithmic { 0.0 } else { 0.06 };
    let x = range(points().map(|point| point.0), 0.0);
    let y = range(points().map(|point| point.1), margin);
    if panel.axes == Axes::Logarithmic {
        let wide = |(low, high): (f64, f64)| (low / 1.5..high * 1.5).log_scale();
        let label = |value: &f64| format!("{value:.0e}");
        return draw_in(area, panel, (wide(x), wide(y)), [&label, &label]);
    }
    let instant = move |value: &f64| short(*value, x.1 - x.0);
    let number = move |value: &f64| short(*value, y.1 - y.0);
    draw_in(area, panel, (x.0..x.1, y.0..y.1), [&instant, &number])
}

/// The text of a number on an axis.
type Label = dyn Fn(&f64) -> String;

/// The panel in axes with their labels.
fn draw_in<X, Y>(
    area: &DrawingArea<SVGBackend, Shift>,
    panel: &Panel,
    (x, y): (X, Y),
    [x_label, y_label]: [&Label; 2],
) -> Result<(), Box<dyn Error>>
where
    X: AsRangedCoord<Value = f64>,
    Y: AsRangedCoord<Value = f64>,
    X::CoordDescType: ValueFormatter<f64>,
    Y::CoordDescType: ValueFormatter<f64>,
{
    let mut chart = ChartBuilder::on(area)
        .caption(&panel.title, ("sans-serif", 17))
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(86)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc(&panel.x)
        .y_desc(&panel.y)
        .x_label_formatter(&x_label)
        .y_label_formatter(&y_label)
        .y_labels(7)
        .label_style(("sans-serif", 13))
        .axis_desc_style(("sans-serif", 14))
        .draw()?;
    for (i, (line, colour)) in coloured(panel).enumerate() {
        let width = match panel.axes {
            Axes::Signals => 1,
            Axes::Linear | Axes::Logarithmic => 2 + 2 * (panel.lines.len() - 1 - i) as u32,
        };
        chart.draw_series(LineSeries::new(line.points.iter().copied(), colour.stroke_width(width)))?;
        if panel.axes == Axes::Logarithmic {
            let mark = |&point: &(f64, f64)| Circle::new(point, 2 + width as i32, colour.filled());
            chart.draw_series(line.points.iter().map(mark))?;
        }
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
