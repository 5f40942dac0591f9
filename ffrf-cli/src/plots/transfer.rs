//! The truncation error of interface transfer functions as a picture.

use anyhow::{Result, anyhow};
use ffrf_fe::component_modes::TransferPoint;
use plotters::prelude::{
    ChartBuilder, Color, IntoDrawingArea, IntoLogRange, LineSeries, RGBColor, SVGBackend, WHITE,
};

const SIZE: (u32, u32) = (900, 560);
const FULL: RGBColor = RGBColor(60, 60, 60);
const REDUCED: RGBColor = RGBColor(214, 110, 0);
const ERROR: RGBColor = RGBColor(0, 104, 181);

/// SVG: scaled receptance of the full and of the reduced model, and the error between them.
pub fn draw(points: &[TransferPoint]) -> Result<String> {
    let mut svg = String::new();
    let last = points.last().map_or(1.0, |point| point.frequency_hz);
    let values = || points.iter().flat_map(|p| [p.full, p.reduced, p.error]).filter(|x| *x > 0.0);
    let low = values().fold(f64::INFINITY, f64::min).max(1e-14);
    let high = values().fold(f64::MIN_POSITIVE, f64::max);
    if !(low.is_finite() && high > 0.0) {
        return Err(anyhow!("there is nothing to plot: {} frequencies", points.len()));
    }
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&area)
            .caption("Interface transfer functions against the full model", ("sans-serif", 20))
            .margin(12)
            .x_label_area_size(42)
            .y_label_area_size(72)
            .build_cartesian_2d(0.0..last, (0.5 * low..2.0 * high).log_scale())?;
        chart
            .configure_mesh()
            .x_desc("frequency / Hz")
            .y_desc("elastic receptance over static compliance; relative error")
            .y_label_formatter(&|value| format!("{value:.0e}"))
            .draw()?;
        type Reading = fn(&TransferPoint) -> f64;
        let series: [(&str, RGBColor, Reading); 3] = [
            ("full model", FULL, |point| point.full),
            ("reduced model", REDUCED, |point| point.reduced),
            ("error", ERROR, |point| point.error),
        ];
        for (label, colour, value) in series {
            let line = points.iter().map(|point| (point.frequency_hz, value(point).max(low)));
            chart.draw_series(LineSeries::new(line, colour.stroke_width(2)))?.label(label).legend(
                move |(x, y)| {
                    plotters::element::PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2))
                },
            );
        }
        chart.configure_series_labels().background_style(WHITE.mix(0.85)).border_style(FULL).draw()?;
        area.present()?;
    }
    Ok(svg)
}
