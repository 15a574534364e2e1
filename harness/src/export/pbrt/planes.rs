//! Planes, which have no end, as disks: all of a plane that the camera sees is on one.
//!
//! If direct light of lamps is all that counts, and the camera and all lights are on the same side of the plane, nothing else
//! of it matters: what the camera sees is on this side or on the plane itself, and every shadow segment from there to a light
//! stays on this side. The rays of a pixel that all meet the plane meet it within the quadrilateral of those of its corners.
//!
//! Under a sky, with glass, and where light is reflected more than once, all directions count, and the disk reaches so far that what is
//! missing is less than a rounding of single precision, in which pbrt computes.

use groundtruth::cameras::{Kind, Side, View};
use groundtruth::lights;
use groundtruth::materials::Kind::Dielectric;
use groundtruth::math::{Aabb, Normal, Point, Ray};
use groundtruth::render::film_point;
use groundtruth::scene::{Material, Tracer};

use super::Writer;
use crate::export::without::is_sky;

/// The disk reaches farther than what is seen by this factor.
const MARGIN: f64 = 2.0;

/// The edge of a disk that is this many times as far as everything else is below the horizon by less than 2⁻²³, a step of
/// single precision.
const FAR: f64 = 8_388_608.0;

impl Writer<'_> {
    /// The centre and radius of a disk in this plane that can stand for it. The camera and all lights have to be on one side.
    ///
    /// # Errors
    /// Why no disk can.
    pub(super) fn seen_part(&self, point: Point, normal: Normal) -> Result<(Point, f64), String> {
        let view = self.scene.camera.build(self.scene.image.plane()).map_err(|e| e.to_string())?;
        if let Kind::ThinLens(_) = self.scene.camera.lens {
            return Err(
                "has no end; only a camera without a lens tells how much of it is seen".to_owned()
            );
        }
        let eye = view.eye(Side::Left).position();
        let height = |p: Point| normal.dot(p - point);
        let side = height(eye).signum();
        self.lights_above(&|p| side * height(p), side, normal)?;
        let center = eye - height(eye) * normal;
        let mut radius = match is_sky(self.scene) || self.refracts() {
            true => self.far(center)?,
            false => 1.0,
        };
        for hit in self.hits(&view, point, normal, side)? {
            radius = radius.max(MARGIN * (hit - center).length());
        }
        Ok((center, radius))
    }

    /// Whether rays of glass lead beyond what the camera sees.
    fn refracts(&self) -> bool {
        let is_glass = |material: &Material| matches!(material.recipe, Dielectric(_));
        self.scene.tracer != Tracer::RayCast && self.scene.materials.iter().any(is_glass)
    }

    /// A radius so large that the edge of the disk is at the horizon as seen from any object, but for an angle below the
    /// rounding of single precision. It is needed where directions count that lead beyond what the camera sees: under a sky,
    /// with glass, and where light is reflected more than once.
    fn far(&self, center: Point) -> Result<f64, String> {
        let mut size = 1.0_f64;
        for object in self.world.objects() {
            let bounds = object.bounds();
            if bounds.is_bounded() {
                let distances = corners(&bounds).map(|corner| (corner - center).length());
                size = distances.into_iter().fold(size, f64::max);
            } else if self.world.objects().iter().filter(|it| !it.bounds().is_bounded()).count() > 1
            {
                return Err("has no end, nor has another object".to_owned());
            }
        }
        Ok(FAR * size)
    }

    /// Fails if a light is not on the side of a plane for which heights are positive.
    fn lights_above(
        &self,
        height: &dyn Fn(Point) -> f64,
        side: f64,
        normal: Normal,
    ) -> Result<(), String> {
        for light in self.scene.lights.iter().filter(|light| light.enabled) {
            let above = match &light.source {
                lights::Kind::PointLight(it) => height(it.location) > 0.0,
                lights::Kind::Directional(it) => side * normal.dot(it.direction) > 0.0,
                lights::Kind::Area(it) => self.object_bounds(&it.object).is_some_and(|bounds| {
                    corners(&bounds).into_iter().all(|corner| height(corner) >= 0.0)
                }),
                // the sky, which a disk hides so far; all others are refused where lights are written
                _ => true,
            };
            if !above {
                let name = groundtruth::printable::name(&light.name);
                return Err(format!(
                    "has no end, and the light \"{name}\" is not on the side of the camera"
                ));
            }
        }
        Ok(())
    }

    /// Where the rays of pixels meet a plane: those through their centres if all are, else those through their corners.
    fn hits(
        &self,
        view: &View,
        point: Point,
        normal: Normal,
        side: f64,
    ) -> Result<Vec<Point>, String> {
        let image = &self.scene.image;
        let offsets: &[[f64; 2]] = match self.is_centred() {
            true => &[[0.5, 0.5]],
            false => &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]],
        };
        let mut hits = Vec::new();
        for pixel in (0..image.height).flat_map(|y| (0..image.width).map(move |x| [x, y])) {
            let rays = offsets.iter().filter_map(|offset| {
                view.eye(Side::Left).ray(film_point(image, pixel, *offset), [0.0; 2])
            });
            let of_pixel: Vec<Option<Point>> =
                rays.map(|ray| met(&ray, point, normal, side)).collect();
            let met: Vec<Point> = of_pixel.iter().flatten().copied().collect();
            if !met.is_empty() && met.len() < of_pixel.len() {
                let [x, y] = pixel;
                return Err(format!(
                    "has no end, and its horizon is in the pixel ({x}, {y}); with --samples 1, only the rays through the \
                     centres of pixels count"
                ));
            }
            hits.extend(met);
        }
        Ok(hits)
    }

    /// The box around an object.
    fn object_bounds(&self, name: &str) -> Option<Aabb> {
        let object = self.world.objects().iter().find(|object| &*object.name == name)?;
        Some(object.bounds()).filter(Aabb::is_bounded)
    }
}

/// Where a ray from this side of a plane meets it.
fn met(ray: &Ray, point: Point, normal: Normal, side: f64) -> Option<Point> {
    let height = side * normal.dot(ray.origin - point);
    let fall = -side * normal.dot(ray.direction);
    (height > 0.0 && fall > 0.0).then(|| ray.at(height / fall))
}

fn corners(bounds: &Aabb) -> [Point; 8] {
    let ends = [bounds.min.to_array(), bounds.max.to_array()];
    std::array::from_fn(|i| Point::new(ends[i & 1][0], ends[i >> 1 & 1][1], ends[i >> 2 & 1][2]))
}
