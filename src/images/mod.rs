//! Images for textures and environment lights that need no file: drawn by a formula, or listed
//! (Suffern, ch. 29).

mod drawn;

use formats::images::Texels;

use crate::invalid::Invalid;
use crate::rgb::Rgb;

pub use drawn::{Drawn, Picture};

/// The colour of a texel, at a column from the left and a row from the bottom, as the book counts.
///
/// # Panics
/// If the column or the row is out of range.
pub fn color(texels: &Texels, column: u32, row: u32) -> Rgb {
    Rgb::from(texels.color(column, row).map(f64::from))
}

/// The image of these rows of linear colours, from the top down.
///
/// # Errors
/// [`Invalid`] if there are none, if the rows differ in length, or if a colour is negative or not
/// finite.
pub(crate) fn listed(rows: &[Vec<Rgb>]) -> Result<Texels, Invalid> {
    let width = rows.first().map_or(0, Vec::len);
    if width == 0 {
        return Err(Invalid::new("found no colours; an image has at least one texel"));
    }
    for (i, row) in rows.iter().enumerate() {
        if row.len() != width {
            let problem = format!("found {} colours, but the first row has {width}", row.len());
            return Err(Invalid::new(problem).inside(i));
        }
        for (j, color) in row.iter().enumerate() {
            color.checked("").map_err(|e| Invalid { path: vec![i.into(), j.into()], ..e })?;
        }
    }
    let colors = rows.iter().flatten().map(|color| color.to_array().map(|x| x as f32)).collect();
    Ok(Texels::new(width as u32, rows.len() as u32, colors))
}
