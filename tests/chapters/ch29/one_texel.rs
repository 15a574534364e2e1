//! Skies that are black except for one texel: where it shines, light is looked for.

use groundtruth::background::{Directions, Dome, Image};

use super::sky::{DOMES, FILTERINGS, sky, written};
use crate::prelude::*;

/// Columns and rows: few, since each texel has a sky of its own.
const FEW: [u32; 2] = [6, 5];

/// Positions within a texel: near its borders, where a bilinear look-up reads the neighbours, and inside.
const WITHIN: [f64; 4] = [0.02, 0.45, 0.55, 0.98];

/// Law: wherever the sky shines, directions are drawn with a positive density; so also beside a single bright
/// texel, in every column and row: over the seam of the image, where the last column is beside the first, and
/// in the rows at the poles. Oracle: the radiance itself, seen from near the borders of all texels.
#[test]
fn no_light_of_a_single_texel_is_missed() {
    let [width, height] = FEW;
    let turn = Transform::from_steps(&[Step::RotateY(20.0)]).expect("a turn");
    for bright in (0..width * height).map(|i| [i % width, i / width]) {
        let name = format!("one-texel-{}-{}", bright[0], bright[1]);
        let file = written(&name, FEW, |at| Rgb::grey(if at == bright { 5.0 } else { 0.0 }));
        for (dome, filtering) in DOMES.into_iter().flat_map(|it| FILTERINGS.map(|by| (it, by))) {
            let image = Image { filtering, rotate_y: 20.0, ..Image::of_file(&file, dome) };
            let sky = sky(&image);
            let directions = Directions::new(&sky);
            let along = |count: u32| {
                let part = move |i: u32, within: f64| (f64::from(i) + within) / f64::from(count);
                (0..count).flat_map(move |i| WITHIN.map(|within| part(i, within)))
            };
            let (mut shining, mut on_image) = (0, 0);
            for uv in along(height).flat_map(|v| along(width).map(move |u| [u, v])) {
                let Some(w) = dome.direction(uv).map(|w| turn.vector(w)) else { continue };
                on_image += u32::from([0, 1].map(|i| (uv[i] * f64::from(FEW[i])) as u32) == bright);
                let (seen, pdf) = (sky.radiance(w), directions.pdf(w));
                shining += u32::from(!seen.is_black());
                assert!(
                    seen.is_black() || pdf > 0.0,
                    "{dome:?}, {filtering:?}, bright texel {bright:?}: {seen:?} is seen at {uv:?}, but \
                     never drawn"
                );
            }
            at_least!(
                shining,
                on_image,
                "{dome:?}, {filtering:?}: the texel {bright:?} is not seen"
            );
            let mut random = Pcg32::new(29, 9);
            let drawn =
                (0..200).filter_map(|_| directions.sample([random.uniform(), random.uniform()]));
            let lit = drawn.filter(|w| !sky.radiance(*w).is_black()).count();
            let is_cut = matches!(dome, Dome::LightProbe | Dome::Panoramic);
            assert!(
                is_cut || lit > 20,
                "{dome:?}, {filtering:?}, {bright:?}: {lit} draws of 200 see it"
            );
        }
    }
}
