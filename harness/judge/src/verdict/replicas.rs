//! Our pictures with other seeds, rendered as they are needed.

use groundtruth::film::Film;
use groundtruth::render::{Canvas, Crop};
use groundtruth::samplers;
use groundtruth::world::World;

use pictures::compare;

/// Renders a world's picture; whether it was finished, and not interrupted by the user.
pub type Renders<'a> = &'a mut dyn FnMut(&World, &Canvas) -> bool;

/// Our replicas so far.
pub struct Replicas<'a, 'b> {
    /// The scene's world.
    pub world: &'a mut World,
    /// In which direction film points are off by half a pixel.
    pub direction: [i32; 2],
    /// The seed of the first.
    pub first: u64,
    /// The seed of the next.
    pub next: u64,
    /// Those that were rendered first.
    pub films: Vec<Film>,
    /// How they are rendered.
    pub renders: Renders<'b>,
}

impl<'a, 'b> Replicas<'a, 'b> {
    /// None so far, of a scene's world; `seed` is that of the first.
    pub fn new(world: &'a mut World, seed: u64, renders: Renders<'b>) -> Self {
        Self { world, direction: [0, 0], first: seed, next: seed, films: Vec::new(), renders }
    }

    /// The next replica; `None` if the user interrupts.
    pub fn render(&mut self) -> Option<Film> {
        self.world.reseed(self.next);
        let size @ [width, height] = [self.world.image.width, self.world.image.height];
        let canvas = match self.direction {
            [0, 0] => Canvas::new(self.world),
            direction => {
                let [x, y] = compare::shift(self.world, direction);
                Canvas::cropped(Crop { x, y, width, height })
            }
        };
        let is_whole = (self.renders)(self.world, &canvas);
        [self.world.image.width, self.world.image.height] = size;
        self.next += 1;
        is_whole.then(|| canvas.film())
    }

    /// Renders the first ones with another sampler; the former ones are returned.
    pub fn resample(&mut self, sampler: Option<samplers::Kind>) -> Vec<Film> {
        let (count, former) = (self.films.len(), std::mem::take(&mut self.films));
        self.world.image.sampler = sampler;
        self.next = self.first;
        self.fill(count);
        former
    }

    /// Renders until there are so many films, or the user interrupts.
    pub fn fill(&mut self, count: usize) {
        while self.films.len() < count {
            let Some(film) = self.render() else { return };
            self.films.push(film);
        }
    }
}
