//! A material for each checker of a sphere, and errors.

use groundtruth::materials::{Kind as Recipe, SphereMaterials};

use super::*;
use crate::prelude::*;
use crate::support::stage::recorded;

fn plain(cd: Rgb) -> Matte {
    Matte { ka: 0.5.into(), kd: 0.75.into(), cd: cd.into() }
}

/// Opaque materials of all kinds.
fn opaque() -> Vec<Recipe> {
    let phong = |cd: Rgb| Phong {
        ka: 0.25.into(),
        kd: 0.5.into(),
        cd: cd.into(),
        ks: 0.25.into(),
        exponent: 10.0.into(),
        ..Phong::default()
    };
    let mirror = Reflective { phong: phong(TWO), kr: 0.5.into(), cr: LINE.into() };
    let rule = GlossyRule::Book;
    let (kr, cr, exponent) = (0.5.into(), ONE.into(), 100.0.into());
    let glossy = GlossyReflector { phong: phong(LINE), kr, cr, exponent, rule };
    let textured = Matte { cd: Paint::from(solid(0.1)), ..plain(ONE) };
    vec![plain(ONE).into(), phong(ONE).into(), mirror.into(), glossy.into(), textured.into()]
}

/// A ball of this material, in ambient and direct light, in a coloured sky that mirrors see; turned and
/// scaled, so that only its local coordinates decide which checker is seen.
fn ball_of(recipe: Recipe, transform: &[Step]) -> Scene {
    let mut scene = deep_stage(Rgb::new(0.2, 0.4, 0.6), 2);
    let ball = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    put(&mut scene, Instance::new(ball, transform.to_vec()), recipe);
    shine(&mut scene, Ambient { ls: 1.0, color: Rgb::WHITE });
    let direction = Vector::new(1.0, 2.0, 3.0);
    shine(&mut scene, Directional { ls: 2.0, color: Rgb::new(1.0, 0.9, 0.8), direction });
    scene
}

proptest! {
    #![proptest_config(laws())]

    /// Law: where the checker in column i and row j is seen, a ball looks like one of that checker's material
    /// alone, which has number `j n_h + i`, modulo the length of the list; bit for bit, with lights, mirrors
    /// and textures, and on an instance. Oracle: the ball of that material.
    /// Book: exercise 30.4, textures and materials for each checker of a sphere.
    #[test]
    fn each_checker_of_a_sphere_has_its_material(
        (columns, rows) in (1..12_u32, 1..12_u32),
        length in 1..6_usize,
        (i, j) in (any::<prop::sample::Index>(), any::<prop::sample::Index>()),
        (s, t) in (0.01..0.99_f64, 0.01..0.99_f64),
    ) {
        let length = length.min((columns * rows) as usize);
        let materials = opaque()[..length].to_vec();
        let (i, j) = (i.index(columns as usize), j.index(rows as usize));
        let share = |i: usize, s: f64, n: u32| (i as f64 + s) / f64::from(n);
        let phi = std::f64::consts::TAU * share(i, s, columns);
        let theta = std::f64::consts::PI * share(j, t, rows);
        let way = Vector::new(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi));
        // the same turn by hand
        let transform = [Step::RotateY(-90.0), Step::Scale(Vector::new(2.0, 2.0, 2.0))];
        let outer = Vector::new(-way.z(), way.y(), way.x());
        let seen = |recipe: Recipe| {
            look(&built(&ball_of(recipe, &transform)), Point::ORIGIN + 5.0 * outer, -outer)
        };
        let expected = seen(materials[(j * columns as usize + i) % length].clone());
        let found =
            seen(SphereMaterials { num_horizontal: columns, num_vertical: rows, materials }.into());
        prop_assert!(
            found == expected,
            "column {i} of {columns}, row {j} of {rows}, {length} materials: {found:?}, expected {expected:?}"
        );
    }
}

/// Law: a sphere of materials may be nested in another, each with its own checkers. Oracle: the material that
/// both select.
#[test]
fn spheres_of_materials_may_be_nested() {
    let halves = |a: Recipe, b: Recipe| SphereMaterials {
        num_horizontal: 2,
        num_vertical: 1,
        materials: vec![a, b],
    };
    // north and south, each with an east and a west
    let north = halves(plain(ONE).into(), plain(TWO).into());
    let south = halves(plain(LINE).into(), plain(Rgb::WHITE).into());
    let materials = vec![north.into(), south.into()];
    let quarters = SphereMaterials { num_horizontal: 1, num_vertical: 2, materials };
    let world = built(&ball_of(quarters.into(), &[]));
    for (way, color) in [
        ([1.0, 0.5, 0.2], ONE),
        ([-1.0, 0.5, 0.2], TWO),
        ([1.0, -0.5, 0.2], LINE),
        ([-1.0, -0.5, 0.2], Rgb::WHITE),
    ] {
        let way = Vector::from(way);
        let found = look(&world, Point::ORIGIN + 5.0 * way, -way);
        let alone = built(&ball_of(plain(color).into(), &[]));
        assert_eq!(found, look(&alone, Point::ORIGIN + 5.0 * way, -way), "towards {way:?}");
    }
}

/// Law: for a sphere of materials the ray tree names only the textures of the checker that is hit, with the
/// material's index in the list. Oracle: three checkers around, by hand.
#[test]
fn the_tree_names_the_textures_of_the_checker_that_is_hit() {
    let textured = |size| Recipe::from(Matte { cd: Paint::from(solid(size)), ..plain(ONE) });
    let materials = vec![textured(0.1), plain(TWO).into(), textured(0.2)];
    let recipe = SphereMaterials { num_horizontal: 3, num_vertical: 1, materials };
    let world = built(&ball_of(recipe.into(), &[]));
    let fields = |phi: f64| -> Vec<String> {
        let out = Vector::new(sin(phi), 0.0, cos(phi));
        let tree = recorded(&world, Point::ORIGIN + 3.0 * out, -out);
        let hit = tree.root().hit.as_ref().expect("the ball is hit");
        hit.textures.iter().map(|texture| texture.field.clone()).collect()
    };
    // thirds of a turn, from +z towards +x
    assert_eq!(fields(1.0), ["materials[0].cd"]);
    assert_eq!(fields(3.0), [""; 0]);
    assert_eq!(fields(5.0), ["materials[2].cd"]);
}
