//! Changes of a scene that must not change any bit of its picture, or only a few.

use crate::prelude::*;

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
