//! What a golden image shows: the picture itself, or what its rays met.

use serde::{Deserialize, Serialize};

use groundtruth::film::{Film, Tone};
use groundtruth::lobes::Lobes;
use groundtruth::math::Ray;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::trace::{Outcome, RayKind, Recorder, ShadingPoint, Term};
use groundtruth::world::World;

/// A way to look at a scene. Beauty hides where a bug is; the others show it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// The picture.
    #[default]
    Radiance,
    /// The stored normal where the first sample's camera ray hits; 0 where it hits nothing.
    Normals,
    /// Of the first sample: red, `t` of the camera ray; green, the hit object's place in the scene,
    /// from 1; blue, the number of rays cast. Red and green are 0 where it hits nothing.
    Hits,
}

impl View {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Radiance, Self::Normals, Self::Hits];

    /// What is added to a scene's name: nothing, `.normals` or `.hits`.
    pub fn suffix(self) -> &'static str {
        match self {
            Self::Radiance => "",
            Self::Normals => ".normals",
            Self::Hits => ".hits",
        }
    }

    /// The view of a golden's name, and the rest of the name.
    pub fn split(name: &str) -> (Self, &str) {
        let others = Self::ALL.into_iter().filter(|view| !view.is_radiance());
        let mut found = others.filter_map(|view| Some((view, name.strip_suffix(view.suffix())?)));
        found.next().unwrap_or((Self::Radiance, name))
    }

    pub(super) fn is_radiance(&self) -> bool {
        *self == Self::Radiance
    }

    /// The picture in this view.
    pub fn render(self, world: &World) -> Film {
        if self == Self::Radiance {
            return render::render(world);
        }
        let [width, height] = world.picture_size();
        let mut film = Film::new(width, height);
        for y in 0..film.height() {
            for x in 0..film.width() {
                film.set([x, y], self.pixel(world, [x, y]));
            }
        }
        film
    }

    /// A pixel of that picture.
    pub fn pixel(self, world: &World, pixel: [u32; 2]) -> Rgb {
        if self == Self::Radiance {
            return render::pixel(world, pixel);
        }
        let mut first = FirstHit::default();
        render::sample(world, pixel, 0, &mut first);
        if self == Self::Normals { first.normal } else { first.numbers() }
    }

    /// The picture for eyes, to be shown with [`View::tone`].
    pub fn for_eyes(self, film: &Film) -> Film {
        let pixels = film.pixels();
        let largest = |channel: fn(&Rgb) -> f64| {
            let largest = pixels.iter().map(channel).fold(0.0, f64::max);
            if largest > 0.0 { largest } else { 1.0 }
        };
        let scale = Rgb::new(largest(|p| p.r), largest(|p| p.g), largest(|p| p.b));
        let mut shown = Film::new(film.width(), film.height());
        for (i, &pixel) in pixels.iter().enumerate() {
            let at = [i as u32 % film.width(), i as u32 / film.width()];
            shown.set(
                at,
                match self {
                    Self::Radiance => pixel,
                    Self::Normals => pixel.map(|c| 0.5 + 0.5 * c),
                    Self::Hits => Rgb::new(pixel.r / scale.r, pixel.g / scale.g, pixel.b / scale.b),
                },
            );
        }
        shown
    }

    /// How the picture for eyes is shown.
    pub fn tone(self, scene: &Scene) -> Tone {
        let gamma = if self == Self::Radiance { scene.image.gamma } else { 1.0 };
        Tone { gamma, ..scene.image.tone() }
    }
}

/// Hears what becomes of the camera's ray, and counts all of them.
#[derive(Default)]
struct FirstHit {
    rays: u32,
    t: f64,
    object: u32,
    normal: Rgb,
}

impl FirstHit {
    fn numbers(&self) -> Rgb {
        Rgb::new(self.t, self.object.into(), self.rays.into())
    }
}

impl Recorder for FirstHit {
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {
        self.rays += 1;
    }

    fn hit(&mut self, point: &ShadingPoint<'_>, _: &Lobes) {
        if self.rays == 1 {
            self.t = point.hit.t;
            self.object = point.hit.object.index + 1;
            self.normal = point.hit.surface.normal.to_array().into();
        }
    }

    fn term(&mut self, _: Term) {}

    fn leave(&mut self, outcome: Outcome, _: Rgb, _: Rgb) {
        if outcome == Outcome::TooDeep {
            self.rays -= 1; // it was not cast
        }
    }
}
