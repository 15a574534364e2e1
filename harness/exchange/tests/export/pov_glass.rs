//! POV-Ray: glass, whose interiors its rays enter and leave.

use groundtruth::materials::{Dielectric, Kind, Medium, Phong, Transparent};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::{add, boxed, pinhole, point, sphere};
use groundtruth::scene::{Scene, Tracer, Whitted};
use groundtruth::shapes::Sphere;

use super::fixtures::{near, near_all, ours};
use super::texts::{Parts, each, numbers, three};

const SKY: [f64; 3] = [0.5, 0.25, 1.0];

/// One pixel that looks at the origin from 5 before it, under a sky of one colour.
fn scene(max_depth: u32) -> Scene {
    let mut scene = pinhole("glass", [1, 1], [point(0.0, 0.0, 5.0), Point::ORIGIN], 1000.0);
    scene.image.samples = 1;
    scene.tracer = Tracer::Whitted(Whitted { max_depth });
    scene.background = Rgb::from(SKY).into();
    scene
}

fn ball(radius: f64) -> Sphere {
    sphere(Point::ORIGIN, radius)
}

fn dielectric(eta: f64) -> Dielectric {
    Dielectric { inside: Medium::clear(eta), ..Dielectric::default() }
}

fn transparent(eta: f64) -> Transparent {
    let (kr, kt) = (0.125.into(), 0.75.into());
    let cr = Rgb::new(1.0, 0.5, 0.25).into();
    Transparent { phong: Phong::default(), kr, cr, kt, eta }
}

/// The statement with the interior of a material.
fn body(parts: &Parts, material: usize) -> &str {
    let front = format!(" front_{material} ");
    let is_it = |it: &&&str| it.contains(" interior {") && it.contains(&front);
    parts.all("").iter().find(is_it).expect("a body of glass")
}

/// Its index of refraction.
fn ior(parts: &Parts, material: usize) -> f64 {
    numbers(body(parts, material), "ior")[0]
}

/// The radiance seen through a pane of thickness 2, at depth 2, by the formulas of POV-Ray's source on what is written:
/// reflection · sky + (pass · pass) · sky.
fn their_pane(parts: &Parts) -> [f64; 3] {
    let (texture, body) = (parts.one("#declare front_0"), body(parts, 0));
    let (colors, transmit) = (each(texture, "rgb"), numbers(texture, "transmit")[0]);
    let (reflected, passed) = match texture.contains("fresnel") {
        true => {
            let ior = numbers(body, "ior")[0];
            let r = (ior - 1.0) * (ior - 1.0) / ((ior + 1.0) * (ior + 1.0));
            ([r; 3], transmit * (1.0 - r))
        }
        false => (three(colors[1].clone()), transmit),
    };
    std::array::from_fn(|i| SKY[i] * (reflected[i] + passed * passed))
}

/// Law: a pane of glass reflects and lets pass what ours does. Oracle: our picture beside POV-Ray's formulas on the
/// written numbers, and these numbers by hand: R = 1/25 for η = 1.5.
#[test]
fn a_pane_of_glass_has_its_radiance() {
    let kinds: [Kind; 2] = [dielectric(1.5).into(), transparent(1.5).into()];
    let hand = [
        SKY.map(|sky| sky * (0.04 + 0.96 * 0.96)),
        [0, 1, 2].map(|i| SKY[i] * (0.125 * [1.0, 0.5, 0.25][i] + 0.75 * 0.75)),
    ];
    for (kind, hand) in kinds.into_iter().zip(hand) {
        let mut scene = scene(2);
        // from −1 to 1 along z
        let pane = boxed(point(-9.0, -9.0, -1.0), point(9.0, 9.0, 1.0));
        add(&mut scene, "glass", pane, kind);
        let ours = ours(&scene);
        near_all(&ours, hand);
        let parts = Parts::pov(&scene);
        near(ior(&parts, 0), 1.5);
        near_all(&their_pane(&parts), ours);
    }
}

/// Law: a surface between equal indices still counts as an edge there: POV-Ray takes indices in single precision, and does
/// not count if their ratio is 1 up to 10⁻¹⁰.
#[test]
fn an_index_of_one_is_an_edge() {
    let mut scene = scene(4);
    add(&mut scene, "glass", ball(1.0), transparent(1.0));
    let ior = ior(&Parts::pov(&scene), 0);
    #[expect(clippy::cast_possible_truncation, reason = "as POV-Ray")]
    let single = f64::from(ior as f32);
    assert!(single - 1.0 > 1e-10, "{ior}");
    assert!(single - 1.0 < 1e-6, "{ior}");
}
