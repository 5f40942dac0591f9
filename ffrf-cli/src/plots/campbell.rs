//! A Campbell diagram.

use anyhow::{Result, anyhow};
use ffrf_host::analysis::{CampbellPoint, Whirl};
use plotters::prelude::{
    ChartBuilder, Circle, Color, IntoDrawingArea, LineSeries, PathElement, SVGBackend, SeriesLabelPosition,
    WHITE,
};

use super::{GREY, PALE, colour, draw_series_names, text};

const SIZE: (u32, u32) = (960, 600);
/// Multiples of the speed that are drawn as excitation.
const ORDERS: [f64; 2] = [1.0, 2.0];
/// Frequencies beyond this multiple of the largest excitation are left out, unless nothing would be left.
const BEYOND: f64 = 2.5;

/// SVG: frequencies against speed, coloured by whirl, with the lines of excitation. Errors: there is nothing to draw.
pub fn draw(points: &[CampbellPoint]) -> Result<String> {
    let fastest = points.iter().map(|point| point.speed).fold(0.0, f64::max);
    let frequencies = || points.iter().map(CampbellPoint::frequency_hz).filter(|f| *f > 0.0);
    let highest = frequencies().fold(0.0, f64::max);
    let excitation = ORDERS[1] * fastest / std::f64::consts::TAU;
    if !(fastest > 0.0 && highest > 0.0) {
        return Err(anyhow!("there is nothing to plot: no speed or no frequency is above zero"));
    }
    let limit = BEYOND * excitation;
    let top = 1.05 * frequencies().filter(|f| *f <= limit).fold(0.0, f64::max).max(excitation);
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&area)
            .caption("Campbell diagram", text(20))
            .margin(14)
            .x_label_area_size(42)
            .y_label_area_size(64)
            .build_cartesian_2d(0.0..fastest, 0.0..top)?;
        chart
            .configure_mesh()
            .x_desc("speed / rad/s")
            .y_desc("frequency / Hz")
            .label_style(text(12))
            .axis_desc_style(text(14))
            .light_line_style(WHITE)
            .bold_line_style(PALE)
            .axis_style(GREY)
            .draw()?;
        for order in ORDERS {
            let line = [(0.0, 0.0), (fastest, order * fastest / std::f64::consts::TAU)];
            let stroke = GREY.mix(0.55).stroke_width(1);
            chart
                .draw_series(LineSeries::new(line, stroke))?
                .label(format!("{order} x speed"))
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], stroke));
        }
        let kinds = [
            (Whirl::Forward, "forward"),
            (Whirl::Backward, "backward"),
            (Whirl::Planar, "planar"),
            (Whirl::Axial, "axial, torsional"),
            (Whirl::Rotating, "as the rotating frame sees it"),
        ];
        for (number, (whirl, name)) in kinds.into_iter().enumerate() {
            let style = colour(number).filled();
            let shown = |point: &&CampbellPoint| {
                point.whirl == whirl && point.frequency_hz() > 0.0 && point.frequency_hz() <= top
            };
            let chosen: Vec<(f64, f64)> =
                points.iter().filter(shown).map(|point| (point.speed, point.frequency_hz())).collect();
            if chosen.is_empty() {
                continue;
            }
            chart
                .draw_series(chosen.into_iter().map(|place| Circle::new(place, 3, style)))?
                .label(name)
                .legend(move |(x, y)| Circle::new((x + 9, y), 3, style));
        }
        draw_series_names(&mut chart, SeriesLabelPosition::UpperLeft)?;
        area.present()?;
    }
    Ok(svg)
}
