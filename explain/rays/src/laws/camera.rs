use super::LawReport;
use crate::log::{Purpose, Ray};
use crate::traced::{Traced, median};
use groundtruth::math::{Point, Vector};
use text::digits::short;

/// How far from its place on the film a ray may be, in pixels: it and the four that show the film are drawn anywhere in
/// their pixels.
const WITHIN: f64 = 3.0;
/// The part of the rays that has to fit for the film to be flat.
const FIT: f64 = 0.9;

/// The part of a usual ray's length that a lens may be wide: what it moves rays by is less than `WITHIN`, or they pass no film.
const LENS: f64 = 3e-2;

/// A film: the direction of the pixel's corner is `corner + x · right + y · down`.
struct Film {
    corner: Vector,
    right: Vector,
    down: Vector,
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let is_camera = |ray: &(usize, &Ray)| ray.1.is(&Purpose::Camera) && ray.1.pixel.is_some();
    let is_finite = |ray: &(usize, &Ray)| ray.1.direction.is_finite() && ray.1.origin.is_finite();
    let rays: Vec<(usize, &Ray)> = traced.rays().filter(is_camera).filter(is_finite).collect();
    let Some(film) = film(&rays.iter().map(|it| it.1).collect::<Vec<_>>(), traced.scale) else {
        asked.notes.extend((extent(&rays) >= 2.0).then(|| "the camera rays pass no flat film from one eye (a lens, a panorama, an orthographic camera): they are not judged".to_owned()));
        return;
    };
    let [across, along] = [film.right.length(), film.down.length()];
    let is_square = (across / along - 1.0).abs() <= 0.02 + 4.0 / extent(&rays).max(1.0);
    for (index, ray) in rays {
        let off = film.off(ray);
        asked.count(index, off.is_some_and(|off| off <= WITHIN) && is_square, || {
            let words = match off {
                Some(off) if off > WITHIN => {
                    format!("is {} pixels from its place on the film", short(off))
                }
                Some(_) => format!(
                    "passes a film whose pixels are {} times as wide as high",
                    short(across / along)
                ),
                None => "does not pass the film".to_owned(),
            };
            (words, [("pixels-not-square", off.is_some_and(|off| off <= WITHIN) && !is_square)])
        });
    }
}

/// The number of columns or rows between the outermost pixels.
fn extent(rays: &[(usize, &Ray)]) -> f64 {
    let of = |axis: usize| {
        let places = || rays.iter().filter_map(|it| Some(it.1.pixel?[axis]));
        f64::from(places().max().unwrap_or(0) - places().min().unwrap_or(0))
    };
    of(0).min(of(1))
}

/// The film that most of the rays pass, from four of them that are far apart; `None` if there is none.
fn film(rays: &[&Ray], scale: f64) -> Option<Film> {
    let eye = |axis: usize| median(rays.iter().map(|ray| ray.origin.along(axis)).collect());
    let eye = Point::new(eye(0)?, eye(1)?, eye(2)?);
    let spread = median(rays.iter().map(|ray| (ray.origin - eye).length()).collect())?;
    if spread > LENS * scale || rays.len() < 4 {
        return None;
    }
    let far = |score: fn([f64; 2]) -> f64| {
        let place = |ray: &&&Ray| ray.pixel.map_or(0.0, |pixel| score(pixel.map(f64::from)));
        rays.iter().max_by(|a, b| place(a).total_cmp(&place(b))).copied()
    };
    let corners =
        [far(|[x, y]| -x - y)?, far(|[x, y]| x - y)?, far(|[x, y]| y - x)?, far(|[x, y]| x + y)?];
    // a lens moves the rays of a pixel about their mean
    let film = Film::through(corners, |corner| {
        let of_pixel = rays.iter().filter(|ray| ray.pixel == corner.pixel);
        of_pixel.filter_map(|ray| ray.direction.unit()).reduce(|sum, it| sum + it)?.unit()
    })?;
    let fits = rays.iter().filter(|ray| film.off(ray).is_some_and(|off| off <= WITHIN)).count();
    (fits as f64 >= FIT * rays.len() as f64).then_some(film)
}

impl Film {
    /// The projective film that four rays pass in the middle of their pixels.
    fn through(corners: [&Ray; 4], direction: impl Fn(&Ray) -> Option<Vector>) -> Option<Self> {
        let [a, b, c, d] = corners.map(direction);
        let (a, b, c, d) = (a?, b?, c?, d?);
        // λ_a a + λ_d d = λ_b b + λ_c c for a rectangle, by Cramer's rule
        let volume = b.cross(c).dot(d);
        if volume.abs() < 1e-12 {
            return None;
        }
        let [scale_b, scale_c] = [a.cross(c).dot(d) / volume, b.cross(a).dot(d) / volume];
        let [pa, pb, pc] = [corners[0].pixel?, corners[1].pixel?, corners[2].pixel?]
            .map(|pixel| pixel.map(|it| f64::from(it) + 0.5));
        let [columns, rows] = [pb[0] - pa[0], pc[1] - pa[1]];
        if columns < 1.0 || rows < 1.0 || scale_b <= 0.0 || scale_c <= 0.0 {
            return None;
        }
        let (right, down) = ((1.0 / columns) * (scale_b * b - a), (1.0 / rows) * (scale_c * c - a));
        Some(Self { corner: a - pa[0] * right - pa[1] * down, right, down })
    }

    /// How far the ray is from the middle of its pixel, in pixels; `None` if it does not meet the film.
    fn off(&self, ray: &Ray) -> Option<f64> {
        let normal = self.right.cross(self.down);
        let along = self.corner.dot(normal) / ray.direction.dot(normal);
        let at = along * ray.direction - self.corner;
        let [x, y] = [self.right, self.down].map(|side| at.dot(side) / side.length_squared());
        let pixel = ray.pixel?.map(|it| f64::from(it) + 0.5);
        (along > 0.0).then(|| (x - pixel[0]).abs().max((y - pixel[1]).abs()))
    }
}
