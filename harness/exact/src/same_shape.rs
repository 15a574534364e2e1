//! Our shapes and the oracle's: one table, read both ways.

use groundtruth::math::{Point, Step, Transform, Vector, atan2, to_degrees};
use groundtruth::shapes::{self, Instance, Kind, Materials};
use oracle::{Shape, Solid};

/// The two directions of a table. A row has a shape of the oracle and ours; the fields of both; after `;` those that
/// the oracle calls otherwise; after `|` those that only ours has. Shapes that differ by more are arms of their own.
macro_rules! same_shapes {
    (
        $(#[$of_ours:meta])* $seen:vis fn $to_ours:ident(&$theirs:ident);
        $(#[$of_theirs:meta])* $seen_too:vis fn $to_theirs:ident(&Kind);
        both ways { $($name:ident = $kind:ident {
            $($same:ident),* $(; $($their:ident = $our:ident),*)? $(| $($only:ident: $value:expr),*)?
        })* }
        to ours { $($arm_of_theirs:tt)* }
        to theirs { $($arm_of_ours:tt)* }
    ) => {
        $(#[$of_ours])*
        $seen fn $to_ours(exact: &$theirs) -> Option<Kind> {
            Some(match exact.clone() {
                $($theirs::$name { $($same,)* $($($their,)*)? } => Kind::from(shapes::$kind {
                    $($same: $same.into(),)* $($($our: $their.into(),)*)? $($($only: $value,)*)?
                }),)*
                $($arm_of_theirs)*
            })
        }

        $(#[$of_theirs])*
        $seen_too fn $to_theirs(kind: &Kind) -> Option<$theirs> {
            Some(match kind {
                $(Kind::$kind(it) => $theirs::$name {
                    $($same: it.$same.into(),)* $($($their: it.$our.into(),)*)?
                },)*
                $($arm_of_ours)*
            })
        }
    };
}

same_shapes! {
    /// The library's description of a shape; `None` if the library has no such shape. The matrix of an instance is the
    /// product of its [`steps`], the same up to rounding.
    pub fn our_shape(&Shape);
    /// The oracle's shape with the same data; `None` for kinds that the oracle does not have. Its normals point
    /// outward, whatever `inward` says.
    pub fn oracle_shape(&Kind);

    both ways {
        Plane = Plane { point, normal }
        Cuboid = Cuboid { min, max }
        Rectangle = Rectangle { corner, a, b }
        Disk = Disk { center, normal, radius }
        Annulus = Annulus { center, normal; inner = inner_radius, outer = outer_radius }
        CutFace = CutFace { size, radius }
        Sphere = Sphere { center, radius | inward: false }
        OpenCylinder = OpenCylinder { y0, y1, radius | inward: false }
        Cone = Cone { height, radius | inward: false }
        Paraboloid = Paraboloid { height, radius | inward: false }
        PartSphere = PartSphere { center, radius, phi, theta | inward: false }
        PartCylinder = PartCylinder { y0, y1, radius, phi | inward: false }
        Torus = Torus { swept_radius, tube_radius | inward: false }
        PartTorus = PartTorus { swept_radius, tube_radius, phi, theta | inward: false }
    }
    to ours {
        Shape::Triangle { vertices } => {
            shapes::Triangle { vertices: vertices.map(Point::from), normals: None }.into()
        }
        Shape::PartAnnulus { center, inner, outer, phi } => shapes::PartAnnulus {
            center: center.into(),
            normal: Vector::Y,
            inner_radius: inner,
            outer_radius: outer,
            phi,
        }
        .into(),
        Shape::Algebraic { terms, min, max } => {
            let term = |(coefficient, powers)| shapes::Term { coefficient, powers };
            let terms = terms.into_iter().map(term).collect();
            shapes::Algebraic { terms, min: min.into(), max: max.into() }.into()
        }
        Shape::Solid(of) => our_solid(&of)?,
        Shape::Instance { matrix, of } => {
            Instance::new(our_shape(&of)?, steps(&matrix)?).into()
        }
    }
    to theirs {
        Kind::Triangle(it) if it.normals.is_none() => {
            Shape::Triangle { vertices: it.vertices.map(Into::into) }
        }
        Kind::PartAnnulus(it) if it.normal == Vector::Y => Shape::PartAnnulus {
            center: it.center.into(),
            inner: it.inner_radius,
            outer: it.outer_radius,
            phi: it.phi,
        },
        Kind::Algebraic(it) => Shape::Algebraic {
            terms: it.terms.iter().map(|term| (term.coefficient, term.powers)).collect(),
            min: it.min.into(),
            max: it.max.into(),
        },
        Kind::Instance(it) => {
            let matrix = Transform::from_steps(&it.transform).ok()?.rows();
            Shape::Instance { matrix, of: Box::new(oracle_shape(&it.of)?) }
        }
        other => Shape::Solid(oracle_solid(other)?),
    }
}

same_shapes! {
    fn our_solid(&Solid);
    fn oracle_solid(&Kind);

    both ways {
        Cylinder = SolidCylinder { y0, y1, radius | materials: Materials::new() }
        Cone = SolidCone { height, radius | materials: Materials::new() }
        ThickRing = ThickRing {
            y0, y1; inner = inner_radius, outer = outer_radius | materials: Materials::new()
        }
        FlatRimmedBowl = FlatRimmedBowl {
            opening; inner = inner_radius, outer = outer_radius | materials: Materials::new()
        }
        RoundRimmedBowl = RoundRimmedBowl {
            opening; inner = inner_radius, outer = outer_radius | materials: Materials::new()
        }
        ConcaveLens = ConcaveLens { radius, thickness, min_distance | materials: Materials::new() }
        BeveledBox = BeveledBox { min, max, bevel | materials: Materials::new() }
        BeveledCylinder = BeveledCylinder { y0, y1, radius, bevel | materials: Materials::new() }
        BeveledRing = BeveledRing {
            y0, y1, bevel; inner = inner_radius, outer = outer_radius | materials: Materials::new()
        }
        BeveledWedge = BeveledWedge {
            y0, y1, phi, bevel; inner = inner_radius, outer = outer_radius | materials: Materials::new()
        }
    }
    to ours {}
    to theirs { _ => return None, }
}

/// Steps whose product is this matrix up to rounding: shear, scale, rotation and translation, by the
/// Gram–Schmidt process on the columns. `None` if the matrix is singular. (Does not find the axis of a half
/// turn.)
pub fn steps(matrix: &[[f64; 4]; 3]) -> Option<Vec<Step>> {
    let [c0, c1, c2, shift] =
        [0, 1, 2, 3].map(|j| Vector::new(matrix[0][j], matrix[1][j], matrix[2][j]));
    let x = c0.unit()?;
    let y = (c1 - c1.dot(x) * x).unit()?;
    let z = x.cross(y);
    let (sx, sy, sz) = (c0.dot(x), c1.dot(y), c2.dot(z));
    let shear = [c1.dot(x) / sx, c2.dot(x) / sx, 0.0, c2.dot(y) / sy, 0.0, 0.0];
    // the rotation with these columns: its axis from the skew part, its angle from the skew part and
    // the trace
    let axis = Vector::new(y.z() - z.y(), z.x() - x.z(), x.y() - y.x());
    let angle = atan2(axis.length(), x.x() + y.y() + z.z() - 1.0);
    let turn =
        Step::RotateAbout { point: Point::ORIGIN, direction: axis, degrees: to_degrees(angle) };
    let mut steps = vec![Step::Shear(shear), Step::Scale(Vector::new(sx, sy, sz))];
    if angle > 0.0 {
        steps.push(turn);
    }
    steps.push(Step::Translate(shift));
    Some(steps)
}
