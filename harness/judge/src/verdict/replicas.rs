//! Our pictures with other seeds, rendered as they are needed.

use groundtruth::film::Film;
use groundtruth::render::{Canvas, Crop};
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
    /// Where those come from that are not of the world, by their seeds.
    source: Option<Source<'b>>,
}

/// A picture with a seed; `None` if there is none.
type Source<'a> = &'a dyn Fn(u64) -> Option<Film>;

impl<'a, 'b> Replicas<'a, 'b> {
    /// None so far, of a scene's world; `seed` is that of the first.
    pub fn new(world: &'a mut World, seed: u64, renders: Renders<'b>) -> Self {
        let [first, next] = [seed; 2];
        Self { world, direction: [0, 0], first, next, films: Vec::new(), renders, source: None }
    }

    /// None so far, of another program's pictures of the world.
    pub fn of_others<'c>(&'c mut self, source: Source<'c>) -> Replicas<'c, 'c> {
        let (seed, renders) = (self.first, &mut *self.renders);
        Replicas { source: Some(source), ..Replicas::new(self.world, seed, renders) }
    }

    /// Does something with other replicas, of which there are none yet, and then goes on with these. Seeds that were taken stay
    /// taken.
    pub fn aside<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> T {
        let films = std::mem::take(&mut self.films);
        let (image, time) = (self.world.image.clone(), self.world.view.exposure_time);
        let found = work(self);
        (self.world.image, self.world.view.exposure_time) = (image, time);
        (self.films, self.direction) = (films, [0, 0]);
        found
    }

    /// The next replica; `None` if the user interrupts.
    pub fn render(&mut self) -> Option<Film> {
        if let Some(source) = self.source {
            self.next += 1;
            return source(self.next - 1);
        }
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

    /// Renders until there are so many films, or the user interrupts.
    pub fn fill(&mut self, count: usize) {
        while self.films.len() < count {
            // two that are equal have no random numbers
            let is_fixed = matches!(&*self.films, [first, second, ..] if first == second);
            let film = if is_fixed { Some(self.films[0].clone()) } else { self.render() };
            let Some(film) = film else { return };
            self.films.push(film);
        }
    }
}
