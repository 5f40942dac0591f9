//! Line charts as SVG, linear or double logarithmic.

use std::error::Error;
use std::path::Path;

use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::prelude::*;

/// Colours that differ for colour-blind eyes as well (Okabe and Ito).
const COLOURS: [RGBColor; 4] =
    [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];

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

/// Title, axes and their kind.
pub struct Chart {
    title: &'static str,
    x: &'static str,
    y: &'static str,
    logarithmic: bool,
}

impl Chart {
    pub fn linear(title: &'static str, x: &'static str, y: &'static str) -> Self {
        Self { title, x, y, logarithmic: false }
    }

    pub fn logarithmic(title: &'static str, x: &'static str, y: &'static str) -> Self {
        Self { title, x, y, logarithmic: true }
    }

    /// Writes the file.
    pub fn draw(&self, path: &Path, lines: &[Line]) -> Result<(), Box<dyn Error>> {
        let span = |of: fn(&(f64, f64)) -> f64| {
            lines
                .iter()
                .flat_map(|line| &line.points)
                .map(of)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)))
        };
        let (x, y) = (span(|p| p.0), span(|p| p.1));
        if self.logarithmic {
            let wide = |(low, high): (f64, f64)| (low / 1.5..high * 1.5).log_scale();
            self.draw_in(path, lines, wide(x), wide(y), true)
        } else {
            let margin = 0.06 * (y.1 - y.0);
            self.draw_in(path, lines, x.0..x.1, y.0 - margin..y.1 + margin, false)
        }
    }

    fn draw_in<X, Y>(
        &self,
        path: &Path,
        lines: &[Line],
        x: X,
        y: Y,
        marked: bool,
    ) -> Result<(), Box<dyn Error>>
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        let root = SVGBackend::new(path, (900, 420)).into_drawing_area();
        root.fill(&WHITE)?;
        let (area, legend) = root.split_horizontally(640);
        let mut chart = ChartBuilder::on(&area)
            .caption(self.title, ("sans-serif", 17))
            .margin(12)
            .x_label_area_size(42)
            .y_label_area_size(80)
            .build_cartesian_2d(x, y)?;
        let label = |value: &f64| if marked { format!("{value:.0e}") } else { format!("{value:.1}") };
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .x_desc(self.x)
            .y_desc(self.y)
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .draw()?;
        for (i, (line, colour)) in lines.iter().zip(COLOURS.iter().cycle()).enumerate() {
            // Earlier lines are wider, so that lines upon each other are all seen.
            let width = 2 + 2 * (lines.len() - 1 - i) as u32;
            chart.draw_series(LineSeries::new(line.points.iter().copied(), colour.stroke_width(width)))?;
            if marked {
                chart.draw_series(
                    line.points.iter().map(|&point| Circle::new(point, 2 + width as i32, colour.filled())),
                )?;
            }
            let y = 60 + 24 * i as i32;
            legend.draw(&PathElement::new([(4, y), (26, y)], colour.stroke_width(3)))?;
            legend.draw(&Text::new(line.name.as_str(), (34, y - 7), ("sans-serif", 14)))?;
        }
        root.present()?;
        Ok(())
    }
}
