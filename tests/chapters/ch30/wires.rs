//! Wireframes: lines along the edges of triangles.

use groundtruth::textures::{TextureInstance, Wireframe};

use super::*;
use crate::prelude::*;

fn wires(line_width: f64) -> Texture {
    Wireframe { line_width, line_color: LINE.into(), color: ONE.into() }.into()
}

/// Corners of a triangle that is not a needle, as seen along the z axis.
fn corners() -> impl Strategy<Value = [Point; 3]> {
    (point(1.0), point(1.0), point(1.0)).prop_map(|(a, b, c)| [a, b, c]).prop_filter(
        "no needle, not seen from the side",
        |[a, b, c]| {
            let normal = (*b - *a).cross(*c - *a);
            normal.z().abs() > 0.2
        },
    )
}

/// The distance from the nearest edge: the least distance to a point of each edge, by ternary search.
fn from_edges(p: Point, [a, b, c]: [Point; 3]) -> f64 {
    let from_edge = |a: Point, b: Point| {
        let (mut low, mut high) = (0.0, 1.0);
        let distance = |s: f64| p.distance(a + s * (b - a));
        for _ in 0..200 {
            let third = (high - low) / 3.0;
            let [one, two] = [low + third, high - third];
            if distance(one) < distance(two) { high = two } else { low = one }
        }
        distance(0.5 * (low + high))
    };
    from_edge(a, b).min(from_edge(b, c)).min(from_edge(c, a))
}

fn mesh([a, b, c]: [Point; 3]) -> Mesh {
    // another triangle, elsewhere, comes first
    let far = a + 10.0 * Vector::Y;
    let vertices = vec![far, far + Vector::X, far + 5.0 * Vector::Y, a, b, c];
    Mesh::of_lists(vertices, vec![[0, 1, 2], [3, 4, 5]])
}

/// The colour seen at a point of the scene's surfaces, from the front (+z).
fn seen(shape: impl Into<Kind>, texture: &Texture, p: Point) -> Rgb {
    let mut scene = gallery();
    painted(&mut scene, shape, texture.clone());
    let eye = p.with(2, 50.0);
    look(&built(&scene), eye, p - eye)
}

/// A ternary search finds the least distance up to the square root of a rounding.
const SEARCHED: f64 = 1e-6;

proptest! {
    #![proptest_config(laws())]

    /// Law: a point of a triangle is on a line if it is closer than half the width to an edge; for a triangle,
    /// a mesh, and inside compounds and lattices. In an instance the lines stretch with the mesh. Oracle:
    /// the least distance, searched along each edge.
    #[test]
    fn lines_are_half_a_width_on_either_side_of_the_edges(
        corners in corners(),
        (u, v) in (0.01..0.99_f64, 0.01..0.99_f64),
        width in 0.01..0.5_f64,
    ) {
        let [a, b, c] = corners;
        let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
        prop_assume!(u.min(v).min(1.0 - u - v) > 1e-6);
        let p = a + u * (b - a) + v * (c - a);
        let distance = from_edges(p, corners);
        prop_assume!((distance - 0.5 * width).abs() > SEARCHED);
        let expected = if distance < 0.5 * width { LINE } else { ONE };
        let texture = wires(width);
        let far = 40.0 * Vector::X;
        let plain = Kind::from(mesh(corners));
        let ball = || Kind::from(Sphere { center: p + 0.5 * far, radius: 1.0, inward: false });
        let with_ball = Kind::from(Compound::of([ball(), plain.clone()]));
        let row = Lattice {
            of: Box::new(with_ball.clone()),
            counts: [3, 1, 1],
            spacing: far,
            accel: None,
        };
        let stretch = vec![Step::Scale(Vector::new(0.5, 3.0, 2.0)), Step::Translate(far)];
        let stretched = Point::new(40.0 + 0.5 * p.x(), 3.0 * p.y(), 2.0 * p.z());
        let shapes: [(Kind, Point); 5] = [
            (Triangle { vertices: corners, normals: None }.into(), p),
            (plain.clone(), p),
            (row.into(), p + 2.0 * far),
            (with_ball, p),
            (Instance::new(plain, stretch).into(), stretched),
        ];
        for (shape, p) in shapes {
            let found = seen(shape.clone(), &texture, p);
            prop_assert!(
                found == expected,
                "{distance} from the edges, width {width}: {found:?}, expected {expected:?}, on {shape:?}"
            );
        }
    }
}

/// Law: a shape without triangles has the colour between the lines; on a shape with triangles, an instance of
/// the texture does not move the lines. Oracle: that colour; the picture without the instance.
#[test]
fn wires_belong_to_the_triangles() {
    let mut random = Pcg32::new(30, 4);
    let steps = vec![Step::Scale(Vector::new(3.0, 3.0, 3.0)), Step::Translate(Vector::X)];
    let moved = Texture::from(TextureInstance::new(wires(0.1), steps));
    let mesh = TessellatedSphere::new(9, 7, true);
    let ball = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    let mut lines = 0;
    for _ in 0..500 {
        let mut c = || 1.2 * random.uniform() - 0.6;
        let p = Point::new(c(), c(), 0.0);
        assert_eq!(seen(ball.clone(), &wires(0.1), p), ONE, "a sphere has no wires at {p:?}");
        let plain = seen(mesh.clone(), &wires(0.1), p);
        assert_eq!(seen(mesh.clone(), &moved, p), plain, "at {p:?}");
        lines += u32::from(plain == LINE);
    }
    assert!((50..450).contains(&lines), "{lines} of 500 points on lines");
}
