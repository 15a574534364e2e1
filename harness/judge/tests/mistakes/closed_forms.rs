//! Mistakes of shading and lights, on one plane and by hand.

use std::f64::consts::PI;

use groundtruth::bumps::Height;
use groundtruth::lights::{AmbientOccluder, PointLight};
use groundtruth::materials::{Emissive, GlossyReflector, Matte, Phong};
use groundtruth::math::{Step, Vector, cos_degrees, power};
use groundtruth::noise::Noise;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Tracer, Whitted};
use groundtruth::shapes::{Disk, Instance, Plane, Triangle};
use groundtruth::textures::{Checker3d, Fbm};

use super::stage::*;

/// `k_d`.
const KD: f64 = 0.5;

fn diffuse() -> Matte {
    matte(0.0, KD, Rgb::WHITE)
}

/// Law: each mistake has its own factor in `k_d/π · cosθ_i`. Oracle: that formula without, with another or with a second
/// cosine.
#[test]
fn cosines_of_direct_light() {
    let (viewer, sun) = (-40.0, 65.0);
    let scene = lit_plane(diffuse(), viewer, sun);
    let (cos_i, cos_o) = (cos_degrees(sun), cos_degrees(viewer));
    expect("no-cosine", &scene, KD / PI, ROUNDING);
    expect("cosine-twice", &scene, KD / PI * cos_i * cos_i, ROUNDING);
    expect("cosine-of-viewer", &scene, KD / PI * cos_o, ROUNDING);
    expect("lambertian-without-pi", &scene, KD * cos_i, ROUNDING);
    expect("lambertian-pi-twice", &scene, KD / PI / PI * cos_i, ROUNDING);
}

/// Law: highlights without their cosine, normalised, and by the half vector. Oracle: `(cos α)^e` of the angles between
/// directions in one plane. With the viewer on the light's side at 70°, `r·ω_o` is negative and `n·h` is not.
#[test]
fn highlights() {
    let (ks, exponent) = (0.25, 10.0);
    let shiny = |kd: f64| phong(0.0, kd, Rgb::WHITE, ks, exponent);
    let (viewer, sun) = (-20.0, 40.0);
    let cos_i = cos_degrees(sun);
    let mirrored = ks * power(cos_degrees(20.0), exponent);
    let scene = lit_plane(shiny(0.0), viewer, sun);
    expect("highlight-without-cosine", &scene, mirrored, ROUNDING);
    expect("highlight-normalised", &scene, mirrored * cos_i * 12.0 / (2.0 * PI), ROUNDING);
    expect("no-highlight", &scene, 0.0, 0.0);
    let half = |degrees: f64| ks * power(cos_degrees(degrees), exponent);
    expect("highlight-of-half-vector", &scene, half(10.0) * cos_i, ROUNDING);
    let narrow = ks * power(cos_degrees(10.0), 4.0 * exponent) * cos_i;
    let four_times = "with four times the exponent";
    expect_form("highlight-of-half-vector", four_times, &scene, narrow, ROUNDING);
    let short = cos_i * cos_degrees(viewer) - cos_degrees(sun - viewer);
    expect("highlight-without-two", &scene, ks * power(short, exponent) * cos_i, ROUNDING);
    let scene = lit_plane(shiny(KD), 70.0, 70.0);
    let expected = (KD / PI + half(70.0)) * cos_degrees(70.0);
    expect("highlight-of-half-vector", &scene, expected, ROUNDING);
}

/// Law: a lamp 10° below a triangle whose shading normal leans 40° to it counts with that normal's cosine; one above, and one that
/// casts no shadow, count as with us. Oracle: `k_d/π · cosθ_i` of the shading normal.
#[test]
fn light_at_the_shadow_terminator() {
    for (angle, shadows) in [(100.0, true), (100.0, false), (80.0, true)] {
        let mut scene = plane(diffuse(), 0.0);
        let vertices = [point(-9.0, 0.0, -9.0), point(0.0, 0.0, 9.0), point(9.0, 0.0, -9.0)];
        scene.objects[0].shape = Triangle { vertices, normals: Some([at_angle(40.0); 3]) }.into();
        scene.lights.push(Light { shadows, ..directional("sun", at_angle(angle), 1.0) });
        let is_hidden = angle > 90.0 && shadows;
        let lit = KD / PI * cos_degrees(angle - 40.0);
        let right = value(&ours(&scene));
        assert!(
            (right - if is_hidden { 0.0 } else { lit }).abs() <= ROUNDING,
            "{right} at {angle}"
        );
        expect("terminator-lit", &scene, lit, ROUNDING);
    }
}

/// Law: ambient light is left out, added for each of three lights, or divided by π. Oracle: `k_a`.
#[test]
fn ambient_light() {
    let ka = 0.375;
    let mut scene = plane(matte(ka, 0.0, Rgb::WHITE), 0.0);
    scene.lights.push(ambient(1.0));
    for name in ["a", "b", "c"] {
        scene.lights.push(directional(name, Vector::Y, 1.0));
    }
    expect("no-ambient", &scene, 0.0, 0.0);
    expect("ambient-for-each-light", &scene, 3.0 * ka, ROUNDING);
    expect("ambient-over-pi", &scene, ka / PI, ROUNDING);
}

/// Law: of a sun whose direction is three halves long, highlights have the power of this length, and nothing else has it,
/// with and without shadow rays. Oracle: `(k_d/π + k_s (3/2 cos α)^e) cosθ_i`.
#[test]
fn a_long_direction_in_highlights_alone() {
    let phong = phong(0.0, KD, Rgb::WHITE, 0.25, 4.0);
    let mut scene = plane(phong, -20.0);
    light(&mut scene, PointLight { location: point(0.0, 9.0, 0.0), ..point_source(0.0) });
    scene.lights.push(directional("sun", 1.5 * at_angle(40.0), 1.0));
    let highlight = 0.25 * power(1.5 * cos_degrees(20.0), 4.0);
    let expected = (KD / PI + highlight) * cos_degrees(40.0);
    expect("highlight-direction-not-unit", &scene, expected, ROUNDING);
    scene.lights.iter_mut().for_each(|light| light.shadows = false);
    expect("highlight-direction-not-unit", &scene, expected, ROUNDING);
}

fn point_source(ls: f64) -> PointLight {
    PointLight { ls, color: Rgb::WHITE, location: point(0.0, 3.0, 0.0), attenuation: 0.0 }
}

/// Law: at the top of a sphere of radius 3/2 direct light has that factor, and the mirror direction its square. Oracle:
/// `n' = r n` in the formulas of Lambert and Phong; a plane, and a sphere of radius 1, have the right ones.
#[test]
fn a_sphere_with_normals_as_long_as_its_radius() {
    let phong = phong(0.0, KD, Rgb::WHITE, 0.25, 4.0);
    let (viewer, sun) = (-20.0, 40.0);
    let of_radius = |radius: f64| {
        let mut scene = lit_plane(phong.clone(), viewer, sun);
        scene.objects[0].shape = sphere(point(0.0, -radius, 0.0), radius).into();
        scene
    };
    let radius = 1.5;
    let mirrored =
        2.0 * radius * radius * cos_degrees(sun) * cos_degrees(viewer) - cos_degrees(sun - viewer);
    let expected = (KD / PI + 0.25 * power(mirrored, 4.0)) * radius * cos_degrees(sun);
    // the pixel's centre is the top of the sphere, up to the error of a root
    expect("sphere-normal-not-unit", &of_radius(radius), expected, 1e-9);
    for scene in [of_radius(1.0), lit_plane(phong.clone(), viewer, sun)] {
        expect("sphere-normal-not-unit", &scene, value(&ours(&scene)), 1e-12);
    }
}

/// Law: a sphere without an offset has spots: each pixel is ours or black, and neither is rare. Oracle: one light
/// without ambient light, by definition of a shadow.
#[test]
fn a_sphere_that_shadows_itself() {
    let mut scene = small("ch16/shadows", 32, 1);
    scene.objects.clear();
    scene.background = Rgb::BLACK.into();
    add(&mut scene, "ball", sphere(point(3.0, 2.5, 0.0), 2.3), diffuse());
    scene.lights = vec![directional("sun", vector(0.0, 0.0, 1.0), 1.0)];
    let (right, wrong) = (ours(&scene), with("no-offset", &scene));
    let lit = right.pixels().iter().filter(|pixel| !pixel.is_black()).count();
    let black = right.pixels().iter().zip(wrong.pixels());
    let mut dark = 0;
    for (right, wrong) in black.filter(|(right, _)| !right.is_black()) {
        let is_ours = (right.r - wrong.r).abs() < 1e-9 * right.r;
        assert!(is_ours || wrong.is_black(), "{right:?}, {wrong:?}");
        dark += usize::from(!is_ours);
    }
    assert!(lit > 100 && (lit / 10..9 * lit / 10).contains(&dark), "{dark} of {lit}");
}

/// Law: a cover half a unit above the plane casts no shadow if hits nearer than 1 do not count; one at 1.5 does. With
/// 0.1 both do. Oracle: the distances.
#[test]
fn offsets_that_are_too_large() {
    for (height, is_lit) in [(0.5, true), (1.5, false)] {
        let mut scene = plane(diffuse(), 80.0);
        light(&mut scene, point_source(1.0));
        let cover = Disk { center: point(0.0, height, 0.0), normal: Vector::Y, radius: 0.2 };
        add(&mut scene, "cover", cover, diffuse());
        assert_eq!(value(&ours(&scene)), 0.0);
        let expected = if is_lit { KD / PI } else { 0.0 };
        expect("offset-too-large", &scene, expected, ROUNDING);
        expect_form("offset-too-large", "or than 0.1", &scene, 0.0, ROUNDING);
    }
}

/// Law: surfaces that shine are black to the camera, or in mirrors. Oracle: the lamp's radiance, and `k_r` of it.
#[test]
fn lamps_that_are_not_seen() {
    let lamp = || Emissive::new(4.0, Rgb::WHITE);
    expect("lamps-unseen", &plane(lamp(), 20.0), 0.0, 0.0);
    let mirror = mirror(Phong::default(), 0.75, Rgb::WHITE);
    let mut scene = plane(mirror, 60.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 1 });
    let ceiling = Plane { point: point(0.0, 100.0, 0.0), normal: -Vector::Y };
    add(&mut scene, "ceiling", ceiling, lamp());
    assert!((value(&ours(&scene)) - 3.0).abs() < ROUNDING);
    expect("lamps-unseen-in-mirrors", &scene, 0.0, 0.0);
    expect("mirror-without-kr", &scene, 4.0, ROUNDING);
    // along the plane, below the ceiling
    expect("mirror-without-two", &scene, 0.0, 0.0);
}

/// Law: light from below counts as light from above. Oracle: the light that is above.
#[test]
fn light_from_behind() {
    let scene = lit_plane(diffuse(), 10.0, 115.0);
    assert_eq!(value(&ours(&scene)), 0.0);
    expect("lit-from-behind", &scene, KD / PI * cos_degrees(65.0), ROUNDING);
}

/// Law: a ceiling above a point light blocks it if shadow rays have no end. Oracle: none; it is black.
#[test]
fn shadow_rays_that_go_on_behind_the_light() {
    let mut scene = plane(diffuse(), 80.0);
    scene.lights.push(point_light("lamp", point(0.0, 1.0, 0.0), 1.0));
    let ceiling = Disk { center: point(0.0, 1.5, 0.0), normal: Vector::Y, radius: 1.0 };
    add(&mut scene, "ceiling", ceiling, diffuse());
    assert!(value(&ours(&scene)) > 0.0);
    expect("shadow-rays-without-end", &scene, 0.0, 0.0);
}

/// Law: below a disk whose rim is at the angle θ, by the cosine the share `cos²θ` of directions is open, evenly
/// `cosθ`. Oracle: these integrals.
#[test]
fn ambient_occlusion_under_a_disk() {
    let mut scene = plane(matte(1.0, 0.0, Rgb::WHITE), 0.0);
    scene.camera.eye = point(0.0, 0.5, 0.0);
    scene.image.samples = 4096;
    light(&mut scene, AmbientOccluder::default());
    let radius = 3.0_f64.sqrt(); // θ = 60°
    let disk = Disk { center: point(0.0, 1.0, 0.0), normal: Vector::Y, radius };
    add(&mut scene, "disk", disk, diffuse());
    assert!((value(&ours(&scene)) - 0.25).abs() < 0.02);
    expect("occluder-uniform", &scene, 0.5, 0.04);
}

/// Law: a mirror below a white sky has its cosine. Oracle: `k_r cosθ`.
#[test]
fn mirrors_and_gloss() {
    let kr = 0.75;
    let mirror = mirror(Phong::default(), kr, Rgb::WHITE);
    let mut scene = plane(mirror, 60.0);
    scene.background = Rgb::WHITE.into();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 1 });
    expect("mirror-with-cosine", &scene, kr * 0.5, ROUNDING);
    expect("no-background-in-mirrors", &scene, 0.0, 0.0);

    // straight above, an exponent of 50: (e + 1)/2π cos^e of directions that are all above the surface
    let e = 50.0;
    let gloss = GlossyReflector {
        phong: Phong::default(),
        kr: kr.into(),
        cr: Rgb::WHITE.into(),
        exponent: e.into(),
        rule: Default::default(),
    };
    let mut scene = plane(gloss, 0.0);
    scene.background = Rgb::WHITE.into();
    scene.image.samples = 4096;
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 1 });
    // the means of cosθ and of the density over that density
    expect("gloss-with-cosine", &scene, kr * (e + 1.0) / (e + 2.0), 0.001);
    let mean = (e + 1.0) * (e + 1.0) / (2.0 * PI * (2.0 * e + 1.0));
    expect("gloss-without-density", &scene, kr * mean, 0.02);
}

/// Law: a sample above 1 is mapped before the mean is taken. Oracle: the book's rule for the only sample.
#[test]
fn max_to_one_of_samples() {
    let scene = plane(Emissive::new(4.0, rgb(1.0, 0.5, 0.25)), 20.0);
    assert_eq!(ours(&scene).get([0, 0]), rgb(4.0, 2.0, 1.0));
    assert_eq!(with("sample-max-to-one", &scene).get([0, 0]), rgb(1.0, 0.5, 0.25));
}

/// Law: the normal `M n'` instead of `(M⁻¹)ᵀ n'`. Oracle: the matrix diag(2, 1, 1) times the normal at 30°, by hand.
#[test]
fn normal_of_an_instance() {
    let mut scene = lit_plane(diffuse(), 0.0, 0.0);
    let flat = Plane { point: point(0.0, 0.0, 0.0), normal: Vector::Y };
    let steps = vec![Step::RotateZ(-30.0), Step::Scale(vector(2.0, 1.0, 1.0))];
    scene.objects[0].shape = Instance::new(flat, steps).into();
    let wrong = [2.0 * 0.5, cos_degrees(30.0)];
    let cosine = wrong[1] / (wrong[0] * wrong[0] + wrong[1] * wrong[1]).sqrt();
    let right = [0.25, cos_degrees(30.0)];
    let right = right[1] / (right[0] * right[0] + right[1] * right[1]).sqrt();
    assert!((value(&ours(&scene)) - KD / PI * right).abs() < ROUNDING);
    expect("normal-by-matrix", &scene, KD / PI * cosine, ROUNDING);
}

/// Law: cells are numbered by truncated quotients. Oracle: Rust's conversion to integers, which truncates.
#[test]
fn checker_by_truncation() {
    let size = 0.75;
    let colors = [Rgb::WHITE, Rgb::grey(0.25)];
    let checker = Checker3d { size, color1: colors[0].into(), color2: colors[1].into() };
    let mut scene = plane(matte(1.0, 0.0, checker), 0.0);
    scene.lights.push(ambient(1.0));
    scene.image.resize(40, 40);
    scene.image.pixel_size = 0.1;
    let film = with("checker-truncated", &scene);
    let world = groundtruth::world::World::build(&scene).expect("it is valid");
    let mut count = 0;
    for at in (0..40).flat_map(|x| (0..40).map(move |y| [x, y])) {
        let sample = groundtruth::render::camera_sample(&world, at, 0).expect("it has one eye");
        let origin = sample.ray.expect("it sees something").origin;
        let cell = |x: f64| (x / size - 0.000_187_453_738) as i64;
        let is_odd = (cell(origin.x()) + cell(0.0) + cell(origin.z())) % 2 != 0;
        assert_eq!(film.get(at), colors[usize::from(is_odd)], "{at:?}");
        count += usize::from(is_odd);
    }
    assert!((400..1200).contains(&count), "{count} cells are odd");
}

/// Law: hills that are dents have the normals of a height field turned upside down. Oracle: that field, `n + ∇h` for `n − ∇h`.
#[test]
fn hills_that_are_dents() {
    let field = |height: f64| {
        let mut scene = lit_plane(diffuse(), 0.0, 40.0);
        scene.image.resize(8, 8);
        scene.image.pixel_size = 0.25;
        let hills = Fbm::new(Noise::of_octaves(4), 0.5);
        scene.materials[0].bump = Some(Height::new(hills, height).into());
        scene
    };
    let (dents, hills) = (with("bump-reversed", &field(0.25)), ours(&field(0.25)));
    let mut changed = 0;
    for (at, expected) in ours(&field(-0.25)).pixels().iter().enumerate() {
        let found = dents.pixels()[at];
        assert!((found.r - expected.r).abs() < ROUNDING, "found {found:?}, expected {expected:?}");
        changed += usize::from((found.r - hills.pixels()[at].r).abs() > 0.01);
    }
    assert!(changed > 32, "{changed} of 64 pixels show the bumps");
}
