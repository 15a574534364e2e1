//! Whole pictures and parts of them: threads, crops, single pixels, unfinished pictures, seeds.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use groundtruth::render::{Canvas, Crop};
use serde::Deserialize;

use crate::prelude::*;

fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("threads can be started").install(work)
}

/// Law: the picture does not depend on the number of threads. Oracle: one thread.
/// Book: the skeleton: worker threads, and a picture shown while it renders.
#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let mut scene = small("ch24/hall-of-mirrors", 40, 35, 3);
    scene.image.sampler = Some(Random {}.into());
    let world = built(&scene);
    let alone = on_threads(1, || render::render(&world));
    for threads in [2, 3, 7] {
        let together = on_threads(threads, || render::render(&world));
        assert_same_bits(&format!("{threads} threads"), &together, &alone);
    }
}

/// Law: a 1 × 1 picture of a box seen from +z has the normal (0, 0, 1), exactly (the book's own
/// anecdote). Oracle: the face itself.
/// Book: debugging with single pixels and simple scenes.
#[test]
fn one_pixel_of_a_box_has_the_normal_of_its_front() {
    let lens = Pinhole { distance: 3.0, zoom: 1.0 };
    let perspective = Viewpoint::new(Point::new(0.0, 0.0, 7.0), Point::ORIGIN, lens);
    for camera in [from_front(1, 1, 1.0).camera, perspective] {
        let mut scene = Scene::new("", Image::new(1, 1), camera);
        let (min, max) = (Point::new(-1.0, -1.0, -1.0), Point::new(1.0, 1.0, 1.0));
        add_flat(&mut scene, "box", shapes::Cuboid { min, max }, RED);
        let world = built(&scene);
        let mut tree = RayTree::of(&world);
        render::sample(&world, [0, 0], 0, &mut tree);
        let Some(hit) = &tree.root().hit else { panic!("the box is ahead") };
        assert_eq!(hit.normal.to_array(), [0.0, 0.0, 1.0]);
        assert_eq!(hit.point, Point::new(0.0, 0.0, 1.0));
        assert!(hit.front, "met from behind: {hit:?}");
    }
}

/// Law: a single replayed pixel and any crop equal the same pixels of the whole picture. Oracle: the whole
/// picture; the crops cross the borders of tiles.
/// Book: debugging with single pixels and simple scenes.
#[test]
fn parts_and_single_pixels_are_those_of_the_whole() {
    let mut scene = small("ch28/glass-sphere", 37, 35, 4);
    scene.image.sampler = Some(Jittered {}.into());
    let world = built(&scene);
    let whole = render::render(&world);
    for at in pixels(37, 35) {
        assert_eq!(bits(render::pixel(&world, at)), bits(whole.get(at)), "{at:?}");
    }
    for crop in [
        Crop { x: 0, y: 0, width: 37, height: 1 },
        Crop { x: 5, y: 7, width: 20, height: 28 },
        Crop { x: 36, y: 34, width: 1, height: 1 },
    ] {
        let canvas = Canvas::cropped(crop);
        canvas.render(&world);
        let part = canvas.film();
        assert_eq!((part.width(), part.height()), (crop.width, crop.height));
        for [x, y] in pixels(crop.width, crop.height) {
            let expected = whole.get([crop.x + x, crop.y + y]);
            assert_eq!(bits(part.get([x, y])), bits(expected), "({x}, {y}) of {crop:?}");
        }
    }
}

/// The plane z = 0; at ray number `last` it records the film of the canvas and cancels the rendering.
#[derive(Debug)]
struct Interrupter {
    rays: AtomicU32,
    last: u32,
    canvas: OnceLock<Arc<Canvas>>,
    seen: OnceLock<Film>,
    plane: Arc<dyn Shape>,
}

impl Shape for Interrupter {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        if self.rays.fetch_add(1, Relaxed) + 1 == self.last {
            let canvas = self.canvas.get().expect("set before rendering");
            let _ = self.seen.set(canvas.film());
            canvas.cancel();
        }
        self.plane.hit(ray, span)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        self.plane.surface(ray, at)
    }

    fn bounds(&self) -> Aabb {
        Aabb::EVERYTHING
    }
}

/// A red picture of 48 × 16 pixels with this number of samples, one ray each, whose rendering is cancelled at ray
/// number `last`.
fn interrupted_of(samples: u32, last: u32) -> (Arc<Interrupter>, World, Arc<Canvas>) {
    let mut scene = from_front(48, 16, 1.0);
    scene.image.samples = samples;
    let plane = shapes::Kind::from(Plane { point: Point::ORIGIN, normal: Vector::Z });
    let interrupter = Arc::new(Interrupter {
        rays: AtomicU32::new(0),
        last,
        canvas: OnceLock::new(),
        seen: OnceLock::new(),
        plane: plane.build(&mut shapes::Context::default()).expect("a valid plane"),
    });
    let shape = shapes::Kind::Custom(Custom(Arc::<Interrupter>::clone(&interrupter)));
    add_flat(&mut scene, "plane", shape, RED);
    let world = built(&scene);
    let canvas = Arc::new(Canvas::new(&world));
    interrupter.canvas.set(Arc::clone(&canvas)).expect("set once");
    (interrupter, world, canvas)
}

/// Law: while a canvas renders, its finished pixels can be read and it can be stopped; the other pixels are
/// black and not counted as done. Oracle: one thread and one sample per pixel, so that at the 300th ray the
/// 12 pixels of the coarse picture are seen, and the other 252 of the first tile of 16 × 16; those of the second tile
/// that were finished before it are kept when it ends.
/// Book: the skeleton: worker threads, and a picture shown while it renders.
#[test]
fn the_picture_so_far_can_be_seen_and_stopped() {
    let (interrupter, world, canvas) = interrupted_of(1, 300);
    assert_eq!((canvas.progress(), canvas.is_cancelled()), ((0, 768), false));

    on_threads(1, || canvas.render(&world));

    let finished = |film: &Film| film.pixels().iter().filter(|&&pixel| pixel == RED).count();
    let black = |film: &Film| film.pixels().iter().filter(|pixel| pixel.is_black()).count();
    let seen = interrupter.seen.get().expect("more than 300 rays were cast");
    assert_eq!((finished(seen), black(seen)), (264, 504));
    let film = canvas.film();
    assert_eq!((finished(&film), black(&film)), (299, 469));
    assert_eq!(canvas.look(finished), 299);
    assert_eq!((canvas.progress(), canvas.is_cancelled()), ((299, 768), true));
    assert!(interrupter.rays.load(Relaxed) <= 301, "it went on after it was stopped");
    // a black pixel is rendered, too
    let black = small("ch24/hall-of-mirrors", 9, 9, 1);
    let black = built(&Scene { lights: Vec::new(), ..black });
    let canvas = Canvas::new(&black);
    canvas.look_partly(|picture| assert_eq!(picture.get([8, 8]), None));
    canvas.render(&black);
    canvas.look_partly(|picture| assert_eq!(picture.get([8, 8]), Some(Rgb::BLACK)));
}

/// Law: the same seed gives the same picture, and another seed another one, except with a sampler that is not
/// random. Oracle: building again.
/// Book: random numbers from one seed.
#[test]
fn only_the_seed_changes_random_samples() {
    let mut scene = small("ch14/page-one", 32, 32, 4);
    let seeded = |scene: &Scene, seed| {
        let world = World::build_seeded(scene, Path::new(""), seed).expect("the scene is valid");
        render::render(&world)
    };
    for sampler in [Random {}.into(), Jittered {}.into()] {
        scene.image.sampler = Some(sampler);
        assert_same_bits("reseeded", &seeded(&scene, 7), &seeded(&scene, 7));
        assert_ne!(seeded(&scene, 7), seeded(&scene, 8));
    }
    scene.image.sampler = Some(Regular {}.into());
    assert_same_bits("nothing random", &seeded(&scene, 7), &seeded(&scene, 8));
}

/// Law: wherever a colour is expected it can be written as `[r, g, b]`, or as one number for a grey. Oracle:
/// the definition of a grey.
/// Book: three forms of setters for colours.
#[test]
fn a_colour_can_be_one_number() {
    #[derive(Deserialize)]
    struct Colors {
        plain: Rgb,
        paint: Paint,
        light: Ambient,
    }
    let read = |grey: &str| {
        let text = format!("plain = {grey}\npaint = {grey}\nlight = {{ color = {grey} }}");
        let Colors { plain, paint, light } = toml::from_str(&text).expect("three colours");
        (plain, serde_json::to_value(paint).expect("plain data"), light)
    };
    for (one, three, value) in [("0.3", "[0.3, 0.3, 0.3]", 0.3), ("1", "[1, 1.0, 1]", 1.0)] {
        let (plain, paint, light) = read(one);
        assert_eq!((plain, paint.clone(), light.clone()), read(three));
        let grey = Rgb::new(value, value, value);
        assert_eq!((plain, light.color), (grey, grey));
        assert_eq!(paint, serde_json::json!([value, value, value]));
    }
    for plain in ["[1, 2]", "[1, 2, 3, 4]"] {
        let read = toml::from_str::<Colors>(&format!("plain = {plain}\npaint = 1\nlight = {{}}"));
        assert!(read.is_err(), "{plain} is read as a colour");
    }
}

/// Law: a preview takes one ray of each coarse pixel, the first of its samples; it is shown for the pixels
/// around it until the coarse pixel is rendered, and no pixel counts as done. Oracle: rays counted, and the
/// library's sample.
#[test]
fn a_preview_has_one_sample_of_each_coarse_pixel() {
    let (interrupter, world, canvas) = interrupted_of(100, u32::MAX);
    canvas.preview(&world, &|| false);
    assert_eq!(interrupter.rays.load(Relaxed), 12);
    assert_eq!(canvas.progress(), (0, 768));
    let mut scene = small("ch28/glass-sphere", 37, 35, 16);
    scene.camera.exposure_time = 3.0;
    let world = built(&scene);
    let canvas = Canvas::new(&world);
    canvas.preview(&world, &|| false);
    let corner = |[x, y]: [u32; 2]| [x / 8 * 8, y / 8 * 8];
    canvas.look_partly(|picture| {
        for at in pixels(37, 35) {
            let first = 3.0 * render::sample(&world, corner(at), 0, &mut ());
            assert_eq!(picture.get(at), None, "{at:?}");
            assert_eq!(picture.coarse(at).map(bits), Some(bits(first)), "{at:?}");
        }
    });
    canvas.render_coarse(&world);
    canvas.look_partly(|picture| {
        for at in pixels(37, 35) {
            let expected = render::pixel(&world, corner(at));
            assert_eq!(picture.coarse(at).map(bits), Some(bits(expected)), "{at:?}");
        }
    });
}

/// Law: a picture in slices, as a program of one thread renders it between two frames, is the same: each slice takes
/// as many rays as it is given, the preview comes first, then the coarse pixels, and none is rendered twice. Oracle:
/// rays counted; the picture in one piece.
#[test]
fn a_picture_in_slices_is_the_same() {
    let of_one_ray = 12 + 768;
    for given in [1, 5, 100, 263, of_one_ray] {
        let (interrupter, world, canvas) = interrupted_of(1, u32::MAX);
        let mut slices = 0;
        let mut is_whole = false;
        on_threads(1, || {
            while !is_whole {
                let end = interrupter.rays.load(Relaxed) + given;
                let is_over = || interrupter.rays.load(Relaxed) >= end;
                is_whole =
                    canvas.preview(&world, &is_over) && canvas.render_until(&world, &is_over);
                slices += 1;
                let rays = interrupter.rays.load(Relaxed);
                assert_eq!(rays, (slices * given).min(of_one_ray), "slices of {given}");
                let rendered = rays.saturating_sub(12);
                assert_eq!(canvas.progress().0, u64::from(rendered), "slices of {given}");
                canvas.look_partly(|picture| {
                    let coarse = pixels(48, 16).filter(|[x, y]| x % 8 == 0 && y % 8 == 0);
                    let coarse = coarse.filter(|&at| picture.get(at).is_some()).count();
                    assert_eq!(coarse as u32, rendered.min(12), "slices of {given}");
                });
            }
        });
        assert_eq!(slices, of_one_ray.div_ceil(given));
        let whole = Canvas::new(&world);
        whole.render(&world);
        assert_same_bits("in slices", &canvas.film(), &whole.film());
    }
    let world = built(&small("ch28/glass-sphere", 37, 35, 4));
    let [sliced, whole] = [Canvas::new(&world), Canvas::new(&world)];
    whole.render(&world);
    let asked = AtomicU32::new(0);
    while !sliced.render_until(&world, &|| asked.fetch_add(1, Relaxed) % 7 == 6) {}
    assert_same_bits("glass in slices", &sliced.film(), &whole.film());
    let value = |[x, y]: [u32; 2]| Rgb::new(f64::from(x), f64::from(y), 1.0);
    let [sliced, whole] = [Canvas::new(&world), Canvas::new(&world)];
    whole.fill(value);
    while !sliced.fill_until(value, &|| asked.fetch_add(1, Relaxed) % 7 == 6) {}
    assert_same_bits("values in slices", &sliced.film(), &whole.film());
}

/// Law: a pixel of many samples ends as soon as it is stopped, without a further ray, and is not kept; neither
/// is one of a preview. Oracle: rays counted; the last coarse pixel of the first tile is the fourth.
#[test]
fn a_pixel_that_is_stopped_casts_no_further_ray() {
    for last in [1, 500, 1024, 3 * 1024 + 500] {
        let (interrupter, world, canvas) = interrupted_of(1024, last);
        on_threads(1, || canvas.render(&world));
        assert_eq!(interrupter.rays.load(Relaxed), last);
        assert_eq!(canvas.progress(), (u64::from((last - 1) / 1024), 768));
        canvas.look_partly(|picture| {
            let first = (last > 1024).then_some(RED);
            assert_eq!((picture.get([0, 0]), picture.get([8, 8])), (first, None));
        });
    }
    let (interrupter, world, canvas) = interrupted_of(1024, 1);
    on_threads(1, || canvas.preview(&world, &|| false));
    assert_eq!(interrupter.rays.load(Relaxed), 1);
    canvas.look_partly(|picture| assert_eq!(picture.coarse([0, 0]), None));
}
