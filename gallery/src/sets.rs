//! Objects that several chapters use: the objects of chapter 8, the wireframe box, the box canyon,
//! the city, the columns of chapter 12 and the boxes of chapter 10.

use groundtruth::cameras::ThinLens;
use groundtruth::materials::Matte;
use groundtruth::math::{Pcg32, Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Scene};
use groundtruth::shapes::{self, Compound, OpenCylinder, Triangle};

/// Sphere, box and triangle of figure 8.16, and their light.
pub fn basic_objects(scene: &mut Scene) {
    scene.lights.push(ambient(1.0));
    scene.lights.push(point_light("lamp", point(50.0, 150.0, 200.0), 6.0).without_shadows());
    let olive = phong(0.5, 0.4, rgb(0.5, 0.6, 0.0), 0.05, 25.0);
    add(scene, "sphere", sphere(point(-45.0, 45.0, 40.0), 50.0), olive);
    let corners = boxed(point(20.0, -101.0, -100.0), point(90.0, 100.0, 20.0));
    add(scene, "box", corners, matte(0.4, 0.3, rgb(0.8, 0.5, 0.0)));
    let vertices =
        [point(-110.0, -85.0, 80.0), point(120.0, 10.0, 20.0), point(-40.0, 50.0, -30.0)];
    let triangle = Triangle { vertices, normals: None };
    add(scene, "triangle", triangle, phong(0.25, 0.5, rgb(0.0, 0.5, 0.5), 0.05, 50.0));
}

/// The edges of the cube from −half to half: 12 bars, and balls at the corners.
pub fn wireframe_box(half: f64, radius: f64) -> Compound {
    let bar = OpenCylinder { y0: -half, y1: half, radius, inward: false };
    let mut parts: Vec<shapes::Kind> = Vec::new();
    for (i, j) in [(-half, -half), (-half, half), (half, -half), (half, half)] {
        let upright = || moved(bar.clone(), vector(i, 0.0, j));
        parts.push(upright());
        parts.push(transformed(upright(), vec![Step::RotateX(90.0)]));
        parts.push(transformed(upright(), vec![Step::RotateZ(90.0)]));
        for y in [-half, half] {
            parts.push(sphere(point(i, y, j), radius).into());
        }
    }
    Compound::of(parts)
}

/// The four rows of boxes of figures 9.10 and 11.7.
pub struct Canyon {
    /// The x coordinate of the right side of the rightmost row.
    pub right: f64,
    /// The height of the third row from the right.
    pub tallest: f64,
}

/// 40 boxes in each row, along −z; boxes and rows are 50 wide and 100 apart.
pub fn canyon(scene: &mut Scene, canyon: &Canyon) {
    const SIDE: f64 = 50.0;
    const APART: f64 = 150.0;
    scene.lights.push(ambient(1.0));
    scene.lights.push(directional("sun", vector(150.0, 250.0, 150.0), 3.5).without_shadows());
    let rows = [
        ("first row", 150.0, rgb(0.4, 0.5, 0.4)),
        ("second row", 300.0, rgb(0.95, 0.95, 0.75)),
        ("third row", canyon.tallest, rgb(0.55, 0.7, 0.85)),
        ("fourth row", 150.0, rgb(0.85, 0.5, 0.35)),
    ];
    for (row, (name, height, color)) in (0..).zip(rows) {
        let right = canyon.right - APART * f64::from(row);
        let at = |i: i32| {
            let front = -APART * f64::from(i);
            boxed(point(right - SIDE, 0.0, front - SIDE), point(right, height, front))
        };
        add(scene, name, Compound::of((0..40).map(at)), matte(0.4, 0.6, color));
    }
    let squares = checker3d(100.0, grey(0.7), Rgb::WHITE);
    add(scene, "ground", ground(0.0), matte(0.3, 0.5, squares));
}

/// The city of chapter 11 on checkered ground, in this ambient light.
pub fn city(scene: &mut Scene, sky: Light) {
    let lawn = checker3d(5.0, rgb(0.35, 0.75, 0.35), rgb(0.3, 0.5, 0.3));
    let streets = checker3d(50.0, grey(0.7), Rgb::WHITE);
    city_on(scene, sky, [matte(0.3, 0.5, lawn), matte(0.3, 0.5, streets)]);
}

/// 10 rows of 12 blocks around a park, on this lawn and these streets.
pub fn city_on(scene: &mut Scene, sky: Light, [lawn, streets]: [Matte; 2]) {
    const ROWS: u32 = 10;
    const COLUMNS: u32 = 12;
    /// A block, along x and z.
    const BLOCK: [f64; 2] = [10.0, 12.0];
    /// The smallest side of a building.
    const MIN_SIDE: f64 = 6.0;
    /// The smallest distance of a building from the edges of its block.
    const OFFSET: f64 = 1.0;
    scene.lights.push(sky);
    scene.lights.push(point_light("lamp", point(150.0, 500.0, 300.0), 3.75));
    let mut random = Pcg32::new(15, 0);
    let corner = [-0.5 * BLOCK[0] * f64::from(COLUMNS), -0.5 * BLOCK[1] * f64::from(ROWS)];
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let in_park = (3..7).contains(&row) && (3..9).contains(&column);
            if in_park {
                continue;
            }
            let block = [column, row];
            let [x, z] = [0, 1].map(|i| {
                let start = corner[i] + BLOCK[i] * f64::from(block[i]);
                let free = BLOCK[i] - 2.0 * OFFSET - MIN_SIDE;
                let side = MIN_SIDE + free * random.uniform();
                let from = start + OFFSET + (MIN_SIDE + free - side) * random.uniform();
                [from, from + side]
            });
            let inner = row == 1 || row == ROWS - 2 || column == 1 || column == COLUMNS - 2;
            let height = 30.0 * random.uniform() * if inner { 1.5 } else { 1.0 };
            let mut channel = || 0.1 + 0.8 * random.uniform();
            let color = rgb(channel(), channel(), channel());
            let name = format!("building {row} {column}");
            let building = boxed(point(x[0], 0.0, z[0]), point(x[1], height, z[1]));
            add(scene, &name, building, matte(0.4, 0.6, color));
        }
    }
    let [half_x, half_z] = [3.0 * BLOCK[0], 2.0 * BLOCK[1]];
    let park = boxed(point(-half_x, 0.0, -half_z), point(half_x, 0.1, half_z));
    add(scene, "park", park, lawn);
    add(scene, "ground", ground(0.01), streets);
}

/// Rings of columns around the eye: number, distance, height, and rotation in degrees.
const RINGS: [(u32, f64, f64, f64); 3] =
    [(12, 150.0, 500.0, 0.0), (16, 350.0, 450.0, 0.0), (16, 500.0, 325.0, 10.0)];

/// The columns of the picture of page one of chapter 12.
pub fn rings_of_columns(scene: &mut Scene) {
    scene.lights.push(ambient(1.0));
    scene.lights.push(point_light("lamp", point(0.0, 600.0, 0.0), 2.0).without_shadows());
    for (ring, (count, distance, height, turned)) in (1..).zip(RINGS) {
        let column = OpenCylinder { y0: 0.0, y1: height, radius: 25.0, inward: false };
        let at = |i: u32| {
            let degrees = turned + 360.0 * f64::from(i) / f64::from(count);
            let steps = vec![Step::Translate(distance * Vector::Z), Step::RotateY(degrees)];
            transformed(column.clone(), steps)
        };
        let tint = [rgb(0.9, 0.6, 0.3), rgb(0.5, 0.7, 0.9), rgb(0.6, 0.8, 0.5)][ring - 1];
        let name = format!("ring {ring}");
        add(scene, &name, Compound::of((0..count).map(at)), matte(0.35, 0.65, tint));
    }
    let squares = checker3d(100.0, grey(0.6), Rgb::WHITE);
    add(scene, "ground", ground(0.0), matte(0.3, 0.5, squares));
}

/// The lens of chapter 10, focused on the near box.
pub const LENS: ThinLens =
    ThinLens { distance: 40.0, focal_distance: 50.0, lens_radius: 1.0, zoom: 1.0 };

/// The light and the ground of chapter 10.
pub fn daylight(scene: &mut Scene) {
    scene.background = Rgb::WHITE.into();
    scene.lights.push(ambient(0.5));
    scene.lights.push(directional("sun", vector(1.0, 1.0, 1.0), 7.5));
    let checks = checker3d(8.0, grey(0.25), Rgb::WHITE);
    add(scene, "ground", ground(0.0), matte(0.5, 0.35, checks));
}

/// A box between these corners, checkered in a colour and black.
pub fn add_checkered_box(scene: &mut Scene, name: &str, [min, max]: [Point; 2], color: Rgb) {
    let checks = matte(0.5, 0.35, checker3d(2.0, color, Rgb::BLACK));
    add(scene, name, boxed(min, max), checks);
}

/// The three checkered boxes of chapter 10, their fronts at z = 0, −24 and −48.
pub fn boxes_in_depth(scene: &mut Scene) {
    daylight(scene);
    for (name, corners, color) in [
        ("near box", [[-9.0, 0.0, -1.0], [-3.0, 12.0, 0.0]], rgb(1.0, 1.0, 0.33)),
        ("middle box", [[-3.25, 0.0, -25.0], [4.75, 14.0, -24.0]], rgb(0.1, 1.0, 0.5)),
        ("far box", [[8.0, 0.0, -49.0], [18.0, 15.0, -48.0]], rgb(1.0, 0.6, 0.15)),
    ] {
        add_checkered_box(scene, name, corners.map(Point::from), color);
    }
}
