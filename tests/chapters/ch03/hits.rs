//! What a ray hits: planes and spheres.

use testkit::properties::*;

use crate::prelude::*;

fn built(shape: impl Into<Kind>) -> Arc<dyn Shape> {
    shape.into().build(&mut Context::default()).expect("a valid shape")
}

fn sphere(center: Point, radius: f64) -> Arc<dyn Shape> {
    built(Sphere { center, radius, inward: false })
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the hit of a sphere is on it, at the distance t from the origin of a ray of unit direction; the
    /// normal is `(p − c)/r`. Oracle: distances.
    /// Book: rays and spheres.
    #[test]
    fn t_is_the_distance_to_a_point_of_the_sphere(
        o in point(20.0), aim in point(1.0), center in point(0.5), radius in 1.5..5.0_f64,
    ) {
        let aim = center + 0.8 * aim.to_vector();
        let Some(direction) = (aim - o).unit() else { return Ok(()) };
        let (shape, ray) = (sphere(center, radius), Ray::new(o, direction));
        // the aim is inside the sphere, so the ray hits it from wherever it comes
        let hit = shape.hit(&ray, Span::AHEAD).expect("it is aimed at");
        let surface = shape.surface(&ray, &hit);
        let tolerance = 64.0 * U * (20.0 + radius);
        near!(o.distance(surface.point), hit.t, 1e-9);
        near!(surface.point.distance(center), radius, tolerance);
        let outward = (surface.point - center) / radius;
        near!(Vector::from(surface.normal), outward, tolerance);
    }

    /// Law: from inside, the far root is hit, with the outward normal: `n·d > 0`; from outside the
    /// near one, `n·d < 0`, and with the sphere behind, none. Oracle: where the origin is.
    /// Book: rays and spheres.
    #[test]
    fn a_sphere_is_hit_from_inside_and_missed_behind(
        from in unit(), d in unit(), share in 0.0..0.99_f64, radius in 0.01..100.0_f64,
    ) {
        let shape = sphere(Point::ORIGIN, radius);
        let inside = Ray::new(Point::ORIGIN + share * radius * from, d.into());
        let hit = shape.hit(&inside, Span::AHEAD).expect("there is no way out");
        above!(shape.surface(&inside, &hit).normal.dot(d), 0.0);
        prop_assert_eq!(shape.roots(&inside, Span::AHEAD).len(), 1);
        prop_assert_eq!(shape.roots(&inside, Span::LINE).len(), 2);

        let outside = Point::ORIGIN + (1.01 + share) * radius * from;
        let towards = Ray::new(outside, -Vector::from(from));
        let hit = shape.hit(&towards, Span::AHEAD).expect("it is ahead");
        near!(hit.t, (0.01 + share) * radius, 1e-12 * radius);
        below!(shape.surface(&towards, &hit).normal.dot(towards.direction), 0.0);
        prop_assert_eq!(shape.hit(&Ray::new(outside, from.into()), Span::AHEAD), None);
    }

    /// Law: a tangent touches at the distance `√(|o − c|² − r²)`. Oracle: the right triangle, for a
    /// ray a billionth of the radius nearer to the centre, whose two hits lie around that point.
    /// Book: question 3.1, rays that touch a sphere.
    #[test]
    fn a_tangent_touches_where_the_right_triangle_says(
        n in unit(), radius in 0.1..10.0_f64, away in 0.1..50.0_f64,
    ) {
        let frame = groundtruth::math::Frame::around(n);
        let o = Point::ORIGIN + radius * (1.0 - 1e-9) * frame.u + away * frame.v;
        let ray = Ray::new(o, -frame.v);
        let roots = sphere(Point::ORIGIN, radius).roots(&ray, Span::LINE);
        let touches = (o.distance_squared(Point::ORIGIN) - radius * radius).sqrt();
        prop_assert_eq!(roots.len(), 2);
        // half the chord is r √2e-9
        let chord = radius * (3e-9_f64).sqrt();
        roots.iter().for_each(|hit| near!(hit.t, touches, chord + chord * chord / away));
        let past = Point::ORIGIN + radius * (1.0 + 1e-9) * frame.u + away * frame.v;
        prop_assert_eq!(
            sphere(Point::ORIGIN, radius).hit(&Ray::new(past, -frame.v), Span::LINE),
            None
        );
    }

    /// Law: twice the direction is half the t, to the bit, for plane and sphere alike.
    /// Book: rays: p = o + t d.
    #[test]
    fn t_is_in_units_of_the_direction(o in point(3.0), d in unit(), n in unit(), c in point(2.0)) {
        let shapes =
            [sphere(c, 1.0), built(Plane { point: c, normal: n.into() })];
        for shape in shapes {
            let t = shape.hit(&Ray::new(o, d.into()), Span::LINE).map(|hit| hit.t);
            let half = shape.hit(&Ray::new(o, 2.0 * d), Span::LINE).map(|hit| 2.0 * hit.t);
            prop_assert_eq!(t, half);
        }
    }

    /// Law: the hit of a plane satisfies its equation, and is ahead exactly if the ray goes to the
    /// other side. Oracle: `(p − a)·n = 0`, and the signs of `(o − a)·n` and `d·n`.
    /// Book: rays and planes.
    #[test]
    fn a_plane_is_hit_where_its_equation_holds(
        o in point(10.0), a in point(10.0), n in unit(), d in unit(),
    ) {
        let (height, slope) = ((o - a).dot(n), d.dot(n));
        prop_assume!(slope.abs() > 1e-6 && height.abs() > 1e-9);
        let (plane, ray) = (built(Plane { point: a, normal: 7.0 * n }), Ray::new(o, d.into()));
        let hit = plane.hit(&ray, Span::AHEAD);
        prop_assert_eq!(hit.is_some(), height * slope < 0.0);
        if let Some(hit) = hit {
            let surface = plane.surface(&ray, &hit);
            let size = 20.0 + surface.point.to_vector().length();
            near!((surface.point - a).dot(n), 0.0, 16.0 * U * size);
            near!(surface.point, ray.at(hit.t), 16.0 * U * size / slope.abs());
            near!(surface.normal.dot(n), 1.0, 8.0 * U);
        }
    }

    /// Law: a ray parallel to a plane misses it, above, below, and in it (infinite t, and 0/0). Oracle:
    /// planes along the axes, whose products are exact.
    /// Book: rays and planes.
    #[test]
    fn a_ray_parallel_to_a_plane_misses(
        (x, z) in (-1.0..1.0_f64, -1.0..1.0_f64),
        height in prop_oneof![Just(0.0), -1e3..1e3_f64],
        o in point(5.0),
        zero in prop_oneof![Just(0.0), Just(-0.0)],
    ) {
        let plane = built(Plane { point: Point::new(0.0, o.y() + height, 0.0), normal: Vector::Y });
        let ray = Ray::new(o, Vector::new(x, zero, z));
        prop_assert_eq!(plane.hit(&ray, Span::AHEAD), None);
        prop_assert_eq!(plane.hit(&ray, Span::LINE), None);
        prop_assert_eq!(plane.shadow_hit(&ray, Span::LINE), None);
    }

    /// Law: a ray that starts on the plane misses it, and one that leaves a sphere's or plane's hit on the
    /// outer side does not hit it again. Oracle: there is nothing more to hit.
    /// Book: 3.4.1, epsilon: t > ε.
    #[test]
    fn a_ray_that_starts_on_a_surface_leaves_it(
        o in point(10.0), c in point(1.0), n in unit(), d in unit(), out in unit(),
    ) {
        let plane = built(Plane { point: Point::new(0.0, o.y(), 0.0), normal: Vector::Y });
        prop_assert_eq!(plane.hit(&Ray::new(o, d.into()), Span::AHEAD), None);
        for shape in [sphere(c, 1.0), built(Plane { point: c, normal: n.into() })] {
            let ray = Ray::new(o, (c - o).unit().unwrap_or(d.into()));
            let Some(hit) = shape.hit(&ray, Span::AHEAD) else { continue };
            let surface = shape.surface(&ray, &hit);
            let out = if surface.normal.dot(out) > 0.0 { out } else { -out };
            prop_assume!(surface.normal.dot(out) > 0.0);
            let leaving = Ray::new(surface.leave(out.into()), out.into());
            prop_assert_eq!(shape.hit(&leaving, Span::AHEAD), None);
        }
    }
}
