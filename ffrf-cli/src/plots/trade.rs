//! Error against cost: every run, or the Pareto front of them.

use std::collections::BTreeMap;

use anyhow::{Result, anyhow};
use plotters::prelude::{
    ChartBuilder, Circle, Color, IntoDrawingArea, IntoLogRange, LineSeries, SVGBackend, SeriesLabelPosition,
    WHITE,
};

use super::{GREY, PALE, colour, draw_series_names, text};

/// What stands at the axis of cost.
pub const COST_TIME: &str = "processor time of the host / s per simulated s";
/// The same of compiled code.
pub const COST_OPERATIONS: &str = "operations of compiled code per simulated s";

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct TradePoint {
    /// What it is coloured by.
    pub series: String,
    /// Runs of one line differ in the step alone.
    pub line: String,
    /// Cost, positive.
    pub cost: f64,
    /// Error over the scale of the quantity.
    pub error: f64,
    /// Whether no other is both cheaper and more exact.
    pub on_front: bool,
}

const SIZE: (u32, u32) = (960, 600);

/// SVG of every run, those that differ in the step alone joined. `own`: error of the reference.
pub fn draw_work_precision(title: &str, cost: &str, points: &[TradePoint], own: f64) -> Result<String> {
    draw(&format!("Work and precision: {title}"), cost, points, own, false)
}

/// SVG of the Pareto front among every run. `own`: error of the reference.
pub fn draw_pareto(title: &str, cost: &str, points: &[TradePoint], own: f64) -> Result<String> {
    draw(&format!("Pareto front: {title}"), cost, points, own, true)
}

fn draw(caption: &str, cost: &str, points: &[TradePoint], own: f64, front: bool) -> Result<String> {
    // errors of nothing at all cannot stand on an axis of logarithms
    let points: Vec<&TradePoint> = points.iter().filter(|p| p.cost > 0.0 && p.error > 0.0).collect();
    let range = |numbers: &mut dyn Iterator<Item = f64>| {
        numbers.fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)))
    };
    let (left, right) = range(&mut points.iter().map(|p| p.cost));
    let lines = own.is_finite() && own > 0.0;
    let (low, high) = range(&mut points.iter().map(|p| p.error).chain(lines.then_some(own)));
    if points.is_empty() {
        return Err(anyhow!("there is nothing to plot: no run has an error above zero"));
    }
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&area)
            .caption(caption, text(20))
            .margin(14)
            .x_label_area_size(46)
            .y_label_area_size(72)
            .build_cartesian_2d((0.7 * left..1.4 * right).log_scale(), (0.5 * low..2.0 * high).log_scale())?;
        chart
            .configure_mesh()
            .x_desc(cost)
            .y_desc("error over the scale of the quantity")
            .x_label_formatter(&|x| format!("{x:.0e}"))
            .y_label_formatter(&|y| format!("{y:.0e}"))
            .label_style(text(12))
            .axis_desc_style(text(14))
            .light_line_style(WHITE)
            .bold_line_style(PALE)
            .axis_style(GREY)
            .draw()?;
        if lines {
            let stroke = GREY.mix(0.6).stroke_width(1);
            chart
                .draw_series(LineSeries::new([(0.7 * left, own), (1.4 * right, own)], stroke))?
                .label("error of the reference itself")
                .legend(move |(x, y)| plotters::prelude::PathElement::new([(x, y), (x + 18, y)], stroke));
        }
        let mut series: Vec<&str> = points.iter().map(|p| p.series.as_str()).collect();
        series.sort_unstable();
        series.dedup();
        for (number, name) in series.into_iter().enumerate() {
            let mine = || points.iter().filter(|p| p.series == name);
            if !front {
                let mut joined: BTreeMap<&str, Vec<(f64, f64)>> = BTreeMap::new();
                mine().for_each(|p| joined.entry(&p.line).or_default().push((p.cost, p.error)));
                for line in joined.into_values() {
                    chart.draw_series(LineSeries::new(line, colour(number).mix(0.3).stroke_width(1)))?;
                }
            }
            let faint = colour(number).mix(if front { 0.25 } else { 0.8 }).filled();
            let style = colour(number).filled();
            chart
                .draw_series(mine().map(|p| Circle::new((p.cost, p.error), 3, faint)))?
                .label(name)
                .legend(move |(x, y)| Circle::new((x + 9, y), 3, style));
            if front {
                chart.draw_series(
                    mine().filter(|p| p.on_front).map(|p| Circle::new((p.cost, p.error), 5, style)),
                )?;
            }
        }
        if front {
            chart.draw_series(LineSeries::new(staircase(&points), GREY.stroke_width(2)))?;
        }
        draw_series_names(&mut chart, SeriesLabelPosition::LowerLeft)?;
        area.present()?;
    }
    Ok(svg)
}

/// The front as the border of what can be reached: right, then down.
fn staircase(points: &[&TradePoint]) -> Vec<(f64, f64)> {
    let mut best: Vec<(f64, f64)> = points.iter().filter(|p| p.on_front).map(|p| (p.cost, p.error)).collect();
    best.sort_by(|a, b| a.0.total_cmp(&b.0));
    let corners = best.iter().enumerate().flat_map(|(k, (cost, error))| {
        let before = best[k.saturating_sub(1)].1;
        [(*cost, if k == 0 { *error } else { before }), (*cost, *error)]
    });
    corners.collect()
}
