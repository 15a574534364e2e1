//! Plots with logarithmic axes, as SVG, readable in black and white.

use std::error::Error;

use plotters::coord::Shift;
use plotters::coord::combinators::{BindKeyPoints, WithKeyPoints};
use plotters::element::ComposedElement;
use plotters::prelude::*;

use groundtruth::math::{exp, ln, power};
use statistics::slope::PowerLaw;
use text::document::{self, Node};

/// A series of points.
#[derive(Clone, Debug, Default)]
pub struct Series {
    /// The name in the legend.
    pub name: String,
    /// The points; only those with positive and finite coordinates are drawn.
    pub points: Vec<(f64, f64)>,
    /// Labels beside the points; none, or one for each.
    pub labels: Vec<String>,
    /// A fitted line, and the smallest and largest `x` that it is drawn for.
    pub fit: Option<(PowerLaw, [f64; 2])>,
    /// Whether points are joined by a line, if there is no fit.
    pub joined: bool,
}

impl Series {
    /// Points joined by a line.
    pub fn joined(name: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let points = points.into_iter().collect();
        Self { name: name.to_owned(), points, joined: true, ..Self::default() }
    }
}

/// A plot with logarithmic axes.
#[derive(Clone, Debug)]
pub struct Plot<'a> {
    /// The quantity and unit of x.
    pub x: &'a str,
    /// The quantity and unit of y.
    pub y: &'a str,
    /// At most five series, distinguished by marker and colour.
    pub series: Vec<Series>,
    /// A horizontal line at this value, and its label.
    pub limit: Option<(f64, &'a str)>,
}

const SIZE: (u32, u32) = (640, 440);
const FONT: &str = "sans-serif";
/// Dark enough for paper, and different as shades of grey.
const COLORS: [(u8, u8, u8); 5] =
    [(0, 0, 0), (196, 78, 0), (0, 90, 170), (0, 120, 70), (130, 60, 140)];
const GRID: RGBColor = RGBColor(205, 205, 205);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Axis = WithKeyPoints<LogCoord<f64>>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;
type Marker<'a, At> =
    ComposedElement<At, SVGBackend<'a>, Polygon<(i32, i32)>, PathElement<(i32, i32)>>;
type Drawn = Result<(), Box<dyn Error + Send + Sync>>;

impl Plot<'_> {
    /// The plot with a caption below it.
    pub fn figure(&self, caption: impl Into<Node>) -> document::Element {
        let mut svg = String::new();
        let drawn = self.draw(&SVGBackend::with_string(&mut svg, SIZE).into_drawing_area());
        drawn.expect("writing to a string does not fail");
        document::figure(Node::Drawing(svg), caption)
    }

    fn draw(&self, area: &Area<'_>) -> Drawn {
        let points: Vec<(f64, f64)> =
            self.series.iter().flat_map(|series| visible(&series.points)).collect();
        let limit = self.limit.map(|(y, _)| y);
        let [x0, x1] = range(points.iter().map(|p| p.0), 0.06);
        let [y0, y1] = range(points.iter().map(|p| p.1).chain(limit), 0.06);
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .margin_right(24)
            .x_label_area_size(44)
            .y_label_area_size(68)
            .build_cartesian_2d(
                (x0..x1).log_scale().with_key_points(ticks(x0, x1)),
                (y0..y1).log_scale().with_key_points(ticks(y0, y1)),
            )?;
        self.draw_axes(&mut chart)?;
        if let Some((y, label)) = self.limit {
            let ends = [(x0, y), (x1, y)];
            chart.draw_series(DashedLineSeries::new(ends, 6, 4, BLACK.stroke_width(1)))?;
            let label = Text::new(label.to_owned(), (4, -16), (FONT, 12).into_font());
            chart.draw_series([EmptyElement::at((x0, y)) + label])?;
        }
        let mut labels = Labels { x: [x0, x1], y: [y0, y1], positions: Vec::new() };
        for (index, series) in self.series.iter().enumerate() {
            series.draw(&mut chart, Mark::of(index), &mut labels)?;
        }
        chart
            .configure_series_labels()
            .position(emptiest_corner(&points, ([x0, x1], [y0, y1]), self.series.len()))
            .background_style(WHITE.mix(0.85))
            .border_style(GRID)
            .label_font((FONT, 13))
            .draw()?;
        area.present()?;
        Ok(())
    }

    fn draw_axes(&self, chart: &mut Chart<'_, '_>) -> Drawn {
        chart
            .configure_mesh()
            .bold_line_style(GRID)
            .light_line_style(TRANSPARENT)
            .axis_style(BLACK)
            .x_labels(8)
            .y_labels(8)
            .x_desc(self.x)
            .y_desc(self.y)
            .axis_desc_style((FONT, 14))
            .label_style((FONT, 13))
            .x_label_formatter(&|x| tick(*x))
            .y_label_formatter(&|y| tick(*y))
            .draw()?;
        Ok(())
    }
}

impl Series {
    fn draw<'a, 'b: 'a>(
        &self,
        chart: &mut Chart<'a, 'b>,
        mark: Mark,
        labels: &mut Labels,
    ) -> Drawn {
        let color = mark.color;
        let line: Vec<(f64, f64)> = match self.fit {
            Some((law, ends)) => ends.map(|x| (x, law.factor * power(x, law.exponent))).into(),
            None if self.joined => visible(&self.points).collect(),
            None => Vec::new(),
        };
        chart.draw_series(LineSeries::new(line, color.stroke_width(1)))?;
        let marks = visible(&self.points).map(|at| mark.at(at, 0));
        // in the middle of a line of the legend
        chart.draw_series(marks)?.label(&self.name).legend(move |at| mark.at(at, 10));
        let words = self.points.iter().zip(&self.labels).map(|(&at, label)| {
            let style = (FONT, 11).into_font().color(&color);
            EmptyElement::at(at) + Text::new(label.clone(), labels.offset(at), style)
        });
        chart.draw_series(words)?;
        Ok(())
    }
}

/// The marker of a series.
#[derive(Clone, Copy)]
struct Mark {
    /// The outline in pixels.
    outline: &'static [(i32, i32)],
    color: RGBColor,
    fill: RGBColor,
}

impl Mark {
    /// The marker of the series with this index.
    fn of(index: usize) -> Self {
        const DISK: &[(i32, i32)] =
            &[(4, 0), (3, 3), (0, 4), (-3, 3), (-4, 0), (-3, -3), (0, -4), (3, -3), (4, 0)];
        const SQUARE: &[(i32, i32)] = &[(-4, -4), (4, -4), (4, 4), (-4, 4), (-4, -4)];
        const TRIANGLE: &[(i32, i32)] = &[(0, -5), (5, 4), (-5, 4), (0, -5)];
        const DIAMOND: &[(i32, i32)] = &[(0, -6), (5, 0), (0, 6), (-5, 0), (0, -6)];
        let (red, green, blue) = COLORS[index % 5];
        let color = RGBColor(red, green, blue);
        let outline = [DISK, SQUARE, TRIANGLE, DIAMOND, DISK][index % 5];
        let is_filled = [true, false, true, false, false][index % 5];
        Self { outline, color, fill: if is_filled { color } else { WHITE } }
    }

    /// The marker at a point, moved to the right by this number of pixels.
    fn at<'a, C>(self, at: C, right: i32) -> Marker<'a, C> {
        let outline: Vec<_> = self.outline.iter().map(|(x, y)| (x + right, *y)).collect();
        EmptyElement::at(at)
            + Polygon::new(outline.clone(), self.fill.filled())
            + PathElement::new(outline, self.color.stroke_width(2))
    }
}

/// The labels beside points, placed without overlap if possible.
struct Labels {
    x: [f64; 2],
    y: [f64; 2],
    /// The positions of the labels so far, in pixels.
    positions: Vec<(i32, i32)>,
}

impl Labels {
    /// The offset of the label of a point, in pixels.
    fn offset(&mut self, (x, y): (f64, f64)) -> (i32, i32) {
        let pixel = |fraction: f64, pixels: u32| (fraction * f64::from(pixels)) as i32;
        let (across, up) = (axis_fraction(x, self.x), axis_fraction(y, self.y));
        let at = (pixel(across, SIZE.0 - 100), pixel(1.0 - up, SIZE.1 - 60));
        let moved = |&(dx, dy): &(i32, i32)| (at.0 + dx, at.1 + dy);
        let free = |offset: &(i32, i32)| {
            let (x, y) = moved(offset);
            self.positions.iter().all(|p| (p.0 - x).abs() > 12 || (p.1 - y).abs() > 10)
        };
        let around = [(6, -12), (6, 3), (-16, -12), (-16, 3), (-4, -20), (-4, 10), (-4, -30)];
        let further_up = (2..).map(|lines| (-4, -20 - 11 * lines));
        let offset = around.into_iter().chain(further_up).find(free).expect("there is no end");
        self.positions.push(moved(&offset));
        offset
    }
}

/// The position of a value on a logarithmic axis, from 0 to 1.
fn axis_fraction(value: f64, [low, high]: [f64; 2]) -> f64 {
    ln(value / low) / ln(high / low)
}

/// The corner with the fewest points, for a legend of `lines` lines.
fn emptiest_corner(
    points: &[(f64, f64)],
    (x_range, y_range): ([f64; 2], [f64; 2]),
    lines: usize,
) -> SeriesLabelPosition {
    let (width, height) = (0.35, 0.05 + 0.06 * lines as f64);
    let near_end = |fraction: f64, low: bool, size: f64| {
        if low { fraction < size } else { fraction > 1.0 - size }
    };
    let inside = |&(left, upper, _): &(bool, bool, SeriesLabelPosition)| {
        let here = |&&(x, y): &&(f64, f64)| {
            near_end(axis_fraction(x, x_range), left, width)
                && near_end(axis_fraction(y, y_range), !upper, height)
        };
        points.iter().filter(here).count()
    };
    let corners = [
        (true, true, SeriesLabelPosition::UpperLeft),
        (false, true, SeriesLabelPosition::UpperRight),
        (false, false, SeriesLabelPosition::LowerRight),
        (true, false, SeriesLabelPosition::LowerLeft),
    ];
    corners.into_iter().min_by_key(inside).expect("there are four").2
}

/// Powers of ten; if there are fewer than four, also 2 and 5 times these; if these are fewer than two, multiples of a
/// round step.
fn ticks(low: f64, high: f64) -> Vec<f64> {
    let inside = |values: &[f64]| -> Vec<f64> {
        let all = (-30..=30).flat_map(|n| values.iter().map(move |&v| decimal(v, n)));
        all.filter(|v| (low..=high).contains(v)).collect()
    };
    let (tens, fives) = (inside(&[1.0]), inside(&[1.0, 2.0, 5.0]));
    if tens.len() >= 4 {
        return tens;
    }
    if fives.len() >= 2 {
        return fives;
    }
    let most = 0.25 * (high - low);
    let steps = (-30..=30).rev().flat_map(|n| [5.0, 2.0, 1.0].map(|v| (v, n)));
    let is_fine = |&(v, n): &(f64, i32)| decimal(v, n) <= most;
    let Some((v, n)) = steps.into_iter().find(is_fine) else { return fives };
    let [first, last] = [(low / decimal(v, n)).ceil(), (high / decimal(v, n)).floor()];
    (first as u64..=last as u64).map(|times| decimal(times as f64 * v, n)).collect()
}

/// `digits` times this power of ten, rounded once.
fn decimal(digits: f64, exponent: i32) -> f64 {
    let ten = power(10.0, f64::from(exponent.abs()));
    if exponent < 0 { digits / ten } else { digits * ten }
}

/// `0.01`, `20`, `10⁷`.
fn tick(x: f64) -> String {
    let scientific = format!("{x:e}");
    match scientific.split_once('e').filter(|_| !(0.001..=1000.0).contains(&x)) {
        Some(("1", exponent)) => format!("10{}", superscript(exponent)),
        Some((digit, exponent)) => format!("{digit}·10{}", superscript(exponent)),
        None => format!("{x}"),
    }
}

/// An integer in superscript, for powers of ten: `⁻⁷`.
fn superscript(integer: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    integer.chars().map(raised).collect()
}

fn visible(points: &[(f64, f64)]) -> impl Iterator<Item = (f64, f64)> + '_ {
    let fits = |v: f64| v > 0.0 && v.is_finite();
    points.iter().copied().filter(move |&(x, y)| fits(x) && fits(y))
}

/// The range of the values, with a margin as a fraction of the logarithmic range.
fn range(values: impl Iterator<Item = f64>, margin: f64) -> [f64; 2] {
    let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        return [1.0, 10.0];
    }
    let wide = ln(high / low).max(1.0) * margin;
    [low * exp(-wide), high * exp(wide)]
}
