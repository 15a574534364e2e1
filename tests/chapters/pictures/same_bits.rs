//! Changes of a scene that must not change any bit of its picture, or only a few.

use groundtruth::scene::to_toml;
use groundtruth::world::from_toml;

use super::studio::{assert_same_bits, built, gallery_in_small, pixels, small};
use crate::prelude::*;
use testkit::scaling::scaled_scene;

/// Law: no absolute length matters: every scene gives the same picture with all lengths multiplied by a power
/// of two. An absolute epsilon anywhere would break this. Oracle: the scene as it is.
#[test]
fn scaling_by_powers_of_two_changes_no_picture() {
    for (name, scene) in gallery_in_small(1) {
        let original = render::render(&built(&scene));
        for &k in as_many(&[-30, 5][..], &[-30, -3, 5, 30]) {
            let scaled = render::render(&built(&scaled_scene(&scene, k)));
            assert_same_bits(&format!("{name} times 2^{k}"), &scaled, &original);
        }
    }
}

/// Law: grid and bvh give the picture of the list. Oracle: the list.
#[test]
fn list_grid_and_bvh_give_the_same_picture() {
    for (name, mut scene) in gallery_in_small(2) {
        scene.accel = Method::List;
        let list = render::render(&built(&scene));
        for method in [Method::Grid, Method::Bvh] {
            scene.accel = method;
            let picture = render::render(&built(&scene));
            assert_same_bits(&format!("{name}, {method:?}"), &picture, &list);
        }
    }
}

/// Law: exported and read again, a scene renders the same bits, and exports to the same text.
#[test]
fn export_and_reread_gives_the_same_picture() {
    for (name, scene) in gallery_in_small(2) {
        let text = to_toml(&scene).expect("gallery scenes are plain data");
        let (reread, world) = from_toml(&text, Path::new("scene.toml")).expect("it reads back");
        assert_same_bits(name, &render::render(&world), &render::render(&built(&scene)));
        assert_eq!(to_toml(&reread).expect("plain data"), text, "{name}");
    }
}

/// Law: where no two objects are hit at the same distance, their order does not matter; the order of
/// materials never does. Oracle: the scene as it is. (The order of lights is the order of a sum, which
/// rounds.)
#[test]
fn the_order_of_objects_does_not_matter() {
    for name in
        ["ch03/three-objects", "ch14/page-one", "ch16/coloured-shadows", "ch28/glass-sphere"]
    {
        let mut scene = small(name, 32, 32, 2);
        let original = render::render(&built(&scene));
        for _ in 0..2 {
            scene.objects.rotate_left(1);
            scene.materials.reverse();
            assert_same_bits(name, &render::render(&built(&scene)), &original);
        }
        scene.objects.reverse();
        assert_same_bits(name, &render::render(&built(&scene)), &original);
    }
}

/// Law: an object that is switched off has no effect. Oracle: the scene without it.
#[test]
fn what_is_switched_off_is_not_there() {
    let scene = small("ch14/page-one", 32, 32, 1);
    for i in [0, 8, 34] {
        let (mut off, mut without) = (scene.clone(), scene.clone());
        off.objects[i].enabled = false;
        without.objects.remove(i);
        let off = render::render(&built(&off));
        assert_same_bits("switched off", &off, &render::render(&built(&without)));
    }
}

/// Moves a scene as a whole, without its infinite lights: objects by an instance, the eye by hand.
fn moved(scene: &Scene, transform: &[Step], eye: impl Fn(Point) -> Point) -> Scene {
    let mut moved = scene.clone();
    for object in &mut moved.objects {
        let of = Box::new(object.shape.clone());
        let transform = transform.to_vec();
        object.shape = shapes::Kind::from(Instance::new(*of, transform));
    }
    moved.camera.eye = eye(moved.camera.eye);
    moved.camera.look_at = eye(moved.camera.look_at);
    moved.camera.up = eye(Point::ORIGIN + moved.camera.up) - eye(Point::ORIGIN);
    for light in &mut moved.lights {
        if let groundtruth::lights::Kind::PointLight(point) = &mut light.source {
            point.location = eye(point.location);
        }
        if let groundtruth::lights::Kind::Directional(sun) = &mut light.source {
            sun.direction = eye(Point::ORIGIN + sun.direction) - eye(Point::ORIGIN);
        }
    }
    moved
}

/// Law: moving and turning camera, lights and objects together does not change the picture. Oracle: the scene
/// as it is. Points differ by rounding, and so pixels may differ by 1e-9; a few pixels may differ by any
/// amount, where a rounded ray just misses an edge.
#[test]
fn camera_and_scene_moved_together_show_the_same() {
    let shift = Vector::new(3.0, -7.0, 11.0);
    let turn = |p: Point| Point::new(p.z(), p.y(), -p.x()) + shift; // 90° about y, z to x
    let steps = [Step::RotateY(90.0), Step::Translate(shift)];
    for name in ["ch14/page-one", "ch16/coloured-shadows", "ch24/reflective-set", "ch27/common-set"]
    {
        let scene = small(name, 40, 40, 1);
        let original = render::render(&built(&scene));
        let moved = render::render(&built(&moved(&scene, &steps, turn)));
        let differ = pixels(40, 40)
            .filter(|&at| {
                let (a, b) = (original.get(at).to_array(), moved.get(at).to_array());
                (0..3).any(|i| (a[i] - b[i]).abs() > 1e-9)
            })
            .count();
        // solid textures and planes' checkers have cell borders at integers
        assert!(differ <= 8, "{name}: {differ} of 1600 pixels differ");
    }
}

/// Law: resizing keeps the view: the picture with half as many pixels, four regular samples each, is
/// that of the full size with one, averaged over 2 × 2. Oracle: the average, which rounds.
#[test]
fn resizing_keeps_the_view() {
    let mut fine = small("ch24/reflective-set", 48, 32, 1);
    let mut coarse: Scene = fine.clone();
    fine.image.sampler = Some(groundtruth::samplers::Regular {}.into());
    coarse.image = Image { samples: 4, ..fine.image.clone() };
    coarse.image.resize(24, 16);
    let [fine, coarse] = [fine, coarse].map(|scene| render::render(&built(&scene)));
    for [x, y] in pixels(24, 16) {
        let four = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[i, j]| fine.get([2 * x + i, 2 * y + j]));
        let mean = render::mean(four.into_iter()).to_array();
        let pixel = coarse.get([x, y]).to_array();
        // the points on the view plane may differ in the last bit
        assert!((0..3).all(|i| (mean[i] - pixel[i]).abs() < 1e-9), "({x}, {y})");
    }
}
