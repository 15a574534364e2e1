//! Bumps: the shading normals that they give.

use groundtruth::bumps::{self, Height, Kind as Bump};
use groundtruth::images::{Drawn, Picture};
use groundtruth::lobes::{Lobes, Normals};
use groundtruth::shapes::Part;
use groundtruth::textures::{Fbm, Filtering, Image};
use groundtruth::trace::{Outcome, Recorder, ShadingPoint, Term};
use testkit::properties::*;

use super::oracle::{self, built as noise};
use crate::prelude::*;
use crate::support::stage::ray;

pub fn white() -> Matte {
    Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() }
}

/// A matte object of this shape with this bump.
pub fn bumped(shape: impl Into<shapes::Kind>, bump: impl Into<Bump>) -> Scene {
    let mut scene = stage(Rgb::WHITE);
    put(&mut scene, shape, white());
    scene.materials[0].bump = Some(bump.into());
    scene
}

/// Records the first surface and the normals with which it is shaded.
#[derive(Default)]
struct Recorded {
    normals: Option<Normals>,
    at: Option<Surface>,
}

impl Recorder for Recorded {
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {}
    fn hit(&mut self, point: &ShadingPoint<'_>, _: &Lobes) {
        self.normals.get_or_insert(point.normals);
        self.at.get_or_insert_with(|| point.hit.surface.clone());
    }
    fn term(&mut self, _: Term) {}
    fn leave(&mut self, _: Outcome, _: Rgb, _: Rgb) {}
}

/// The surface that a ray hits, and the normals with which it is shaded.
pub fn met(world: &World, origin: Point, direction: Vector) -> Option<(Surface, Normals)> {
    let mut recorded = Recorded::default();
    radiance(world, &ray(origin, direction), world.draws([0, 0], 0), &mut recorded);
    Some((recorded.at?, recorded.normals?))
}

pub fn ball(radius: f64) -> Sphere {
    Sphere { center: Point::ORIGIN, radius, inward: false }
}

/// The distance between two unit vectors.
pub fn apart(a: impl Into<Vector>, b: impl Into<Vector>) -> f64 {
    (a.into() - b.into()).length()
}

/// fBm by the second implementation, at a point, with cells of this size.
fn fbm(data: &Noise, size: f64, p: Point) -> f64 {
    oracle::fbm(data, noise(*data).lattice(), Point::from(p.to_array().map(|c| c / size)))
}

/// Turns, unequal scales and a shear.
fn steps() -> impl Strategy<Value = Vec<Step>> {
    let factor = || 0.5..2.0_f64;
    let degrees = || -180.0..180.0_f64;
    ((factor(), factor(), factor()), degrees(), degrees(), -0.5..0.5_f64, point(3.0)).prop_map(
        |((x, y, z), about_x, about_z, shear, to)| {
            vec![
                Step::Scale(Vector::new(x, y, z)),
                Step::RotateX(about_x),
                Step::Shear([shear, 0.0, 0.0, 0.0, shear, 0.0]),
                Step::RotateZ(about_z),
                Step::Translate(to.to_vector()),
            ]
        },
    )
}

/// Slopes are measured over about 1/4000 of a cell: with third derivatives of a few hundred their error is
/// 1e-5.
const SLOPE: f64 = 1e-4;

proptest! {
    #![proptest_config(ProptestConfig { cases: laws().cases / 4, ..laws() })]

    /// Law: a bump of noise is `n + a · fBm(p/size)`, normalised, at the local point, and one of height
    /// `n − ∇ₛh`, wherever that is above the surface. Oracle: the second implementation on a sphere, whose
    /// normal is its point; the gradient in space by finite differences, and its component along the surface.
    #[test]
    fn bumps_turn_normals_by_their_formulas(n in unit(), size in 0.3..2.0_f64, a in 0.0..1.0_f64) {
        let data = Noise::of_octaves(2);
        let p = Point::ORIGIN + 2.0 * n;
        let bump = bumps::Noise { noise: data, size, perturbation: a };
        let world = built(&bumped(ball(2.0), bump));
        let (at, normals) = met(&world, p + 3.0 * n, -Vector::from(n)).expect("it is hit");
        let there = Point::from(at.local.to_array().map(|c| c / size));
        let v = n + a * oracle::vector_fbm(&data, noise(data).lattice(), there);
        let expected = v.unit().expect("not zero");
        if n.dot(expected) > 0.02 {
            let off = apart(normals.shading, expected);
            prop_assert!(off < 1e-9, "{:?}, expected {:?}", normals.shading, expected);
        }

        let bump = Height { step: size / 4096.0, ..Height::new(Fbm::new(data, size), a * size) };
        let world = built(&bumped(ball(2.0), bump));
        let (at, normals) = met(&world, p + 3.0 * n, -Vector::from(n)).expect("it is hit");
        let h = |by: Vector| a * size * fbm(&data, size, at.local + by);
        let e = 1e-4 * size;
        let slope = |axis: Vector| (h(e * axis) - h(-e * axis)) / (2.0 * e);
        let gradient = Vector::new(slope(Vector::X), slope(Vector::Y), slope(Vector::Z));
        let along = gradient - n.dot(gradient) * n;
        let expected = (Vector::from(n) - along).unit().expect("not zero");
        if n.dot(expected) > 0.02 {
            let off = apart(normals.shading, expected);
            prop_assert!(off < SLOPE, "{:?}, expected {:?}", normals.shading, expected);
        }
    }

    /// Law: a bump by height has the normal of the surface that is really lifted by that height, in local
    /// coordinates, and then moved by the instances around it; for a texture that stays fixed, it is lifted
    /// in world coordinates. Oracle: the cross product of differences of the lifted plane's points.
    #[test]
    fn a_height_has_the_normal_of_the_lifted_surface(
        spot in (-2.0..2.0_f64, -2.0..2.0_f64),
        steps in (steps(), steps()),
        size in 0.5..2.0_f64,
        height in -0.5..0.5_f64,
        moves in any::<bool>(),
    ) {
        let data = Noise::of_octaves(2);
        let h = |p: Point| height * fbm(&data, size, p);
        let plane = Plane { point: Point::ORIGIN, normal: Vector::Y };
        let outer = Instance {
            transform_texture: moves,
            ..Instance::new(Instance::new(plane, steps.0.clone()), steps.1.clone())
        };
        let all = [steps.0, steps.1].concat();
        let whole = Transform::from_steps(&all).expect("they can be undone");
        let spot = Point::new(spot.0, 0.0, spot.1);
        let n = Normal::new(whole.covector(Normal::Y)).expect("it has a normal");
        let lifted = |x: f64, z: f64| {
            let local = spot + Vector::new(x, 0.0, z);
            if moves {
                return whole.point(local + h(local) * Vector::Y);
            }
            let world = whole.point(local);
            world + h(world) * n
        };
        let e = 1e-4;
        let along_x = lifted(e, 0.0) - lifted(-e, 0.0);
        let along_z = lifted(0.0, e) - lifted(0.0, -e);
        let across = along_z.cross(along_x).unit().expect("not zero");
        let expected = if n.dot(across) < 0.0 { -across } else { across };

        let bump = Height { step: size / 4096.0, ..Height::new(Fbm::new(data, size), height) };
        let world = built(&bumped(outer, bump));
        let (_, normals) =
            met(&world, whole.point(spot) + 2.0 * n, -Vector::from(n)).expect("it is hit");
        prop_assume!(n.dot(expected) > 0.02);
        let off = apart(normals.shading, expected);
        prop_assert!(off < SLOPE, "{:?}, expected {:?}: {} apart", normals.shading, expected, off);
    }

    /// Law: whatever the bump, the normal is unit, and on the viewer's side of the true surface: of a
    /// sphere, a smooth mesh, a stretched one, and of a two-sided surface seen from behind.
    #[test]
    fn bumped_normals_are_unit_and_on_the_right_side(
        n in unit(),
        to in point(0.9),
        a in prop_oneof![0.0..2.0_f64, Just(1e6), Just(-1e6), Just(1e300)],
        steps in steps(),
        which in 0..3_usize,
        is_height in any::<bool>(),
    ) {
        let ball: shapes::Kind = match which {
            0 => ball(1.0).into(),
            _ => TessellatedSphere::new(12, 6, true).into(),
        };
        let placed = if which == 2 { Instance::new(ball, steps.clone()).into() } else { ball };
        let steps = if which == 2 { steps } else { vec![] };
        let whole = Transform::from_steps(&steps).expect("they can be undone");
        let data = Noise::of_octaves(3);
        let bump = match is_height {
            true => Bump::from(Height::new(Fbm::new(data, 0.2), a)),
            false => bumps::Noise { noise: data, size: 0.2, perturbation: a }.into(),
        };
        let mut scene = bumped(placed, bump);
        scene.materials[0].two_sided = true;
        let world = built(&scene);
        let inside = whole.point(to.scaled(0.5));
        for (origin, direction) in
            [(inside, Vector::from(n)), (inside + 100.0 * n, -Vector::from(n))]
        {
            let Some((_, Normals { shading, geometry })) = met(&world, origin, direction) else {
                continue;
            };
            let cosine = shading.dot(geometry);
            prop_assert!(geometry.dot(direction) <= 0.0, "the true normal is turned away");
            prop_assert!(cosine > 0.0, "the cosine to the true normal is {}", cosine);
            let length = Vector::from(shading).length();
            prop_assert!((length - 1.0).abs() < 1e-15, "its length is {}", length);
        }
    }

    /// Law: an image by the texture coordinates of a mesh can be a height: where it rises linearly with u,
    /// `n' = n − k ∇u`, in local coordinates, also through instance, compound and lattice, and where the
    /// texture stays fixed. Oracle: u as a linear function, whose gradient is known.
    #[test]
    fn an_image_on_a_mesh_is_a_height(
        cell in (1..23_u32, 1..11_u32),
        steps in steps(),
        height in -0.3..0.3_f64,
        nesting in 0..5_usize,
    ) {
        let (u_of, v_of) = ([0.8, 0.05, -0.1], [0.05, -0.2, 0.85]);
        let uv = |p: Point| [u_of, v_of].map(|f| f[0] * p.x() + f[1] + f[2] * p.z());
        let corners = [[-2.0, -2.0], [-2.0, 2.0], [2.0, 2.0], [2.0, -2.0]]
            .map(|[x, z]| Point::new(x, 0.0, z));
        let mut mesh = Mesh::of_lists(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
        mesh.uvs = Some(corners.map(uv).to_vec());
        // the centre of a cell of the image's grid, by Cramer's rule
        let u = (f64::from(cell.0) + 0.5) / 24.0 - u_of[1];
        let v = (f64::from(cell.1) + 0.5) / 12.0 - v_of[1];
        let determinant = u_of[0] * v_of[2] - u_of[2] * v_of[0];
        let x = (u * v_of[2] - v * u_of[2]) / determinant;
        let z = (u_of[0] * v - v_of[0] * u) / determinant;

        let placed = Instance::new(mesh.clone(), steps.clone());
        let (shape, steps): (shapes::Kind, _) = match nesting {
            0 => (mesh.into(), vec![]),
            1 => (placed.into(), steps),
            2 => (Instance { transform_texture: false, ..placed }.into(), steps),
            3 => {
                let far = Step::Translate(Vector::new(0.0, 90.0, 0.0));
                let elsewhere = Instance::new(mesh, vec![far]);
                let parts = vec![Part::new(elsewhere), Part::new(placed)];
                (Compound { accel: None, parts }.into(), steps)
            }
            _ => {
                let spacing = Vector::new(50.0, 60.0, 70.0);
                let of = Box::new(placed.into());
                let lattice = Lattice { of, counts: [2, 2, 2], spacing, accel: None };
                (lattice.into(), [steps, vec![Step::Translate(spacing)]].concat())
            }
        };
        let whole = Transform::from_steps(&steps).expect("they can be undone");
        let n = Normal::new(whole.covector(Normal::Y)).expect("it has a normal");
        let spot = whole.point(Point::new(x, 0.0, z));
        let image = Image {
            filtering: Filtering::Bilinear,
            ..Image::of_drawn(Drawn { picture: Picture::UvGrid, width: 480, height: 240 }, None)
        };
        // red is 0.2 + 0.8 u between the lines
        let rise = 0.8 * height * Vector::new(u_of[0], 0.0, u_of[2]);
        let expected = if nesting == 2 {
            // the gradient of u in the world transforms as a covector; its component along the surface counts
            let gradient =
                Normal::new(rise).map_or(Vector::ZERO, |d| rise.length() * whole.covector(d));
            Vector::from(n) - (gradient - n.dot(gradient) * n)
        } else {
            let local = Normal::new(Vector::Y - rise).expect("not zero");
            whole.covector(local)
        };
        let expected = expected.unit().expect("not zero");
        let world = built(&bumped(shape, Height::new(image, height)));
        let (_, normals) = met(&world, spot + 2.0 * n, -Vector::from(n)).expect("it is hit");
        let off = apart(normals.shading, expected);
        // texels are in single precision: two neighbours differ by 0.8/480, known to 6e-8
        prop_assert!(off < 1e-3, "{:?}, expected {:?}", normals.shading, expected);
    }
}
