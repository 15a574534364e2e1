//! A shift by half a pixel: their film points are the corners of our pixels. The shifted picture is rendered, not
//! interpolated.
//!
//! Film points are counted from the middle of the picture. In a picture with one column more and pixels of the
//! same size, the point of each pixel is therefore half a pixel farther left, and that of its right neighbour
//! half a pixel farther right; rows are alike.

use groundtruth::render;
use groundtruth::world::World;
use rayon::prelude::*;

use super::hypotheses::{EXPLAINED, Hypothesis, evenly_spread};
use super::{Decoded, Picture};

/// At most about so many pixels are rendered for each shift.
const PIXELS: usize = 1 << 12;

/// The shifts by half a pixel with which the scene explains another picture of its size, the best first; `name` is
/// that of the other picture. None for stereo pairs, whose two images have film points of their own.
pub fn half_pixel_shifts(world: &mut World, theirs: &Picture, name: &str) -> Vec<Hypothesis> {
    let shifts = half_pixel_directions(world, theirs, None).into_iter();
    shifts
        .map(|(direction, left)| Hypothesis { what: half_pixel_words(direction, name), left })
        .collect()
}

/// The directions, x right, y down, in which the film points of the other picture lie from the centres of pixels, each
/// with the part of the difference that it leaves, the best first. `alike` is a picture of the scene from another seed:
/// its distance is noise.
pub fn half_pixel_directions(
    world: &mut World,
    theirs: &Picture,
    alike: Option<&Picture>,
) -> Vec<([i32; 2], f64)> {
    if world.view.stereo().is_some() || world.picture_size() != theirs.size {
        return Vec::new();
    }
    let theirs = Decoded::new(theirs);
    let noise = alike.map_or(0.0, |alike| distance(world, &Decoded::new(alike), [0, 0]));
    let before = distance(world, &theirs, [0, 0]) - noise;
    let directions = [-1, 0, 1].into_iter().flat_map(|x| [-1, 0, 1].map(|y| [x, y]));
    let mut found: Vec<([i32; 2], f64)> = directions
        .filter(|direction| *direction != [0, 0])
        .map(|direction| {
            let left = (distance(world, &theirs, direction) - noise).max(0.0) / before;
            (direction, left)
        })
        .filter(|(_, left)| before > 0.0 && *left <= EXPLAINED)
        .collect();
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    found
}

/// What is said of a picture whose film points lie in this direction from the centres of pixels, x right, y down:
/// what it shows is shifted the other way.
pub fn half_pixel_words([dx, dy]: [i32; 2], name: &str) -> String {
    let part = |along: i32, [less, more]: [&str; 2]| match along {
        0 => None,
        -1 => Some(format!("half a pixel too far {more}")),
        _ => Some(format!("half a pixel too far {less}")),
    };
    let parts = [part(dx, ["left", "right"]), part(dy, ["up", "down"])];
    let parts = parts.into_iter().flatten().collect::<Vec<_>>().join(" and ");
    let reason = if dx != 0 && dy != 0 { " (corners of pixels taken for centres)" } else { "" };
    format!("{name} is {parts}{reason}")
}

/// Makes the world's picture one column or row larger, so that film points lie half a pixel off in this direction;
/// returns the column and row of its pixel that was the first.
pub fn shift(world: &mut World, direction: [i32; 2]) -> [u32; 2] {
    world.image.width += u32::from(direction[0] != 0);
    world.image.height += u32::from(direction[1] != 0);
    // a step to the right or down is the next pixel of the larger picture
    direction.map(|along| u32::from(along == 1))
}

/// The mean relative distance of radiance, rendered with film points half a pixel off in this direction, from what
/// each value of the other picture may stand for; black counts as a thousandth of the mean.
fn distance(world: &mut World, theirs: &Decoded<'_>, direction: [i32; 2]) -> f64 {
    let size = [world.image.width, world.image.height];
    let [right, down] = shift(world, direction);
    let shifted: &World = world;
    let pairs: Vec<([f64; 3], [f32; 3])> = evenly_spread(theirs.picture.size, PIXELS)
        .into_par_iter()
        .map(|[x, y]| [x as u32, y as u32])
        .map(|[x, y]| {
            let ours = render::pixel(shifted, [x + right, y + down]).to_array();
            (ours, theirs.picture.values[theirs.picture.index([x, y])])
        })
        .collect();
    [world.image.width, world.image.height] = size;
    let channels = || pairs.iter().flat_map(|(ours, theirs)| ours.iter().copied().zip(*theirs));
    let finite = || channels().filter(|(ours, theirs)| ours.is_finite() && theirs.is_finite());
    let count = finite().count().max(1) as f64;
    let total: f64 = finite().map(|(ours, _)| ours.abs()).sum();
    let floor = 1e-3 * total / count + f64::MIN_POSITIVE;
    let apart = |(ours, stored): (f64, f32)| {
        let [least, most] = theirs.interval(stored);
        let nearest = ours.clamp(least, most);
        (ours - nearest).abs() / (ours.abs() + nearest.abs() + floor)
    };
    finite().map(apart).sum::<f64>() / count
}
