//! Planes, which have no end here and none there.

use groundtruth::cameras;
use groundtruth::math::{Frame, Normal, Vector};
use groundtruth::shapes::Plane;

use super::Writer;
use super::shapes::{Flat, Placed};

/// A plane is flat up to the cube of this times the distance of the eye from it. With a checker a square ends at this times
/// the size of the next smaller one, because texture coordinates are in single precision.
const FARTHER: f64 = 16.0;

/// A plane ends at this times its flat part: farther out Mitsuba's shadow rays, in single precision, miss by too much.
const SLOPES_END: f64 = 2.0;

impl Writer<'_> {
    /// A plane: a square about the point below the eye, with a checker three times a larger one around it, and around all
    /// four slopes that rise to the height of the eye. Without these its end would be below the horizon, by some hundredths
    /// of a pixel, and the background be seen there. Their normals are off by less than 1/4096.
    pub(super) fn plane(&mut self, plane: &Plane, at: &Placed<'_>) -> Vec<String> {
        let Some(normal) = Normal::new(plane.normal) else { return Vec::new() };
        let map = &at.leaf.map;
        let Some(normal) = Normal::new(map.covector(normal)) else { return Vec::new() };
        let (frame, eye) = (Frame::around(normal), self.scene.camera.eye);
        let height = (eye - map.point(plane.point)).dot(normal);
        let middle = eye - height * Vector::from(normal);
        let near = height.abs().max(self.extent() / FARTHER);
        let part = |[u0, u1]: [f64; 2], [v0, v1]: [f64; 2]| Flat {
            corner: middle + u0 * frame.u + v0 * frame.v,
            a: (u1 - u0) * frame.u,
            b: (v1 - v0) * frame.v,
        };
        let square = |half: f64| part([-half, half], [-half, half]);
        let end = near * FARTHER * FARTHER * FARTHER;
        let parts = match at.is_textured() {
            false => vec![square(end)],
            true => {
                let mut parts = vec![square(near)];
                let mut inner = near;
                for _ in 0..3 {
                    let outer = FARTHER * inner;
                    let (all, across) = ([-outer, outer], [-inner, inner]);
                    for side in [[-outer, -inner], [inner, outer]] {
                        parts.extend([part(side, all), part(across, side)]);
                    }
                    inner = outer;
                }
                parts
            }
        };
        let mut all: Vec<String> = parts.iter().flat_map(|part| self.flat(part, at)).collect();
        let far = SLOPES_END * end;
        for rising in [frame.u, frame.v, -frame.u, -frame.v] {
            let across = rising.cross(normal);
            let below = Flat {
                corner: middle + end * rising - far * across,
                a: 2.0 * far * across,
                b: (far - end) * rising,
            };
            let slope = Flat { b: below.b + height * Vector::from(normal), ..below };
            all.extend(self.rectangle(&slope, &below, at));
        }
        all
    }

    /// About how far the camera sees.
    fn extent(&self) -> f64 {
        let (camera, film) = (&self.scene.camera, self.scene.image.plane());
        let distance = (camera.eye - camera.look_at).length();
        match &camera.lens {
            cameras::Kind::Orthographic(it) => distance.max(FARTHER * film.width / it.zoom),
            _ => distance,
        }
    }
}
