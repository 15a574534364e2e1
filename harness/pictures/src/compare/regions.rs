//! Connected regions of pixels that differ.

use serde::Serialize;

use super::{Decoded, difference};

/// The most regions that are listed.
const MOST: usize = 10;

/// Pixels that differ and touch each other, also at corners.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Region {
    /// The number of its pixels.
    pub pixels: u64,
    /// Its left column, top row, and the numbers of columns and rows of the box around it.
    pub bounds: [u32; 4],
    /// The pixel with the largest difference: x right and y down, from 0.
    pub worst: [u32; 2],
    /// The radiances of both pictures there.
    pub values: [[f64; 3]; 2],
    /// The largest difference of a channel there; infinite for NaN.
    pub difference: f64,
}

/// The regions of the most pixels, and the one with the largest difference.
pub fn largest_and_worst(
    a: &Decoded<'_>,
    b: &Decoded<'_>,
    differs: &[bool],
) -> (Vec<Region>, Option<Region>) {
    let [width, height] = a.picture.size;
    let mut rest = differs.to_vec();
    let mut regions = Vec::new();
    for start in 0..rest.len() {
        if !rest[start] {
            continue;
        }
        rest[start] = false;
        let mut open = vec![start];
        let mut region: Option<(Region, [u32; 2])> = None;
        while let Some(at) = open.pop() {
            let pixel = [(at % width as usize) as u32, (at / width as usize) as u32];
            let values = [a.at(at), b.at(at)];
            region = Some(with(region, pixel, values));
            for [x, y] in neighbours(pixel, [width, height]) {
                let next = y as usize * width as usize + x as usize;
                if std::mem::take(&mut rest[next]) {
                    open.push(next);
                }
            }
        }
        regions.extend(region.map(|(region, _)| region));
    }
    regions.sort_by(|a, b| b.pixels.cmp(&a.pixels).then(b.difference.total_cmp(&a.difference)));
    // of equal ones the first
    let worst = regions.iter().rev().max_by(|a, b| a.difference.total_cmp(&b.difference)).copied();
    regions.truncate(MOST);
    (regions, worst)
}

/// The region with one pixel more, and its right bottom corner.
fn with(
    region: Option<(Region, [u32; 2])>,
    pixel @ [x, y]: [u32; 2],
    values: [[f64; 3]; 2],
) -> (Region, [u32; 2]) {
    let difference = difference(values);
    let single = Region { pixels: 0, bounds: [x, y, 1, 1], worst: pixel, values, difference };
    let (mut region, [right, bottom]) = region.unwrap_or((single, pixel));
    if difference > region.difference {
        (region.worst, region.values, region.difference) = (pixel, values, difference);
    }
    let [left, top, ..] = region.bounds;
    let ([left, top], [right, bottom]) = ([left.min(x), top.min(y)], [right.max(x), bottom.max(y)]);
    region.pixels += 1;
    region.bounds = [left, top, right - left + 1, bottom - top + 1];
    (region, [right, bottom])
}

fn neighbours([x, y]: [u32; 2], [width, height]: [u32; 2]) -> impl Iterator<Item = [u32; 2]> {
    let rows = y.saturating_sub(1)..=(y + 1).min(height - 1);
    rows.flat_map(move |row| {
        let columns = x.saturating_sub(1)..=(x + 1).min(width - 1);
        columns.map(move |column| [column, row])
    })
}
