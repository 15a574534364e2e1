//! Checkers on generic objects, with lines (Suffern, ch. 30): they differ in how they divide a
//! point into columns and rows.

use super::cells::{self, Cell, Checkers, Division};
use super::mapping::{azimuth, distance};
use super::{Lines, Made, Paint, Specification};
use crate::kinds::Resources;
use crate::math::Length;
use crate::rgb::Rgb;

/// Writes the data of a checker: its fields in this order, and `color2`.
macro_rules! checker {
    (
        $(#[$about:meta])*
        $Checker:ident {
            $(#[$of_unit:meta])* unit,
            $(#[$of_columns:meta])* $columns:ident,
            $(#[$of_rows:meta])* $rows:ident,
            $(#[$of_color1:meta])* color1,
            $(#[$of_lines:meta])* lines $(,)?
        }
        divided by $division:expr
    ) => {
        $(#[$about])*
        // white and grey, with the numbers of checkers of the book
        #[kind(Default)]
        pub struct $Checker {
            $(#[$of_unit])*
            #[default(1.0)]
            pub unit: Length,
            $(#[$of_columns])*
            #[default(20)]
            pub $columns: u32,
            $(#[$of_rows])*
            #[default(10)]
            pub $rows: u32,
            $(#[$of_color1])*
            #[default(Rgb::WHITE.into())]
            pub color1: Paint,
            /// The colour of the other checkers.
            #[default(cells::half_grey())]
            pub color2: Paint,
            $(#[$of_lines])*
            #[default]
            pub lines: Lines,
        }

        impl Specification for $Checker {
            fn make(&self, resources: &mut Resources) -> Made {
                let division: Division = $division;
                let counts =
                    [(stringify!($columns), self.$columns), (stringify!($rows), self.$rows)];
                let colors = [&self.color1, &self.color2];
                Checkers::build((self.unit, counts, division), colors, &self.lines, resources)
            }
        }
    };
}

checker! {
    /// Checkers on the open cylinder about the y axis with y from −1 to 1 and any radius: columns
    /// by the azimuth φ, rows by the height `y/2 + 1/2`. Above and below the cylinder the rows
    /// continue. With an odd num_horizontal, the two columns beside φ = 0 have the same colour.
    CylinderChecker {
        /// The length of one unit: half the height of the cylinder; positive.
        unit,
        /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
        num_horizontal,
        /// The number of checkers from y = −1 to y = 1; at least 1.
        num_vertical,
        /// The colour of the first checker, at the lower end and at φ = 0.
        color1,
        /// Lines along the borders; half a line at each end of the cylinder. None if left out.
        lines,
    }
    divided by |[x, y, z], [columns, rows]| {
        [Cell::of_range(azimuth(x, z), columns), Cell::at(rows * (0.5 * y + 0.5))]
    }
}

checker! {
    /// Checkers on the cone about the y axis from y = 0 to its apex at y = 2: columns by the
    /// azimuth φ, rows of height 2/num_vertical. Above and below the cone the rows continue. With
    /// an odd num_horizontal, the two columns beside φ = 0 have the same colour.
    ConeChecker {
        /// The length of one unit: half the height of the cone; positive.
        unit,
        /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
        num_horizontal,
        /// The number of checkers from y = 0 to y = 2; at least 1.
        num_vertical,
        /// The colour of the first checker, at the base and at φ = 0.
        color1,
        /// Lines along the borders; half a line at each end of the cone. None if left out.
        lines,
    }
    divided by |[x, y, z], [columns, rows]| {
        [Cell::of_range(azimuth(x, z), columns), Cell::at(rows * (0.5 * y))]
    }
}

checker! {
    /// Checkers on the disk of radius 1 about the y axis: columns by the azimuth φ, rings of width
    /// 1/num_radial. Outside the rim the rings continue; the colour does not depend on y. With an
    /// odd num_angular, the two columns beside φ = 0 have the same colour.
    DiskChecker {
        /// The length of one unit: the radius of the disk; positive.
        unit,
        /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
        num_angular,
        /// The number of checkers from the centre to the rim; at least 1.
        num_radial,
        /// The colour of the first checker, in the middle and at φ = 0.
        color1,
        /// Lines along the borders: the horizontal ones are circles, the vertical ones radial. Half
        /// a line at the centre and at the rim. None if left out.
        lines,
    }
    divided by |[x, _, z], [columns, rows]| {
        [Cell::of_range(azimuth(x, z), columns), Cell::at(rows * distance(x, z))]
    }
}

checker! {
    /// Checkers on the rectangle −1 … 1 in x and z: columns by `x/2 + 1/2`, rows by `z/2 + 1/2`.
    /// Outside the rectangle they continue; the colour does not depend on y.
    RectangleChecker {
        /// The length of one unit: half the side of the rectangle; positive.
        unit,
        /// The number of checkers from x = −1 to x = 1; at least 1.
        num_horizontal,
        /// The number of checkers from z = −1 to z = 1; at least 1.
        num_vertical,
        /// The colour of the first checker, in the corner x = z = −1.
        color1,
        /// Lines along the borders: the horizontal ones run along x, the vertical ones along z.
        /// Half a line at each side of the rectangle. None if left out.
        lines,
    }
    divided by |[x, _, z], [columns, rows]| {
        [Cell::at(columns * (0.5 * x + 0.5)), Cell::at(rows * (0.5 * z + 0.5))]
    }
}
