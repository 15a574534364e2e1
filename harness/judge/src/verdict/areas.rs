//! The areas of a picture over which values are added up: tiles of every side, and objects.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use groundtruth::math::Span;
use groundtruth::render;
use groundtruth::world::World;

/// What a pixel shows whose ray hits nothing.
pub(super) const BACKGROUND: &str = "the background";

/// The areas of the pictures of one scene.
#[derive(Clone, Debug)]
pub struct Areas {
    /// Columns and rows.
    pub size: [usize; 2],
    /// The object that each pixel shows, by its place in `objects`.
    pub object_of: Vec<u32>,
    /// The names of the objects that the picture shows, and the number of their pixels.
    pub objects: Vec<(Arc<str>, u32)>,
}

/// An area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Area {
    /// A square of pixels, cut at the right and lower edge.
    Tile {
        /// Its left column and top row.
        corner: [usize; 2],
        /// Its side.
        side: usize,
    },
    /// The pixels that show an object, by its place in [`Areas::objects`].
    Object(usize),
    /// The same, of which only the fine structure counts: how much of ours there is.
    Structure(usize),
}

impl Areas {
    /// Those of a world's picture: a pixel shows the first object that the ray through its centre hits.
    pub fn of(world: &World) -> Self {
        let [width, height] = world.picture_size();
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        let names = pixels.map(|pixel| shown(world, pixel));
        Self::by_key([width, height].map(|side| side as usize), names, Arc::clone)
    }

    /// Those of pixels, row by row, of which each has a key; each key has a name.
    pub(crate) fn by_key<K: Ord>(
        size: [usize; 2],
        keys: impl Iterator<Item = K>,
        name: impl Fn(&K) -> Arc<str>,
    ) -> Self {
        let (mut known, mut objects) = (BTreeMap::new(), Vec::new());
        let object_of = keys.map(|key| {
            let index = *known.entry(key).or_insert_with_key(|key| {
                objects.push((name(key), 0));
                objects.len() - 1
            });
            objects[index].1 += 1;
            index as u32
        });
        Self { size, object_of: object_of.collect(), objects }
    }

    /// Tiles only: the whole picture is one object.
    pub fn tiles(size: [usize; 2]) -> Self {
        let count = size[0] * size[1];
        let objects = vec![("the whole picture".into(), count as u32)];
        Self { size, object_of: vec![0; count], objects }
    }

    /// The number of levels of tiles: sides 1, 2, 4 … up to one tile that holds the whole picture.
    pub fn levels(&self) -> usize {
        let longer = self.size[0].max(self.size[1]);
        longer.next_power_of_two().trailing_zeros() as usize + 1
    }

    /// The number of columns and rows of tiles of a level.
    pub fn grid(&self, level: usize) -> [usize; 2] {
        self.size.map(|side| side.div_ceil(1 << level))
    }

    /// Sums over the tiles of a level, from those of the level before it.
    pub fn coarser(&self, sums: &[f64], level: usize) -> Vec<f64> {
        let ([width, _], [across, down]) = (self.grid(level - 1), self.grid(level));
        let mut coarser = vec![0.0; across * down];
        for (row, sums) in sums.chunks_exact(width).enumerate() {
            let above = &mut coarser[row / 2 * across..];
            for (column, sum) in sums.iter().enumerate() {
                above[column / 2] += sum;
            }
        }
        coarser
    }

    /// Sums over the objects.
    pub fn by_object(&self, values: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.objects.len()];
        for (object, value) in self.object_of.iter().zip(values) {
            sums[*object as usize] += value;
        }
        sums
    }

    /// A tile.
    pub fn tile(&self, level: usize, index: usize) -> Area {
        let (side, across) = (1 << level, self.grid(level)[0]);
        Area::Tile { corner: [index % across * side, index / across * side], side }
    }

    /// The indices of the pixels of an area.
    pub fn pixels(&self, area: Area) -> Vec<usize> {
        let width = self.size[0];
        match area {
            Area::Object(object) | Area::Structure(object) => {
                let is_it = |index: &usize| self.object_of[*index] as usize == object;
                (0..self.object_of.len()).filter(is_it).collect()
            }
            Area::Tile { corner: [x, y], side } => {
                let [columns, rows] = [x..(x + side).min(width), y..(y + side).min(self.size[1])];
                rows.flat_map(|row| columns.clone().map(move |column| row * width + column))
                    .collect()
            }
        }
    }

    /// Of areas, each with what it is of, the first that have no pixel in common with one before them, at most so many; with their
    /// pixels.
    pub(crate) fn apart<T>(
        &self,
        all: impl Iterator<Item = (Area, T)>,
        most: usize,
    ) -> Vec<(T, Vec<usize>)> {
        let mut taken = vec![false; self.object_of.len()];
        let mut apart = Vec::new();
        for (area, it) in all {
            if apart.len() == most {
                break;
            }
            let pixels = self.pixels(area);
            if !pixels.iter().any(|pixel| taken[*pixel]) {
                pixels.iter().for_each(|pixel| taken[*pixel] = true);
                apart.push((it, pixels));
            }
        }
        apart
    }

    /// The left column, top row, columns and rows of the box around these pixels.
    pub(crate) fn bounds(&self, pixels: &[usize]) -> [usize; 4] {
        let along = |of: &dyn Fn(usize) -> usize| {
            let all = || pixels.iter().map(|pixel| of(*pixel));
            let least = all().min().expect("there are pixels");
            [least, all().max().unwrap_or(least) - least + 1]
        };
        let width = self.size[0];
        let [[x, w], [y, h]] = [along(&|at| at % width), along(&|at| at / width)];
        [x, y, w, h]
    }

    /// For each of these pictures, the mean over some channels of some pixels.
    pub(crate) fn means(
        pictures: &[Vec<f32>],
        pixels: &[usize],
        channels: Range<usize>,
    ) -> Vec<f64> {
        let count = (channels.len() * pixels.len()) as f64;
        let mean = |picture: &Vec<f32>| {
            let values = pixels.iter().flat_map(|pixel| &picture[3 * pixel..][channels.clone()]);
            values.map(|value| f64::from(*value)).sum::<f64>() / count
        };
        pictures.iter().map(mean).collect()
    }
}

/// The name of the object that the centre of a pixel shows.
fn shown(world: &World, pixel: [u32; 2]) -> Arc<str> {
    let Some((eye, column)) = world.view.eye_of_column(pixel[0], world.image.width) else {
        return "the gap between the images".into();
    };
    let film = render::film_point(&world.image, [column, pixel[1]], [0.5, 0.5]);
    let hit = eye.ray(film, [0.0; 2]).and_then(|ray| world.hit(&ray, Span::AHEAD));
    hit.map_or_else(|| BACKGROUND.into(), |hit| hit.object.name.clone())
}
