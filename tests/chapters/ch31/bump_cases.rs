//! Bumps by wireframes, and calls of the shape.

use groundtruth::bumps::{self, Height};
use groundtruth::textures::Wireframe;

use super::bumps::{apart, ball, bumped, met, white};
use crate::prelude::*;
use crate::support::asked::Counted;

/// Law: a wall along an edge, drawn by a wireframe, turns the normal of a lone triangle as that of a mesh, and as that of
/// one moved under a fixed texture. Oracle: the central difference across the wall's border, `h/2δ`, in closed form.
#[test]
fn a_wireframe_bumps_triangles_as_meshes() {
    let corners = [Point::ORIGIN, Point::new(9.0, 0.0, 0.0), Point::new(0.0, 9.0, 0.0)];
    let (width, height, step) = (0.5, 0.3, 0.125);
    let line_color = Rgb::WHITE.into();
    let wires = Wireframe { line_width: width, line_color, color: Rgb::BLACK.into() };
    let bump = Height { step, ..Height::new(wires, height) };
    let triangle = shapes::Kind::from(Triangle { vertices: corners, normals: None });
    let mesh = shapes::Kind::from(Mesh::of_lists(corners.to_vec(), vec![[0, 1, 2]]));
    let moved = |of: &shapes::Kind| {
        let steps = vec![Step::Translate(Vector::new(0.0, 0.0, 1.0))];
        shapes::Kind::from(Instance {
            transform_texture: false,
            ..Instance::new(of.clone(), steps)
        })
    };
    for shape in [moved(&triangle), moved(&mesh), triangle, mesh] {
        let world = built(&bumped(shape.clone(), bump.clone()));
        for (y, slope) in [(0.1, 0.0), (0.2, -1.0), (0.3, -1.0), (0.37, -1.0), (0.4, 0.0)] {
            let found = met(&world, Point::new(2.0, y, 5.0), -Vector::Z).expect("it is hit").1;
            let slope = slope * height / (2.0 * step);
            let expected = Vector::new(0.0, -slope, 1.0).unit().expect("not zero");
            let off = apart(found.shading, expected);
            assert!(off < 1e-12, "{shape:?} at {y}: {:?}, not {expected:?}", found.shading);
        }
    }
}

/// Law: a surface without a bump costs nothing: its shape is not asked for its texture space. With a bump it
/// is asked once for each hit.
#[test]
fn only_bumped_surfaces_ask_for_texture_space() {
    let counted = Counted::new(ball(1.0));
    let mut scene = stage(Rgb::WHITE);
    put(&mut scene, shapes::Kind::Custom(Custom(Arc::<Counted>::clone(&counted))), white());
    let looked = |scene: &Scene| {
        met(&built(scene), Point::new(0.0, 0.0, 5.0), -Vector::Z).expect("it is hit").1
    };
    let smooth = looked(&scene);
    assert_eq!((counted.asked(), smooth.shading), (0, smooth.geometry));
    scene.materials[0].bump =
        Some(bumps::Noise { noise: Noise::default(), size: 1.0, perturbation: 1.0 }.into());
    let rough = looked(&scene);
    assert_eq!(counted.asked(), 1);
    assert_ne!(rough.shading, rough.geometry);
}
