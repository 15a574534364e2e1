//! The checkers, which both targets write by our formula.

use groundtruth::textures::{Checker3d, Kind, Paint, PlaneChecker};

/// What our solid checker adds to `x / size`, so that no face lies on a border.
const OFFSET: f64 = -0.000_187_453_738;

/// Cells of two colours: the first where the sum of `floor(x / size + offset)` over some axes is even, the second where it is odd.
pub(super) struct Cells<'a> {
    /// 0 is x.
    pub axes: &'static [usize],
    pub size: f64,
    pub offset: f64,
    pub colors: [&'a Paint; 2],
    /// The width of lines along their borders, and its colour.
    pub lines: Option<(f64, &'a Paint)>,
}

impl<'a> Cells<'a> {
    /// The cells of a checker; `None` of other textures.
    pub fn of(kind: &'a Kind) -> Option<Self> {
        Some(match kind {
            Kind::Checker3d(Checker3d { size, color1, color2 }) => Self {
                axes: &[0, 1, 2],
                size: *size,
                offset: OFFSET,
                colors: [color1, color2],
                lines: None,
            },
            Kind::PlaneChecker(PlaneChecker {
                size,
                color1,
                color2,
                outline_width,
                outline_color,
            }) => Self {
                axes: &[0, 2],
                size: *size,
                offset: 0.0,
                colors: [color1, color2],
                lines: (*outline_width > 0.0).then_some((*outline_width, outline_color)),
            },
            _ => return None,
        })
    }
}
