//! Whole pictures of chapter 3: which pixels see what.

use crate::prelude::*;

/// Law: the pixel in column c and row r (counted up) looks from `(s (c − (w − 1)/2), s (r − (h −
/// 1)/2), 100)` along −z, also where the number of pixels is odd. Oracle: the book's formula in
/// halves, which are exact.
/// Book: pixel points of an orthographic view.
#[test]
fn pixels_look_through_their_centers() {
    for (width, height, size) in [(5, 4, 0.5), (1, 1, 3.0), (8, 3, 2.0)] {
        let world = built(&from_front(width, height, size));
        for at in pixels(width, height) {
            let (ray, film) = camera_ray(&world, at, 0);
            let [c, r] = [f64::from(at[0]), f64::from(height - 1 - at[1])];
            let x = size * (c - 0.5 * f64::from(width - 1));
            let y = size * (r - 0.5 * f64::from(height - 1));
            assert_eq!(film, [x, y]);
            assert_eq!((ray.origin, ray.direction), (Point::new(x, y, 100.0), -Vector::Z));
        }
    }
}

/// Law: a sphere of radius 85 covers the pixels whose centres are in its disk, π 85² within the boundary,
/// wherever it is along the view. Oracle: whole numbers, the centres being at odd multiples of a half: `(2c +
/// 1)² + (2r + 1)² < (2·85)²`.
/// Book: fig. 3.18, a single sphere.
#[test]
fn a_sphere_covers_the_centers_within_its_disk() {
    for z in [0.0, -1000.0, 14.0] {
        let mut scene = from_front(200, 200, 1.0);
        add_flat(
            &mut scene,
            "ball",
            Sphere { center: Point::new(0.0, 0.0, z), radius: 85.0, inward: false },
            RED,
        );
        let film = render::render(&built(&scene));
        let mut count = 0;
        for at in pixels(200, 200) {
            let [a, b] = at.map(|i| 2 * i64::from(i) - 199);
            let inside = a * a + b * b < 170 * 170;
            assert_eq!(film.get(at) == RED, inside, "{at:?} at z = {z}");
            count += u32::from(inside);
        }
        let area = std::f64::consts::PI * 85.0 * 85.0;
        near!(f64::from(count), area, 2.0 * std::f64::consts::PI * 85.0);
    }
}

/// Law: halving the pixel size and doubling the resolution keeps the framing: four fine pixels are the four
/// regular samples of a coarse one. Oracle: quarters of red, which are exact.
/// Book: pixel points of an orthographic view.
#[test]
fn halving_the_pixels_leaves_the_framing() {
    let scene = |width, size| {
        let mut scene = from_front(width, width, size);
        let center = Point::new(1.5, -3.25, 0.0);
        add_flat(&mut scene, "ball", Sphere { center, radius: 11.3, inward: false }, RED);
        scene.image.sampler = Some(Regular {}.into());
        scene
    };
    let fine = render::render(&built(&scene(64, 0.5)));
    let mut coarse = scene(32, 1.0);
    coarse.image.samples = 4;
    let coarse = render::render(&built(&coarse));
    for [x, y] in pixels(32, 32) {
        let four = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[i, j]| fine.get([2 * x + i, 2 * y + j]));
        let quarters = four.iter().filter(|&&pixel| pixel == RED).count();
        assert_eq!(coarse.get([x, y]), Rgb::new(quarters as f64 / 4.0, 0.0, 0.0), "({x}, {y})");
    }
}

fn three_objects() -> groundtruth::scene::Scene {
    let mut scene = (gallery::find("ch03/three-objects").expect("in the gallery").build)();
    scene.image.resize(50, 50);
    scene
}

/// Law: a pixel's normal, point and colour are those of the nearest object, whatever is tested after
/// it. Oracle: the three heights above the view plane by their formulas, the largest of which is
/// seen.
/// Book: the nearest of several objects.
#[test]
fn the_nearest_object_keeps_its_normal() {
    let scene = three_objects();
    let world = built(&scene);
    let mut seen = [0; 3];
    for at in pixels(50, 50) {
        let (_, [x, y]) = camera_ray(&world, at, 0);
        let ball = |c: f64, r: f64| (r * r - x * x - (y - c) * (y - c)).sqrt(); // NaN beside it
        let (half, a, b) = (0.5_f64.sqrt(), ball(-25.0, 80.0), ball(30.0, 60.0));
        let heights = [
            (a, Vector::new(x, y + 25.0, a) / 80.0),
            (b, Vector::new(x, y - 30.0, b) / 60.0),
            (-y, Vector::new(0.0, half, half)), // y + z = 0
        ];
        let nearest = (0..3).filter(|&i| !heights[i].0.is_nan());
        let nearest = nearest.max_by(|&i, &j| heights[i].0.total_cmp(&heights[j].0));
        let nearest = nearest.expect("the plane is everywhere");
        let mut tree = RayTree::of(&world);
        render::sample(&world, at, 0, &mut tree);
        let Some(hit) = &tree.root().hit else { panic!("{at:?} hits nothing") };
        assert_eq!(hit.object, world.names.objects[nearest], "{at:?}");
        assert!((Vector::from(hit.normal) - heights[nearest].1).length() < 1e-12, "{at:?}");
        assert!((hit.t - (100.0 - heights[nearest].0)).abs() < 1e-9, "{at:?}");
        seen[nearest] += 1;
    }
    assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
}

/// Law: the order in which objects are added does not matter. Oracle: all six orders.
/// Book: the nearest of several objects.
#[test]
fn the_order_of_objects_does_not_matter() {
    let scene = three_objects();
    let original = render::render(&built(&scene));
    for [a, b, c] in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let mut shuffled = scene.clone();
        shuffled.objects = [a, b, c].map(|i| scene.objects[i].clone()).to_vec();
        let film = render::render(&built(&shuffled));
        assert_same_bits(&format!("{a}, {b}, {c}"), &film, &original);
    }
}

/// Law: of two objects at the same position the first is seen. Oracle: two equal spheres.
#[test]
fn of_two_objects_at_the_same_place_the_first_is_seen() {
    let mut scene = from_front(3, 3, 1.0);
    let ball = Sphere { center: Point::ORIGIN, radius: 9.0, inward: false };
    add_flat(&mut scene, "first", ball.clone(), RED);
    add_flat(&mut scene, "second", ball, Rgb::WHITE);
    assert_eq!(render::render(&built(&scene)).pixels(), [RED; 9]);
}

/// Law: a ray that hits nothing shows the background; spheres behind the eye, around it and cut by its plane
/// show only what is in front of it (figure 3.4). Oracle: by inspection.
/// Book: rays that hit nothing, and objects around the eye.
#[test]
fn spheres_around_the_eye_show_what_is_in_front_of_it() {
    let background = Rgb::new(0.25, 0.5, 0.75);
    for (z, radius, seen) in [
        (0.0, 10.0, true),
        (100.0, 10.0, true),  // the eye is inside
        (105.0, 10.0, true),  // only its far side is in front
        (111.0, 10.0, false), // just behind
        (1000.0, 10.0, false),
    ] {
        let mut scene = from_front(1, 1, 1.0);
        scene.background = background.into();
        add_flat(
            &mut scene,
            "ball",
            Sphere { center: Point::new(0.0, 0.0, z), radius, inward: false },
            RED,
        );
        let expected = if seen { RED } else { background };
        assert_eq!(render::pixel(&built(&scene), [0, 0]), expected, "z = {z}");
    }
}

/// Law: the chapter's first scene has the book's 400 × 400 pixels of side ½; and a plane seen edge on does
/// not appear. Oracle: the plane contains the view direction.
/// Book: fig. 3.18, a single sphere.
#[test]
fn a_plane_seen_edge_on_is_not_there() {
    let scene = (gallery::find("ch03/single-sphere").expect("in the gallery").build)();
    assert_eq!((scene.image.width, scene.image.height, scene.image.pixel_size), (400, 400, 0.5));
    let mut scene = from_front(3, 3, 1.0);
    add_flat(&mut scene, "wall", Plane { point: Point::ORIGIN, normal: Vector::X }, RED);
    let world = World::build(&scene).expect("a valid scene");
    assert_eq!(render::render(&world).pixels(), [Rgb::BLACK; 9]);
}

/// Law: a picture of another size and aspect shows the same width of the scene, in square pixels. Oracle: a
/// sphere's outline, whose radius in pixels, across and down, depends on the picture's width alone.
#[test]
fn another_aspect_keeps_what_is_seen_from_left_to_right() {
    for [width, height] in [[100_u32, 100], [100, 60], [50, 100], [160, 40]] {
        let mut scene = from_front(80, 80, 0.05);
        let ball = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
        add_flat(&mut scene, "ball", ball, RED);
        scene.image.resize(width, height);
        let world = built(&scene);
        let is_ball = |x, y| world.hit(&camera_ray(&world, [x, y], 0).0, Span::AHEAD).is_some();
        // the view is 4 wide: a diameter of 2 is half of it
        let across = (0..width).filter(|&x| is_ball(x, height / 2)).count() as f64;
        let down = (0..height).filter(|&y| is_ball(width / 2, y)).count() as f64;
        let expected = 0.5 * f64::from(width);
        for (way, found, most) in [("across", across, width), ("down", down, height)] {
            let expected = expected.min(f64::from(most));
            let off = (found - expected).abs();
            assert!(off <= 2.0, "{width}×{height}: {found} pixels {way}, expected {expected}");
        }
    }
}

/// Law: seen by parallel rays, 34 of the 35 spheres of page one are in the picture; the thirteenth is hidden by those in
/// front of it. Oracle: the book's list, which says so of that sphere.
/// Book: page one, 35 spheres.
#[test]
fn the_thirteenth_sphere_of_page_one_is_hidden() {
    let mut scene = (gallery::find("ch14/page-one").expect("in the gallery").build)();
    scene.camera.lens = Orthographic { zoom: 1.0 }.into();
    scene.image.resize(400, 400);
    let world = built(&scene);
    let rays = pixels(400, 400).map(|at| camera_ray(&world, at, 0).0);
    let hits = rays.filter_map(|ray| Some(world.hit(&ray, Span::AHEAD)?.object.name.clone()));
    let seen: std::collections::BTreeSet<_> = hits.collect();
    assert_eq!(seen.len(), 34);
    assert!(!seen.contains("sphere 13"), "{seen:?}");
}
