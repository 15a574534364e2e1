//! One scene for each kind of texture on surfaces. Numbers are ours unless a comment names the
//! book.

use super::{lines, lit, show};
use groundtruth::materials::{Kind as Material, Matte, Phong, SphereMaterials};
use groundtruth::math::{Axis, Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Scene, Tracer, Whitted};
use groundtruth::shapes::{Cone, Disk, Kind, OpenCylinder, Rectangle, TessellatedSphere};
use groundtruth::textures::{
    Checker3d, ConeChecker, CylinderChecker, DiskChecker, Lines, Paint, PlaneChecker, Ramp,
    RectangleChecker, SphereChecker, SphereTextures, Stripes, Wireframe, Wrap,
};

/// A sphere at this point, centred at the origin of its own coordinates, as sphere checkers need
/// it.
fn ball(radius: f64, at: Point) -> Kind {
    moved(sphere(Point::ORIGIN, radius), at.to_vector())
}

/// Figures 30.7 and 30.8: the radii are the book's.
pub fn sphere_checkers() -> Scene {
    let about = "figures 30.7 and 30.8: sphere checkers on spheres of six sizes, some with lines";
    let view = [point(0.0, 9.0, 40.0), point(0.0, 2.4, 0.0)];
    let mut scene = lit(pinhole(about, [600, 400], view, 1500.0));
    let blue = rgb(0.1, 0.3, 0.75);
    let balls = [
        (3.0, [-4.5, 0.0], [20, 10], lines(0.1, 0.1)),
        (2.25, [1.2, -0.5], [12, 6], Lines { color: rgb(0.8, 0.1, 0.0).into(), ..lines(0.2, 0.1) }),
        (1.75, [5.5, 0.0], [8, 8], lines(0.0, 0.0)),
        (1.0, [-0.5, 3.5], [20, 10], lines(0.2, 0.2)),
        (0.75, [2.2, 4.0], [12, 12], lines(0.0, 0.0)),
        (0.5, [4.3, 4.0], [6, 4], lines(0.1, 0.1)),
    ];
    for (i, (radius, [x, z], [num_horizontal, num_vertical], lines)) in (1..).zip(balls) {
        let (color1, color2) = (Rgb::WHITE.into(), blue.into());
        let checker = SphereChecker { num_horizontal, num_vertical, color1, color2, lines };
        let shape = transformed(
            sphere(Point::ORIGIN, radius),
            vec![Step::RotateX(25.0), Step::Translate(vector(x, radius, z))],
        );
        show(&mut scene, &format!("sphere {i}"), shape, checker);
    }
    show(&mut scene, "ground", ground(0.0), grey(0.5));
    scene
}

/// The checkers of the other generic shapes.
pub fn checkers() -> Scene {
    let about = "checkers with lines on a cylinder, a cone, a disk and a rectangle";
    let view = [point(0.0, 14.0, 30.0), point(0.0, 0.6, 0.0)];
    let mut scene = lit(pinhole(about, [600, 400], view, 1650.0));
    let [red, green, blue, gold] =
        [[0.75, 0.2, 0.1], [0.1, 0.5, 0.2], [0.1, 0.3, 0.75], [0.8, 0.6, 0.1]]
            .map(|c| Paint::from(Rgb::from(c)));
    let lines = lines(0.2, 0.1);

    let cylinder = OpenCylinder { y0: -1.0, y1: 1.0, radius: 1.0, inward: false };
    let checker =
        CylinderChecker { color2: red, lines: lines.clone(), ..CylinderChecker::default() };
    let steps = |x: f64, y: f64, z: f64| {
        vec![Step::Scale(vector(1.6, 1.6, 1.6)), Step::Translate(vector(x, y, z))]
    };
    show(&mut scene, "cylinder", transformed(cylinder, steps(-2.2, 1.6, -2.0)), checker);

    let cone = Cone { height: 2.0, radius: 1.0, inward: false };
    let checker = ConeChecker { color2: green, lines: lines.clone(), ..ConeChecker::default() };
    show(&mut scene, "cone", transformed(cone, steps(2.2, 0.0, -2.0)), checker);

    let disk = Disk { center: Point::ORIGIN, normal: Vector::Y, radius: 1.0 };
    let checker =
        DiskChecker { num_radial: 5, color2: blue, lines: lines.clone(), ..DiskChecker::default() };
    show(&mut scene, "disk", transformed(disk, steps(-2.2, 0.01, 2.0)), checker);

    let (a, b) = (2.0 * Vector::Z, 2.0 * Vector::X);
    let rectangle = Rectangle { corner: point(-1.0, 0.0, -1.0), a, b };
    let checker = RectangleChecker {
        num_horizontal: 8,
        num_vertical: 6,
        color2: gold,
        lines,
        ..RectangleChecker::default()
    };
    show(&mut scene, "rectangle", transformed(rectangle, steps(2.2, 0.01, 2.0)), checker);
    show(&mut scene, "ground", ground(0.0), grey(0.5));
    scene
}

/// Clamped, repeated and mirrored ramps.
pub fn ramp() -> Scene {
    let about = "ramps of three colours: from pole to pole, repeated, and mirrored";
    let view = [point(0.0, 3.0, 20.0), point(0.0, 0.0, 0.0)];
    let mut scene = lit(pinhole(about, [600, 250], view, 1500.0));
    let colors = [[0.7, 0.1, 0.05], [0.95, 0.85, 0.3], [0.05, 0.3, 0.7]];
    let colors = colors.map(|c| Paint::from(Rgb::from(c))).to_vec();
    let along_y = |half: f64, wrap| Ramp {
        axis: Axis::Y,
        from: -half,
        to: half,
        colors: colors.clone(),
        wrap,
    };
    let block = transformed(
        boxed(point(-0.9, -0.9, -0.9), point(0.9, 0.9, 0.9)),
        vec![Step::RotateY(30.0), Step::Translate(2.5 * Vector::X)],
    );
    show(&mut scene, "clamped", ball(1.1, point(-2.5, 0.0, 0.0)), along_y(1.1, Wrap::Clamp));
    show(&mut scene, "repeated", ball(1.1, Point::ORIGIN), along_y(0.3, Wrap::Repeat));
    show(&mut scene, "mirrored", block, along_y(0.3, Wrap::Mirror));
    scene
}

/// Numbers of a material that are textures.
pub fn coloured_amounts() -> Scene {
    let about = "coloured checkers as the k_d of a matte sphere and the k_s of a shiny one: red is the number, green \
                 and blue do not count";
    let view = [point(0.0, 3.0, 20.0), Point::ORIGIN];
    let mut scene = lit(pinhole(about, [600, 350], view, 2000.0));
    let (color1, color2) = (rgb(0.9, 0.1, 0.4), rgb(0.2, 0.8, 1.0));
    let amount = || Checker3d { size: 0.5, color1: color1.into(), color2: color2.into() }.into();
    let dull = Matte { ka: 0.4.into(), kd: amount(), cd: rgb(0.9, 0.8, 0.6).into() };
    let shiny = phong(0.4, 0.4, rgb(0.3, 0.5, 0.8), 0.0, 10.0);
    add(&mut scene, "matte", ball(1.3, point(-1.5, 0.0, 0.0)), dull);
    add(&mut scene, "shiny", ball(1.3, point(1.5, 0.0, 0.0)), Phong { ks: amount(), ..shiny });
    scene
}

/// The edges of triangles.
pub fn wireframe() -> Scene {
    let about = "the wireframe of a sphere of 264 triangles, shaded smooth, and of one with bumps";
    let view = [point(0.0, 4.0, 20.0), Point::ORIGIN];
    let mut scene = lit(pinhole(about, [600, 350], view, 2000.0));
    let wires = |line_width, color: [f64; 3]| Wireframe {
        line_width,
        line_color: Rgb::BLACK.into(),
        color: Rgb::from(color).into(),
    };
    let sphere = TessellatedSphere { radius: 1.3, ..TessellatedSphere::new(12, 12, true) };
    let bumpy =
        TessellatedSphere { radius: 1.2, bumps: 0.15, ..TessellatedSphere::new(48, 32, false) };
    show(&mut scene, "smooth", moved(sphere, -1.5 * Vector::X), wires(0.04, [0.9, 0.8, 0.5]));
    show(&mut scene, "bumpy", moved(bumpy, 1.5 * Vector::X), wires(0.015, [0.5, 0.75, 0.9]));
    scene
}

/// A texture for each checker.
pub fn sphere_textures() -> Scene {
    let about = "a texture for each checker of a sphere: plain, solid checker, stripes and ramp";
    let view = [point(0.0, 4.0, 12.0), Point::ORIGIN];
    let mut scene = lit(pinhole(about, [400, 400], view, 1600.0));
    let stripes = Stripes {
        axis: Axis::X,
        size: 0.06,
        color1: Rgb::WHITE.into(),
        color2: rgb(0.1, 0.3, 0.7).into(),
    };
    let checker =
        Checker3d { size: 0.08, color1: Rgb::WHITE.into(), color2: rgb(0.2, 0.5, 0.2).into() };
    let ramp = Ramp {
        axis: Axis::Y,
        from: -0.2,
        to: 0.2,
        colors: vec![rgb(0.8, 0.2, 0.0).into(), rgb(1.0, 0.9, 0.4).into()],
        wrap: Wrap::Mirror,
    };
    let textures = vec![
        stripes.into(),
        checker.into(),
        ramp.into(),
        rgb(0.9, 0.75, 0.6).into(),
        grey(0.3).into(),
    ];
    let textures =
        SphereTextures { num_horizontal: 12, num_vertical: 6, textures, lines: lines(0.06, 0.06) };
    show(&mut scene, "sphere", ball(1.4, Point::ORIGIN), textures);
    scene
}

/// A material for each checker.
pub fn sphere_materials() -> Scene {
    let about = "a material for each checker of a sphere: mirror, matte and glossy, over a checker";
    let view = [point(0.0, 3.5, 12.0), point(0.0, 1.2, 0.0)];
    let mut scene = lit(pinhole(about, [400, 400], view, 1400.0));
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
    scene.background = rgb(0.6, 0.75, 1.0).into();
    let chrome = mirror(phong(0.0, 0.0, Rgb::BLACK, 0.3, 200.0), 0.9, Rgb::WHITE);
    let plain = matte(0.4, 0.8, rgb(0.8, 0.3, 0.1));
    let shiny = phong(0.4, 0.5, rgb(0.1, 0.2, 0.5), 0.5, 20.0);
    let materials: Vec<Material> = vec![chrome.into(), plain.into(), shiny.into()];
    let ball = ball(1.4, point(0.0, 1.4, 0.0));
    add(
        &mut scene,
        "sphere",
        ball,
        SphereMaterials { num_horizontal: 10, num_vertical: 6, materials },
    );
    let checker = PlaneChecker {
        size: 1.0,
        color1: Rgb::WHITE.into(),
        color2: grey(0.4).into(),
        outline_width: 0.0,
        outline_color: Rgb::BLACK.into(),
    };
    show(&mut scene, "ground", ground(0.0), checker);
    scene
}
