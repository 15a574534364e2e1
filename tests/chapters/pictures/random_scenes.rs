//! Random scenes, with every kind of light, material and shape.

use groundtruth::lights::{AmbientOccluder, FakeSpherical, JitteredDirectional, Spot};
use groundtruth::materials::SphereMaterials;
use groundtruth::samplers;
use groundtruth::textures::{self, Checker3d};

use crate::prelude::*;

/// A source of random choices, and a function that is applied to every colour.
struct Die<'a> {
    random: Pcg32,
    tint: &'a dyn Fn(Rgb) -> Rgb,
    /// Whether colours may be textures of every kind; `tint` is not applied to these.
    textures: bool,
}

impl Die<'_> {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.random.uniform()
    }

    fn below(&mut self, n: usize) -> usize {
        self.random.below(n as u32) as usize
    }

    fn is(&mut self) -> bool {
        self.below(2) == 1
    }

    fn point(&mut self, reach: f64) -> Point {
        let mut c = || reach * (2.0 * self.random.uniform() - 1.0);
        Point::new(c(), c(), c())
    }

    fn direction(&mut self) -> Vector {
        self.point(1.0).to_vector() + 1e-3 * Vector::X
    }

    /// A random colour; each channel is 0 or 1 in one of four cases.
    fn color(&mut self) -> Rgb {
        let mut channel = || match self.random.below(8) {
            0 => 0.0,
            1 => 1.0,
            _ => self.random.uniform(),
        };
        let color = Rgb::new(channel(), channel(), channel());
        (self.tint)(color)
    }

    fn paint(&mut self) -> Paint {
        match self.below(3) {
            0 if self.textures => self.texture().into(),
            0 => {
                let (size, color1, color2) = (self.within(0.1, 2.0), self.color(), self.color());
                Checker3d { size, color1: color1.into(), color2: color2.into() }.into()
            }
            _ => self.color().into(),
        }
    }

    /// Any texture that suits every shape.
    fn texture(&mut self) -> textures::Kind {
        let suits = |kind: &textures::Kind| match kind {
            textures::Kind::Image(image) => image.mapping.is_some(),
            _ => true,
        };
        let specimens = textures::Kind::ENTRIES.iter().flat_map(|entry| (entry.specimens)());
        let specimens: Vec<_> = specimens.filter(suits).collect();
        specimens[self.below(specimens.len())].clone()
    }

    fn matte(&mut self) -> Matte {
        Matte {
            ka: self.random.uniform().into(),
            kd: self.random.uniform().into(),
            cd: self.paint(),
        }
    }

    fn phong(&mut self) -> Phong {
        let Matte { ka, kd, cd } = self.matte();
        let exponent = [0.0, 0.25, 1.0, 30.0, 5000.0][self.below(5)];
        Phong {
            ka,
            kd,
            cd,
            ks: (0.5 * self.random.uniform()).into(),
            cs: self.paint(),
            exponent: exponent.into(),
        }
    }

    fn medium(&mut self) -> Medium {
        let eta = [1.0, 1.33, 0.75, 2.4][self.below(4)];
        let absorption = if self.is() { Rgb::BLACK } else { self.color() };
        Medium { eta, absorption }
    }

    fn material(&mut self) -> materials::Kind {
        let kr = self.random.uniform();
        match self.below(8) {
            0 => self.matte().into(),
            1 => self.phong().into(),
            2 => Reflective { phong: self.phong(), kr: kr.into(), cr: self.paint() }.into(),
            3 => {
                let matte = if self.is() { Some(self.matte()) } else { None };
                Emissive { matte, ..Emissive::new(2.0 * kr, self.paint()) }.into()
            }
            4 => {
                let (phong, cr, eta) = (self.phong(), self.paint(), self.within(0.5, 2.5));
                Transparent { phong, kr: kr.into(), cr, kt: (1.0 - kr).into(), eta }.into()
            }
            5 => {
                let (phong, cr, exponent) = (self.phong(), self.paint(), self.within(0.0, 200.0));
                let rule = if self.is() { GlossyRule::Book } else { GlossyRule::Normalised };
                GlossyReflector { phong, kr: kr.into(), cr, exponent: exponent.into(), rule }.into()
            }
            6 => {
                let (inside, outside) = (self.medium(), self.medium());
                Dielectric { phong: self.phong(), inside, outside }.into()
            }
            _ => {
                let mirror = Reflective { phong: self.phong(), kr: kr.into(), cr: self.paint() };
                let materials = vec![self.matte().into(), mirror.into()];
                SphereMaterials { num_horizontal: 5, num_vertical: 3, materials }.into()
            }
        }
    }

    /// Any shape, moved, turned and stretched.
    fn shape(&mut self) -> shapes::Kind {
        let entries = shapes::Kind::ENTRIES;
        let specimens = (entries[self.below(entries.len())].specimens)();
        let shape = specimens[self.below(specimens.len())].clone();
        let mut size = || 0.3 + 0.9 * self.random.uniform();
        let scale = Step::Scale(Vector::new(size(), size(), size()));
        let by = self.point(2.0).to_vector();
        let turn = [Step::RotateX(self.within(0.0, 360.0)), Step::RotateZ(self.within(0.0, 360.0))];
        let [x, z] = turn;
        Instance::new(shape, vec![scale, x, z, Step::Translate(by)]).into()
    }

    fn lamp(&mut self) -> shapes::Kind {
        let center = self.point(3.0);
        let normal = self.direction();
        let size = power(10.0, self.within(-3.0, 0.0));
        match self.below(4) {
            0 => Sphere { center, radius: size, inward: self.is() }.into(),
            1 => Disk { center, normal, radius: size }.into(),
            2 => {
                let a = size * normal;
                Rectangle { corner: center, a, b: a.cross(Vector::new(0.3, 0.5, 0.7)) }.into()
            }
            _ => {
                let steps = vec![
                    Step::Scale(size * Vector::new(1.0, 1.0, 1.0)),
                    Step::Translate(center.to_vector()),
                ];
                Instance::new(TessellatedSphere::new(5, 4, self.is()), steps).into()
            }
        }
    }

    fn light(&mut self) -> lights::Kind {
        let (ls, color, location) = (self.within(0.0, 4.0), self.color(), self.point(4.0));
        let (direction, attenuation) = (self.direction(), [0.0, 1.0, 2.0][self.below(3)]);
        match self.below(8) {
            0 => Ambient { ls, color }.into(),
            1 => {
                let occluded_color = if self.is() { Some(self.color()) } else { None };
                let max_distance = if self.is() { Some(self.within(0.1, 5.0)) } else { None };
                let min_amount = self.random.uniform();
                AmbientOccluder { ls, color, min_amount, occluded_color, max_distance }.into()
            }
            2 => Directional { ls, color, direction }.into(),
            3 => lights::PointLight { ls, color, location, attenuation }.into(),
            4 => {
                let inner = self.within(0.0, 90.0);
                let outer = inner + self.within(0.0, 90.0);
                Spot { ls, color, location, direction, inner, outer, attenuation }.into()
            }
            5 => Environment {}.into(),
            6 => JitteredDirectional { ls, color, direction, jitter: self.random.uniform() }.into(),
            _ => FakeSpherical { ls, color, location, jitter: self.random.uniform(), attenuation }
                .into(),
        }
    }
}

/// A valid scene of 8 × 8 pixels, the same for the same number: up to eight objects over a floor,
/// lamps and other lights; each colour passes through `tint`.
pub fn scene(number: u64, tint: &dyn Fn(Rgb) -> Rgb) -> Scene {
    drawn(&mut Die { random: Pcg32::new(number, 26), tint, textures: false })
}

/// The same with textures of every kind.
pub fn textured_scene(number: u64) -> Scene {
    drawn(&mut Die { random: Pcg32::new(number, 29), tint: &|color| color, textures: true })
}

fn drawn(die: &mut Die<'_>) -> Scene {
    let eye = 9.0 * die.direction().unit().expect("not zero");
    let mut camera =
        Viewpoint::new(Point::ORIGIN + eye, die.point(0.5), Pinhole { distance: 8.0, zoom: 1.0 });
    if die.below(4) == 0 {
        camera.lens = Orthographic { zoom: 1.0 }.into();
    }
    camera.up = Vector::new(0.1, 1.0, 0.2);
    if die.below(4) == 0 {
        camera.medium = die.medium();
    }
    let mut scene = Scene::new("", Image { pixel_size: 0.8, ..Image::new(8, 8) }, camera);
    scene.background = die.color().into();
    scene.image.samples = [1, 4][die.below(2)];
    if die.is() {
        scene.image.sampler = Some(samplers::Random {}.into());
    }
    if die.below(4) > 0 {
        scene.tracer = Tracer::Whitted(Whitted { max_depth: die.below(5) as u32 });
    }
    let floor = Plane { point: Point::new(0.0, -2.0, 0.0), normal: Vector::Y }.into();
    let count = 1 + die.below(8);
    for i in 0..=count {
        let shape = if i == 0 { shapes::Kind::clone(&floor) } else { die.shape() };
        let name = i.to_string();
        let mut material = Material::new(&name, die.material());
        let opaque = !matches!(
            material.recipe,
            materials::Kind::Transparent(_) | materials::Kind::Dielectric(_)
        );
        material.two_sided = opaque && die.is();
        material.casts_shadows = die.below(8) > 0;
        scene.materials.push(material);
        let mut object = Object::new(&name, &name, shape);
        object.casts_shadows = die.below(8) > 0;
        scene.objects.push(object);
    }
    for i in 0..1 + die.below(5) {
        let name = format!("light {i}");
        let source = match die.below(3) {
            0 => {
                let emissive = Emissive::new(die.within(0.0, 9.0), die.paint());
                let mut material = Material::new(&name, emissive);
                material.two_sided = die.is();
                scene.materials.push(material);
                scene.objects.push(Object::new(&name, &name, die.lamp()));
                Area { object: name.clone(), sampling: None }.into()
            }
            _ => die.light(),
        };
        let mut light = Light::new(&name, source);
        light.shadows = die.below(8) > 0;
        light.enabled = die.below(8) > 0;
        scene.lights.push(light);
    }
    // there is one sky
    let mut skies = 0;
    scene.lights.retain(|light| {
        let is_sky = matches!(light.source, lights::Kind::Environment(_));
        skies += u32::from(is_sky);
        !is_sky || skies == 1
    });
    scene
}
