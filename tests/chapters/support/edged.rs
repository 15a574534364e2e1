//! Closed bodies with sharp or rounded edges, and points on these edges.

use groundtruth::shapes::{
    Annulus, BeveledBox, BeveledCylinder, BeveledRing, ConcaveLens, FlatRimmedBowl, Materials,
    OpenCylinder, Paraboloid, PartAnnulus, PartCylinder, PartSphere, RoundRimmedBowl, SolidCone,
    SolidCylinder, ThickRing,
};

use crate::prelude::*;

/// A closed body.
pub struct Edged {
    pub kind: Kind,
    /// A point well inside.
    pub inside: Point,
    /// Points on its edges, as near as rounding allows.
    pub edges: Vec<Point>,
}

/// The number of bodies that [`edged`] knows.
pub const BODIES: usize = 18;

/// How many edge points a body has.
const POINTS: usize = 12;

/// A point of the circle of this radius about the y axis at this height.
fn on_circle(draw: &mut Draw, radius: f64, y: f64) -> Point {
    // the quarters are points that symmetrical views meet
    let phi = if draw.coin() { 90.0 * draw.below(4) as f64 } else { draw.between(0.0, 360.0) };
    Point::new(radius * sin_degrees(phi), y, radius * cos_degrees(phi))
}

fn circles(draw: &mut Draw, circles: &[[f64; 2]]) -> Vec<Point> {
    let mut point = |i: usize| {
        let [radius, y] = circles[i % circles.len()];
        on_circle(draw, radius, y)
    };
    (0..POINTS).map(&mut point).collect()
}

/// Points of the twelve edges of a box, corners among them.
fn box_edges(draw: &mut Draw, [min, max]: [Point; 2]) -> Vec<Point> {
    let mut point = |_| {
        let mut p = [0, 1, 2].map(|axis| draw.pick(&[min, max]).along(axis));
        if draw.below(4) > 0 {
            let axis = draw.below(3);
            let share = draw.pick(&[0.5, 0.25, 0.375]);
            let share = if draw.coin() { share } else { draw.between(0.0, 1.0) };
            p[axis] = min.along(axis) + share * (max.along(axis) - min.along(axis));
        }
        Point::from(p)
    };
    (0..POINTS).map(&mut point).collect()
}

fn corners([min, max]: [Point; 2]) -> [Point; 8] {
    let ends = [min, max];
    std::array::from_fn(|i| Point::new(ends[i & 1].x(), ends[i >> 1 & 1].y(), ends[i >> 2].z()))
}

/// The triangles of a box, wound outward, as indices of [`corners`].
const BOX_TRIANGLES: [[u32; 3]; 12] = [
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
];

fn six_rectangles([min, max]: [Point; 2]) -> Kind {
    let d = max - min;
    let (x, y, z) = (d.x() * Vector::X, d.y() * Vector::Y, d.z() * Vector::Z);
    let side = |corner, a, b| Rectangle { corner, a, b };
    // from corners with the coordinates of the box themselves
    let [low_x, low_y, low_z] = [0, 1, 2].map(|axis| min.with(axis, max.along(axis)));
    Compound::of([
        side(min, z, y),
        side(low_x, y, z),
        side(min, x, z),
        side(low_y, z, x),
        side(min, y, x),
        side(low_z, x, y),
    ])
    .into()
}

fn mesh(vertices: Vec<Point>, triangles: Vec<[u32; 3]>, smooth: bool) -> Kind {
    Mesh { smooth, ..Mesh::of_lists(vertices, triangles) }.into()
}

/// A body of this number, of random measures.
pub fn edged(draw: &mut Draw, number: usize) -> Edged {
    let dyadic = draw.coin();
    let mut number_in = |low: f64, high: f64| {
        let x = draw.between(low, high);
        if dyadic { (x * 8.0).ceil() / 8.0 } else { x }
    };
    let (y0, height, r) = (number_in(-1.0, 0.5), number_in(0.5, 2.0), number_in(0.5, 1.5));
    let thin = number_in(0.25, 0.4) * r;
    let min = Point::new(number_in(-2.0, -0.5), number_in(-1.0, -0.5), number_in(-2.0, -0.5));
    let max = Point::new(number_in(0.5, 2.0), number_in(0.5, 1.0), number_in(0.5, 2.0));
    let y1 = y0 + height;
    let materials = Materials::new();
    let on_axis = |y: f64| Point::new(0.0, y, 0.0);
    let middle = on_axis(0.5 * (y0 + y1));
    let bevel = 0.125;
    let lid = |y, normal| Disk { center: on_axis(y), normal, radius: r };
    let wall = OpenCylinder { y0, y1, radius: r, inward: false };
    match number {
        0 => Edged {
            kind: Cuboid { min, max }.into(),
            inside: Point::ORIGIN,
            edges: box_edges(draw, [min, max]),
        },
        1 => Edged {
            kind: SolidCylinder { y0, y1, radius: r, materials }.into(),
            inside: middle,
            edges: circles(draw, &[[r, y0], [r, y1]]),
        },
        2 => Edged {
            kind: SolidCone { height, radius: r, materials }.into(),
            inside: on_axis(0.25 * height),
            edges: circles(draw, &[[r, 0.0], [r, 0.0], [0.0, height]]),
        },
        3 => Edged {
            kind: ThickRing { y0, y1, inner_radius: thin, outer_radius: r, materials }.into(),
            inside: middle + 0.5 * (thin + r) * Vector::X,
            edges: circles(draw, &[[r, y0], [r, y1], [thin, y0], [thin, y1]]),
        },
        4 => {
            let inner = r - thin;
            Edged {
                kind: FlatRimmedBowl {
                    inner_radius: inner,
                    outer_radius: r,
                    opening: 180.0,
                    materials,
                }
                .into(),
                inside: on_axis(-0.5 * (inner + r)),
                edges: circles(draw, &[[inner, 0.0], [r, 0.0]]),
            }
        }
        5 => {
            let inner = r - thin;
            Edged {
                kind: RoundRimmedBowl {
                    inner_radius: inner,
                    outer_radius: r,
                    opening: 180.0,
                    materials,
                }
                .into(),
                inside: on_axis(-0.5 * (inner + r)),
                edges: circles(draw, &[[inner, 0.0], [r, 0.0]]),
            }
        }
        6 => {
            let thickness = 0.75 * r;
            let half = 0.5 * thickness;
            Edged {
                kind: ConcaveLens { radius: r, thickness, min_distance: 0.25 * r, materials }
                    .into(),
                inside: Point::ORIGIN,
                edges: circles(draw, &[[r, half], [r, -half]]),
            }
        }
        7 => {
            let by = bevel * Vector::new(1.0, 1.0, 1.0);
            // the corners of the flat faces
            let mut seams = Vec::new();
            for p in corners([min + by, max - by]) {
                for axis in 0..3 {
                    let out = if p.along(axis) < 0.0 { min } else { max };
                    seams.push(p.with(axis, out.along(axis)));
                }
            }
            Edged {
                kind: BeveledBox { min, max, bevel, materials }.into(),
                inside: Point::ORIGIN,
                edges: seams,
            }
        }
        8 => Edged {
            kind: BeveledCylinder { y0, y1, radius: r, bevel, materials }.into(),
            inside: middle,
            edges: circles(
                draw,
                &[[r, y0 + bevel], [r, y1 - bevel], [r - bevel, y0], [r - bevel, y1]],
            ),
        },
        9 => {
            let bevel = 0.0625;
            let inner = r - 0.25;
            Edged {
                kind: BeveledRing {
                    y0,
                    y1,
                    inner_radius: inner,
                    outer_radius: r,
                    bevel,
                    materials,
                }
                .into(),
                inside: middle + (r - 0.125) * Vector::Z,
                edges: circles(
                    draw,
                    &[[r, y0 + bevel], [inner, y1 - bevel], [r - bevel, y0], [inner + bevel, y1]],
                ),
            }
        }
        10 | 11 => Edged {
            kind: mesh(corners([min, max]).to_vec(), BOX_TRIANGLES.to_vec(), number == 11),
            inside: Point::ORIGIN,
            edges: box_edges(draw, [min, max]),
        },
        12 => {
            // so that the far sides are where the sums say
            let [min, max] =
                [min, max].map(|p| Point::from(p.to_array().map(|x| (x * 8.0).round() / 8.0)));
            Edged {
                kind: six_rectangles([min, max]),
                inside: Point::ORIGIN,
                edges: box_edges(draw, [min, max]),
            }
        }
        13 => Edged {
            kind: Compound::of([
                Kind::from(wall),
                lid(y0, -Vector::Y).into(),
                lid(y1, Vector::Y).into(),
            ])
            .into(),
            inside: middle,
            edges: circles(draw, &[[r, y0], [r, y1]]),
        },
        14 => {
            let dome = PartSphere {
                center: on_axis(y0),
                radius: r,
                phi: [0.0, 360.0],
                theta: [0.0, 90.0],
                inward: false,
            };
            Edged {
                kind: Compound::of([Kind::from(dome), lid(y0, -Vector::Y).into()]).into(),
                inside: on_axis(y0 + 0.5 * r),
                edges: circles(draw, &[[r, y0]]),
            }
        }
        15 => {
            let cup = Paraboloid { height, radius: r, inward: false };
            let lid = Annulus {
                center: on_axis(height),
                normal: Vector::Y,
                inner_radius: 0.0,
                outer_radius: r,
            };
            Edged {
                kind: Compound::of([Kind::from(cup), lid.into()]).into(),
                inside: on_axis(0.75 * height),
                edges: circles(draw, &[[r, height]]),
            }
        }
        16 => quarter_of_a_cylinder(draw, [y0, y1], r),
        _ => {
            let p = corners([min, max]);
            let triangle =
                |t: [u32; 3]| Triangle { vertices: t.map(|i| p[i as usize]), normals: None };
            Edged {
                kind: Compound::of(BOX_TRIANGLES.map(triangle)).into(),
                inside: Point::ORIGIN,
                edges: box_edges(draw, [min, max]),
            }
        }
    }
}

/// The points of a cylinder with x, z ≥ 0, a compound of parts that close exactly.
fn quarter_of_a_cylinder(draw: &mut Draw, [y0, y1]: [f64; 2], r: f64) -> Edged {
    let phi = [0.0, 90.0];
    let corner = Point::new(0.0, y0, 0.0);
    let up = (y1 - y0) * Vector::Y;
    let y1 = y0 + up.y();
    let level = |y, normal| PartAnnulus {
        center: Point::new(0.0, y, 0.0),
        normal,
        inner_radius: 0.0,
        outer_radius: r,
        phi,
    };
    let parts = [
        Kind::from(PartCylinder { y0, y1, radius: r, phi, inward: false }),
        level(y0, -Vector::Y).into(),
        level(y1, Vector::Y).into(),
        Rectangle { corner, a: r * Vector::Z, b: up }.into(),
        Rectangle { corner, a: up, b: r * Vector::X }.into(),
    ];
    let y = draw.between(y0, y1);
    let mut edges = vec![
        Point::new(r, y0, 0.0),
        Point::new(r, y, 0.0),
        Point::new(0.0, y, r),
        Point::new(0.0, y, 0.0),
        Point::new(0.0, y1, 0.0),
        Point::new(0.5 * r, y1, 0.0),
        Point::new(0.0, y0, 0.5 * r),
    ];
    for y in [y0, y1] {
        let phi = draw.between(0.0, 90.0);
        edges.push(Point::new(r * sin_degrees(phi), y, r * cos_degrees(phi)));
    }
    let inside = Point::new(0.4 * r, 0.5 * (y0 + y1), 0.4 * r);
    Edged { kind: Compound::of(parts).into(), inside, edges }
}

impl Edged {
    /// The body turned, stretched and moved, also twice.
    pub fn placed(self, draw: &mut Draw) -> Self {
        let mut body = self;
        for _ in 0..1 + draw.below(2) {
            let far = draw.decades(0.0, 3.0);
            let factors = [0, 1, 2].map(|_| draw.decades(-1.0, 1.0));
            let mut steps = vec![
                Step::RotateX(draw.between(0.0, 360.0)),
                Step::Translate(far * draw.direction()),
            ];
            if draw.coin() {
                steps.insert(0, Step::Scale(Vector::from(factors)));
            }
            if draw.coin() {
                steps.push(Step::RotateAbout {
                    point: Point::ORIGIN,
                    direction: draw.direction().into(),
                    degrees: 90.0 * draw.below(4) as f64,
                });
            }
            let transform = Transform::from_steps(&steps).expect("invertible");
            body = Self {
                kind: Instance::new(body.kind, steps).into(),
                inside: transform.point(body.inside),
                edges: body.edges.into_iter().map(|p| transform.point(p)).collect(),
            };
        }
        body
    }
}
