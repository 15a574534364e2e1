//! The textures: colours as functions of the point, in the formulas of our own textures.

use groundtruth::rgb::Rgb;
use groundtruth::textures::{Checker3d, Kind, Paint, PlaneChecker};

use super::Writer;
use super::text::{number, rgb};
use crate::export::How;

/// What our solid checker adds to `x / size`, so that no face lies on a border.
const OFFSET: f64 = -0.000_187_453_738;

/// Cells of two colours.
struct Cells<'a> {
    axes: &'a [&'static str],
    size: f64,
    offset: f64,
    colors: [&'a Paint; 2],
    /// Half the width of lines along their borders, as a part of the size; 0 for none.
    half_line: f64,
    line: &'a Paint,
}

impl Writer<'_> {
    /// How a texture of a colour is exported, and the words of its pigment; `None` if they cannot be said.
    pub(super) fn texture(&mut self, path: &str, kind: &Kind) -> (How, Option<String>) {
        match kind {
            Kind::RandomColors(_) => {
                (How::Exact("a pigment for each shape"), Some(format!("rgb {}", rgb(Rgb::BLACK))))
            }
            Kind::Checker3d(Checker3d { size, color1, color2 }) => {
                let (axes, colors) = (["x", "y", "z"].as_slice(), [color1, color2]);
                let (half_line, line) = (0.0, color1);
                let cells = Cells { axes, size: *size, offset: OFFSET, colors, half_line, line };
                let note = "as a function of our formula; two plain colours";
                (How::Exact(note), self.cells(path, &cells))
            }
            Kind::PlaneChecker(PlaneChecker {
                size,
                color1,
                color2,
                outline_width,
                outline_color,
            }) => {
                let (axes, colors) = (["x", "z"].as_slice(), [color1, color2]);
                let (half_line, line) = (0.5 * outline_width / size, outline_color);
                let cells = Cells { axes, size: *size, offset: 0.0, colors, half_line, line };
                (How::Exact("so too; plain colours"), self.cells(path, &cells))
            }
            _ => {
                self.refuse(path, "a texture");
                (How::None(""), None)
            }
        }
    }

    /// The first colour where the sum of `floor(x / size + offset)` is even, the second where it is odd, the third where
    /// `x / size` is nearer to an integer than half a line.
    ///
    /// POV-Ray's own `checker` has its borders at other places, by a tolerance. A function has ours. Its value is 1/6, 3/6
    /// or 5/6, which the map of colours tells apart at 1/3 and 2/3.
    fn cells(&mut self, path: &str, cells: &Cells<'_>) -> Option<String> {
        let Cells { axes, size, offset, colors: [first, second], half_line, line } = *cells;
        let first = self.paint(&format!("{path}.color1"), first);
        let second = self.paint(&format!("{path}.color2"), second);
        let line = self.paint(&format!("{path}.outline_color"), line);
        let (first, second, line) = (rgb(first?), rgb(second?), rgb(line?));
        let at = |axis: &&str| format!("{axis}/{}", number(size));
        let floor = |axis: &&str| format!("floor({}+{})", at(axis), number(offset));
        let sum = axes.iter().map(floor).collect::<Vec<_>>().join("+");
        let mut value = format!("(1+2*abs(mod({sum},2)))/6");
        if half_line > 0.0 {
            let fraction = |axis: &&str| format!("{0}-floor({0})", at(axis));
            let border = |axis: &&str| format!("{0},1-({0})", fraction(axis));
            let nearest = axes.iter().map(border).collect::<Vec<_>>().join(",");
            value = format!("select(min({nearest})-{},5/6,{value})", number(half_line));
        }
        Some(format!(
            "function {{ {value} }} color_map {{ [1/3 rgb {first}] [1/3 rgb {second}] [2/3 rgb {second}] [2/3 rgb {line}] }}"
        ))
    }
}
