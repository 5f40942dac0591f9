//! The truncation error of interface transfer functions as a picture.

use anyhow::{Result, anyhow};
use ffrf_fe::component_modes::TransferPoint;
use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{
    Cartesian2d, ChartBuilder, ChartContext, Color, DrawingArea, IntoDrawingArea, IntoLogRange, LineSeries,
    LogCoord, PathElement, RGBColor, SVGBackend, SeriesLabelPosition, WHITE,
};

use super::{GREY, PALE, colour, draw_series_names, text};

/// What the basis of one curve is called, and its points.
pub type Curve = (String, Vec<TransferPoint>);

const SIZE: (u32, u32) = (900, 620);
/// Pixels of the upper panel.
const UPPER: u32 = 220;
/// Errors below this are round-off of the full model.
const LEAST_ERROR: f64 = 1e-12;

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, LogCoord<f64>>>;

/// SVG: above the scaled receptance of the full model, below the error of each basis against it.
pub fn draw(curves: &[Curve]) -> Result<String> {
    let points = || curves.iter().flat_map(|(_, points)| points);
    if !points().any(|point| point.full > 0.0) {
        return Err(anyhow!("there is nothing to plot: {} frequencies", points().count()));
    }
    let first = curves.first().map_or(&[][..], |(_, points)| points.as_slice());
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let (upper, lower) = area.split_vertically(UPPER);
        let mut chart = panel(
            &upper,
            "Interface transfer functions: the full model, and the error of reduced ones",
            ("", "receptance / static"),
            first,
            range(first.iter().map(|point| point.full), 0.0),
        )?;
        let line = first.iter().map(|point| (point.frequency_hz, point.full));
        chart.draw_series(LineSeries::new(line, GREY.stroke_width(2)))?;
        let errors = range(points().map(|point| point.error), LEAST_ERROR);
        let mut chart = panel(&lower, "", ("frequency / Hz", "relative error"), first, errors)?;
        for (index, (name, points)) in curves.iter().enumerate() {
            let colour: RGBColor = colour(index);
            let line = points.iter().map(|point| (point.frequency_hz, point.error.max(errors.0)));
            chart
                .draw_series(LineSeries::new(line, colour.stroke_width(2)))?
                .label(name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
        }
        draw_series_names(&mut chart, SeriesLabelPosition::LowerRight)?;
        area.present()?;
    }
    Ok(svg)
}

/// Decades that hold positive values from `least` on.
fn range(values: impl Iterator<Item = f64>, least: f64) -> (f64, f64) {
    let positive = values.filter(|value| *value > 0.0 && value.is_finite());
    let (low, high) = positive.fold((f64::INFINITY, least), |(low, high), x| (x.min(low), x.max(high)));
    let low = if low.is_finite() { low.max(least) } else { 0.1 };
    let high = if high > low { high } else { 10.0 * low };
    (10.0_f64.powf(low.log10().floor()), 10.0_f64.powf(high.log10().ceil()))
}

fn panel<'a, 'b>(
    area: &'a DrawingArea<SVGBackend<'b>, Shift>,
    caption: &str,
    axes: (&str, &str),
    points: &[TransferPoint],
    (low, high): (f64, f64),
) -> Result<Chart<'a, 'b>> {
    let from = points.first().map_or(0.0, |point| point.frequency_hz);
    let to = points.last().map_or(1.0, |point| point.frequency_hz);
    let mut builder = ChartBuilder::on(area);
    builder.margin(8).margin_right(20).x_label_area_size(38).y_label_area_size(74);
    if !caption.is_empty() {
        builder.caption(caption, text(18));
    }
    let mut chart = builder.build_cartesian_2d(from.min(0.0)..to, (low..high).log_scale())?;
    chart
        .configure_mesh()
        .axis_style(GREY)
        .bold_line_style(PALE)
        .light_line_style(WHITE)
        .label_style(text(13))
        .x_desc(axes.0)
        .y_desc(axes.1)
        .y_label_formatter(&|value| format!("{value:.0e}"))
        .draw()?;
    Ok(chart)
}
