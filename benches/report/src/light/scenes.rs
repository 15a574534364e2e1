//! The scenes of the page, and the tracers and samplings that are compared in each.

use serde::Serialize;

use groundtruth::lights::{Area, Kind as LightKind};
use groundtruth::lobes::GlossyRule;
use groundtruth::materials::{Dielectric, Emissive, Kind as MaterialKind, Medium};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::samplers::MultiJittered;
use groundtruth::scene::build::{
    add, boxed, checker3d, grey, ground, matte, pinhole, point, sphere,
};
use groundtruth::scene::{Depth, Light, Material, Scene, Tracer, Whitted};
use groundtruth::shapes::{Rectangle, Sampling};

/// A scene of the page.
#[derive(Serialize)]
pub struct LightScene {
    #[serde(rename = "scene")]
    pub name: &'static str,
    /// A description, and its difficulty.
    pub about: &'static str,
    #[serde(skip)]
    pub scene: fn() -> Scene,
}

/// The `max_depth` of every tracer and of the reference.
pub const DEPTH: u32 = 10;

pub static SUBJECTS: [LightScene; 5] = [
    LightScene {
        name: "Cornell box",
        about: "Matte walls and blocks under a small area light (figure 26.12), with light reflected \
                between the walls.",
        scene: || of_gallery("ch26/cornell-box"),
    },
    LightScene {
        name: "glossy hall",
        about: "The hall of mirrors with glossy reflection, e = 25000 (figure 25.10), lit by four spheres \
                at the positions of the book's point lights: light is reflected many times between \
                mirrors.",
        scene: glossy_hall,
    },
    LightScene {
        name: "glass over checker",
        about: "A glass ball over a checker, under a square area light: only paths that hit the light by \
                chance find the light through the glass.",
        scene: glass_over_checker,
    },
    LightScene {
        name: "caustic ring",
        about: "Half a cylinder with a mirror inside, whose caustic on the ground is a cardioid (figure \
                26.9): only paths that hit the small light by chance through the mirror find it.",
        scene: || of_gallery("ch26/half-cylinder-caustic"),
    },
    LightScene {
        name: "many small lights",
        about: "36 small area lights above matte balls, not in the picture: all of them are sampled at \
                each hit, which takes long; paths without sampling rarely hit one.",
        scene: many_small_lights,
    },
];

/// A tracer and a sampling of area lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    pub tracer: Tracer,
    /// How area lights are sampled; `None` if they are not.
    pub sampling: Option<Sampling>,
}

impl Method {
    /// The name in the tables.
    pub fn name(self) -> String {
        let sampling = match self.sampling {
            None => "",
            Some(Sampling::Area) => " (area)",
            Some(Sampling::SolidAngle) => " (solid angle)",
        };
        format!("{}{sampling}", self.tracer.name())
    }
}

impl LightScene {
    /// All methods for the scene; the last one has no bias and the least noise.
    pub fn methods(&self) -> Vec<Method> {
        let of_tracer = |tracer: Tracer| {
            let samplings: &[_] = match tracer {
                Tracer::PathTrace(_) => &[None],
                _ => &[Some(Sampling::Area), Some(Sampling::SolidAngle)],
            };
            samplings.iter().map(move |&sampling| Method { tracer, sampling })
        };
        let depth = Depth { max_depth: DEPTH };
        let tracers = [
            Tracer::RayCast,
            Tracer::Whitted(Whitted { max_depth: DEPTH }),
            Tracer::PathTrace(depth),
            Tracer::GlobalTrace(depth),
            Tracer::Path(depth),
        ];
        // without mirrors, glossy or transparent materials `whitted` is `ray_cast`
        let is_plain = |material: &Material| {
            matches!(material.recipe, MaterialKind::Matte(_) | MaterialKind::Emissive(_))
        };
        let has_mirrors = !(self.scene)().materials.iter().all(is_plain);
        let applies = |tracer: &Tracer| has_mirrors || !matches!(tracer, Tracer::Whitted(_));
        tracers.into_iter().filter(applies).flat_map(of_tracer).collect()
    }

    /// The last method.
    pub fn best(&self) -> Method {
        *self.methods().last().expect("every scene has methods")
    }

    /// The scene with this method, `width` pixels wide; half as wide if it is slow.
    pub fn scene(&self, method: Method, width: u32) -> Scene {
        let mut scene = (self.scene)();
        // many lights are slow
        let width = if scene.lights.len() > 10 { (width / 2).max(1) } else { width };
        let height = (width * scene.image.height).div_ceil(scene.image.width);
        scene.image.resize(width, height);
        scene.image.sampler = Some(MultiJittered {}.into());
        scene.tracer = method.tracer;
        for light in &mut scene.lights {
            if let LightKind::Area(area) = &mut light.source {
                area.sampling = method.sampling;
            }
        }
        scene
    }
}

/// Sets the rule of every glossy reflector of a scene; `false` if there is none.
pub fn set_rule(scene: &mut Scene, wanted: GlossyRule) -> bool {
    let mut found = false;
    for material in &mut scene.materials {
        if let MaterialKind::GlossyReflector(glossy) = &mut material.recipe {
            glossy.rule = wanted;
            found = true;
        }
    }
    found
}

fn of_gallery(name: &str) -> Scene {
    (gallery::find(name).expect("a scene of the gallery").build)()
}

/// The point lights are replaced by spheres, because paths cannot hit a point.
fn glossy_hall() -> Scene {
    let mut scene = of_gallery("ch25/glossy-hall");
    scene.lights.clear();
    for (i, (x, z)) in [(9.0, 0.0), (-9.0, 0.0), (0.0, 9.0), (0.0, -9.0)].into_iter().enumerate() {
        add_lamp(&mut scene, &format!("lamp {}", i + 1), sphere(point(x, 9.5, z), 1.0), 40.0);
    }
    scene
}

fn add_lamp(scene: &mut Scene, name: &str, shape: impl Into<groundtruth::shapes::Kind>, ls: f64) {
    scene.lights.push(Light::new(name, Area { object: name.to_owned(), sampling: None }));
    add(scene, name, shape, Emissive::new(ls, Rgb::WHITE));
}

fn glass_over_checker() -> Scene {
    let view = [point(-2.0, 4.5, 12.0), point(0.3, 1.4, 0.0)];
    let mut scene = pinhole("a glass ball over a checker", [400, 300], view, 620.0);
    // its normal points down
    let corner = point(1.0, 7.0, -3.5);
    let lamp = Rectangle { corner, a: 3.0 * Vector::X, b: 3.0 * Vector::Z };
    add_lamp(&mut scene, "lamp", lamp, 12.0);
    let glass = Dielectric { inside: Medium::clear(1.5), ..Dielectric::default() };
    add(&mut scene, "ball", sphere(point(0.0, 1.6, 0.0), 1.5), glass);
    let block = boxed(point(1.5, 0.0, -3.5), point(3.5, 2.0, -1.5));
    add(&mut scene, "block", block, matte(0.0, 0.7, Rgb::new(0.9, 0.4, 0.2)));
    add(&mut scene, "ground", ground(0.0), matte(0.0, 0.8, checker3d(1.0, Rgb::WHITE, grey(0.3))));
    scene
}

fn many_small_lights() -> Scene {
    const SIDE: u32 = 6;
    let view = [point(0.0, 4.0, 14.0), point(0.0, 0.2, 1.0)];
    let mut scene = pinhole("36 small lamps above balls", [400, 300], view, 560.0);
    for i in 0..SIDE * SIDE {
        let along = |k: u32| 2.0 * (f64::from(k) - 0.5 * f64::from(SIDE - 1));
        // at different heights, so that shadows have different lengths
        let height = 6.0 + 0.5 * f64::from(i % 5);
        let at = point(along(i % SIDE), height, along(i / SIDE));
        add_lamp(&mut scene, &format!("lamp {}", i + 1), sphere(at, 0.1), 60.0);
    }
    for (i, (x, z)) in [(-3.0, 0.0), (0.0, -1.5), (2.6, 1.0), (-0.6, 2.6)].into_iter().enumerate() {
        let color = Rgb::new(0.9, 0.9 - 0.2 * i as f64, 0.3 + 0.2 * i as f64);
        let name = format!("ball {}", i + 1);
        add(&mut scene, &name, sphere(Point::new(x, 1.0, z), 1.0), matte(0.0, 0.7, color));
    }
    add(&mut scene, "ground", ground(0.0), matte(0.0, 0.7, Rgb::WHITE));
    scene
}
