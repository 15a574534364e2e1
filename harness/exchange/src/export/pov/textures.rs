//! The textures: colours as functions of the point, in the formulas of our own textures.

use groundtruth::rgb::Rgb;
use groundtruth::textures::Kind;

use super::Writer;
use super::text::{number, rgb};
use crate::export::How;
use crate::export::checkers::Cells;

impl Writer<'_> {
    /// How a texture of a colour is exported, and the words of its pigment; `None` if they cannot be said.
    pub(super) fn texture(&mut self, path: &str, kind: &Kind) -> (How, Option<String>) {
        let note = match kind {
            Kind::RandomColors(_) => {
                let pigment = format!("rgb {}", rgb(Rgb::BLACK));
                return (How::Exact("a pigment for each shape"), Some(pigment));
            }
            Kind::PlaneChecker(_) => "so too; plain colours",
            _ => "as a function of our formula; two plain colours",
        };
        match Cells::of(kind) {
            Some(cells) => (How::Exact(note), self.cells(path, &cells)),
            None => {
                self.refuse(path, "a texture");
                (How::None(""), None)
            }
        }
    }

    /// The function of the cells, with a third colour where `x / size` is nearer to an integer than half a line.
    ///
    /// POV-Ray's own `checker` has its borders at other places, by a tolerance. A function has ours. Its value is 1/6, 3/6
    /// or 5/6, which the map of colours tells apart at 1/3 and 2/3.
    fn cells(&mut self, path: &str, cells: &Cells<'_>) -> Option<String> {
        let Cells { axes, size, offset, colors: [first, second], lines } = *cells;
        let (width, line) = lines.unwrap_or((0.0, first));
        let axes: Vec<&str> = axes.iter().map(|axis| ["x", "y", "z"][*axis]).collect();
        let first = self.color(&format!("{path}.color1"), first);
        let second = self.color(&format!("{path}.color2"), second);
        let line = self.color(&format!("{path}.outline_color"), line);
        let (first, second, line) = (rgb(first?), rgb(second?), rgb(line?));
        let at = |axis: &&str| format!("{axis}/{}", number(size));
        let floor = |axis: &&str| format!("floor({}+{})", at(axis), number(offset));
        let sum = axes.iter().map(floor).collect::<Vec<_>>().join("+");
        let mut value = format!("(1+2*abs(mod({sum},2)))/6");
        if width > 0.0 {
            let fraction = |axis: &&str| format!("{0}-floor({0})", at(axis));
            let border = |axis: &&str| format!("{0},1-({0})", fraction(axis));
            let nearest = axes.iter().map(border).collect::<Vec<_>>().join(",");
            value = format!("select(min({nearest})-{},5/6,{value})", number(0.5 * width / size));
        }
        Some(format!(
            "function {{ {value} }} color_map {{ [1/3 rgb {first}] [1/3 rgb {second}] [2/3 rgb {second}] [2/3 rgb {line}] }}"
        ))
    }
}
