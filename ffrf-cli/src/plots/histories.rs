//! Time histories as small multiples that share the time axis.

use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::prelude::{
    ChartBuilder, Color, DrawingArea, IntoDrawingArea, IntoLogRange, LineSeries, PathElement, SVGBackend,
    Text, WHITE,
};

use super::{GREY, PALE, colour, text};

/// One of the multiples.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What is shown.
    pub title: String,
    /// Quantity and unit, for the vertical axis.
    pub axis: String,
    /// Whether the axis is logarithmic; numbers that are not positive are drawn at its lower end.
    pub logarithmic: bool,
    /// Lines with their names.
    pub lines: Vec<(String, Vec<f64>)>,
}

const WIDTH: u32 = 1120;
const PANEL_HEIGHT: u32 = 230;
const HEAD: u32 = 44;
/// Width of the margin with the names of lines.
const LEGEND: i32 = 104;
/// From this many panels on there are two columns.
const TWO_COLUMNS: usize = 4;
/// Most points of a line: more do not show.
const POINTS: usize = 1200;
/// Lower end of a logarithmic axis over its upper end, at most.
const DECADES: f64 = 1e-8;

/// SVG of panels over `axis` (name and unit of the shared abscissa `abscissae`). Errors: there is nothing to draw.
pub fn draw(title: &str, axis: &str, abscissae: &[f64], panels: &[Panel]) -> Result<String> {
    let (Some(first), Some(last)) = (abscissae.first(), abscissae.last()) else {
        return Err(anyhow!("there is nothing to plot"));
    };
    if panels.is_empty() || first >= last {
        return Err(anyhow!("there is nothing to plot: {} panels from {first} to {last}", panels.len()));
    }
    let columns = if panels.len() >= TWO_COLUMNS { 2 } else { 1 };
    let rows = panels.len().div_ceil(columns);
    let mut svg = String::new();
    {
        let size = (WIDTH, HEAD + PANEL_HEIGHT * rows as u32 + 24);
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&WHITE)?;
        let area = area.titled(title, text(22))?;
        for (index, (place, panel)) in area.split_evenly((rows, columns)).iter().zip(panels).enumerate() {
            // the last panel of each column names the abscissa
            let named = index + columns >= panels.len();
            draw_panel(place, panel, abscissae, named.then_some(axis))?;
        }
        area.present()?;
    }
    Ok(svg)
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn draw_panel(place: &Area<'_>, panel: &Panel, abscissae: &[f64], axis: Option<&str>) -> Result<()> {
    let values = || panel.lines.iter().flat_map(|(_, values)| values).copied().filter(|x| x.is_finite());
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    let span = abscissae[0]..abscissae[abscissae.len() - 1];
    let mut builder = ChartBuilder::on(place);
    builder
        .caption(&panel.title, text(16))
        .margin_left(10)
        .margin_right(if panel.lines.len() > 1 { LEGEND } else { 18 })
        .margin_top(4)
        .x_label_area_size(if axis.is_some() { 40 } else { 24 })
        .y_label_area_size(78);
    // the ranges of both kinds of axis are types of their own
    macro_rules! finish {
        ($chart:expr, $clip:expr) => {{
            let mut chart = $chart;
            chart
                .configure_mesh()
                .x_desc(axis.unwrap_or(""))
                .y_desc(&panel.axis)
                .axis_desc_style(text(13))
                .label_style(text(12))
                .light_line_style(WHITE)
                .bold_line_style(PALE)
                .axis_style(GREY)
                .x_labels(8)
                .y_labels(5)
                .y_label_formatter(&|value| tick(*value, low, high, panel.logarithmic))
                .draw()?;
            for (number, (_, values)) in panel.lines.iter().enumerate() {
                let points = thin(abscissae, values).into_iter().map($clip);
                let stroke = colour(number).stroke_width(2);
                chart.draw_series(LineSeries::new(points, stroke))?;
            }
        }};
    }
    if panel.logarithmic {
        let decade = |x: f64| 10_f64.powf(x);
        let top = if high > 0.0 { decade(high.log10().ceil()) } else { 1.0 };
        let positive = values().filter(|x| *x > 0.0).fold(top, f64::min);
        // four decades at least, so that the axis has numbers
        let bottom = decade(positive.log10().floor()).max(top * DECADES).min(1e-4 * top);
        finish!(builder.build_cartesian_2d(span, (bottom..top).log_scale())?, |(t, x): (f64, f64)| (
            t,
            x.max(bottom)
        ));
    } else {
        let (low, high) = padded(low, high);
        finish!(builder.build_cartesian_2d(span, low..high)?, |point: (f64, f64)| point);
    }
    draw_legend(place, panel)
}

/// The names of the lines in the margin on the right, where they cover nothing.
fn draw_legend(place: &Area<'_>, panel: &Panel) -> Result<()> {
    if panel.lines.len() < 2 {
        return Ok(());
    }
    let left = place.dim_in_pixel().0 as i32 - LEGEND + 10;
    for (number, (name, _)) in panel.lines.iter().enumerate() {
        let y = 36 + 18 * number as i32;
        place.draw(&PathElement::new([(left, y), (left + 16, y)], colour(number).stroke_width(2)))?;
        place.draw(&Text::new(name.clone(), (left + 22, y - 7), text(12)))?;
    }
    Ok(())
}

/// Some room above and below; where a line is level, as much as shows that it is.
fn padded(low: f64, high: f64) -> (f64, f64) {
    if !(low.is_finite() && high.is_finite()) {
        return (-1.0, 1.0);
    }
    let room = (0.08 * (high - low)).max(1e-12 * high.abs().max(low.abs()));
    if room > 0.0 { (low - room, high + room) } else { (-1.0, 1.0) }
}

/// A number of an axis, with the digits that tell it from its neighbours.
fn tick(value: f64, low: f64, high: f64, logarithmic: bool) -> String {
    if logarithmic {
        return format!("{value:.0e}");
    }
    let (span, size) = (high - low, high.abs().max(low.abs()));
    if size != 0.0 && !(1e-3..1e5).contains(&size) {
        // a zero that is not quite one
        let value = if value.abs() < 1e-9 * size { 0.0 } else { value };
        let digits = (size / span.max(1e-15 * size)).log10().ceil().clamp(0.0, 12.0) as usize + 1;
        return format!("{value:.digits$e}");
    }
    let digits = (1.5 - span.max(1e-12).log10()).ceil().clamp(0.0, 12.0) as usize;
    format!("{value:.digits$}")
}

/// The lowest and highest point of each of at most [`POINTS`]/2 sections: peaks stay.
fn thin(abscissae: &[f64], values: &[f64]) -> Vec<(f64, f64)> {
    let points: Vec<(f64, f64)> =
        abscissae.iter().copied().zip(values.iter().copied()).filter(|(_, x)| x.is_finite()).collect();
    if points.len() <= POINTS {
        return points;
    }
    let section = points.len().div_ceil(POINTS / 2);
    let extremes = points.chunks(section).flat_map(|points| {
        let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let (low, high) = (points.iter().min_by(by_value), points.iter().max_by(by_value));
        let mut both: Vec<(f64, f64)> = low.into_iter().chain(high).copied().collect();
        both.sort_by(|a, b| a.0.total_cmp(&b.0));
        both
    });
    extremes.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_stay_when_a_line_is_thinned() {
        let times: Vec<f64> = (0..100_000).map(f64::from).collect();
        let mut values = vec![0.0; times.len()];
        values[77_777] = 5.0;
        values[88_888] = -3.0;
        let points = thin(&times, &values);
        assert!(points.len() <= 2 * POINTS, "{}", points.len());
        assert!(points.contains(&(77_777.0, 5.0)) && points.contains(&(88_888.0, -3.0)));
        assert!(points.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    }

    #[test]
    fn nothing_to_draw_is_refused() {
        let panel =
            Panel { title: String::new(), axis: String::new(), logarithmic: false, lines: Vec::new() };
        draw("", "t", &[], std::slice::from_ref(&panel)).unwrap_err();
        draw("", "t", &[0.0, 1.0], &[]).unwrap_err();
        draw("", "t", &[0.0], &[panel]).unwrap_err();
    }
}
