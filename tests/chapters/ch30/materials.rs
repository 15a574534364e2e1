//! A material for each checker of a sphere, and errors.

use groundtruth::materials::{Kind as Recipe, SphereMaterials};
use groundtruth::textures::{
    DiskChecker, Lines, Ramp, SphereChecker, SphereTextures, Stripes, TextureInstance, Wireframe,
    Wrap,
};

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

fn problem_of(recipe: impl Into<Recipe>) -> String {
    let error = recipe.into().build(&mut Resources::default()).expect_err("refused");
    error.to_string()
}

/// Law: a material that can only belong to a whole surface is refused for a checker, and so is a list of the
/// wrong length; the error names the field and what is valid. Oracle: the texts.
#[test]
fn materials_that_belong_to_a_whole_surface_are_refused() {
    let of = |[num_horizontal, num_vertical]: [u32; 2], materials: Vec<Recipe>| SphereMaterials {
        num_horizontal,
        num_vertical,
        materials,
    };
    let glass = Transparent {
        phong: Phong::default(),
        kr: 0.1.into(),
        cr: Rgb::WHITE.into(),
        kt: 0.9.into(),
        eta: 1.5,
    };
    let water = Dielectric { inside: Medium::clear(1.33), ..Dielectric::default() };
    for clear in [Recipe::from(glass), water.into()] {
        let problem = problem_of(of([2, 1], vec![plain(ONE).into(), clear]));
        assert_eq!(
            problem,
            "sphere_materials.materials[1]: a transparent material cannot be that of one checker: the \
             media on both sides belong to the whole surface"
        );
    }
    let problem = problem_of(of([2, 1], vec![Emissive::new(1.0, ONE).into(), plain(ONE).into()]));
    assert_eq!(
        problem,
        "sphere_materials.materials[0]: an emissive material cannot be that of one checker: a lamp has \
         one emission; use `emissive` for the whole, with a `sphere_textures` as its `ce`"
    );
    assert_eq!(
        problem_of(of([2, 2], vec![plain(ONE).into(); 5])),
        "sphere_materials.materials: found 5, but from 1 to 4 fit, one for each checker"
    );
    assert_eq!(
        problem_of(of([2, 2], vec![])),
        "sphere_materials.materials: found 0, but from 1 to 4 fit, one for each checker"
    );
    assert_eq!(
        problem_of(of([2, 0], vec![plain(ONE).into()])),
        "sphere_materials.num_vertical: found 0, but at least 1 is needed"
    );
    let inner = Matte { kd: (-1.0).into(), ..plain(ONE) };
    assert_eq!(
        problem_of(of([2, 1], vec![inner.into()])),
        "sphere_materials.materials[0].matte.kd: found -1, but a finite number of at least 0 is needed"
    );
}

/// Law: invalid textures are refused; the error names the field and what is valid. Oracle: the texts.
#[test]
fn textures_that_cannot_be_are_refused() {
    let stripes = |size| Stripes { axis: Axis::X, size, color1: ONE.into(), color2: TWO.into() };
    let ramp = |from, to, colors: &[Rgb]| {
        let colors = colors.iter().map(|&color| color.into()).collect();
        Ramp { axis: Axis::X, from, to, colors, wrap: Wrap::Clamp }
    };
    let lines = |horizontal, vertical| Lines { horizontal, vertical, color: LINE.into() };
    let sphere = SphereChecker::default;
    let flat = Step::Scale(Vector::new(1.0, 0.0, 1.0));
    let cases: Vec<(Texture, &str)> = vec![
        (stripes(0.0).into(), "stripes.size: found 0, but a positive, finite number is needed"),
        (
            ramp(1.0, 1.0, &[ONE, TWO]).into(),
            "ramp.to: found 0 between `from` and it, but only lengths from 1e-40 to 1e40 are supported",
        ),
        (
            ramp(f64::NAN, 1.0, &[ONE, TWO]).into(),
            "ramp.from: found NaN, but a finite number is needed",
        ),
        (ramp(0.0, 1.0, &[ONE]).into(), "ramp.colors: found 1, but at least 2 are needed"),
        (
            ramp(0.0, 1.0, &[ONE, Rgb::grey(-1.0)]).into(),
            "ramp.colors[1]: found [-1.0, -1.0, -1.0], but a colour of finite numbers of at least 0 is needed",
        ),
        (
            SphereTextures {
                num_horizontal: 2,
                num_vertical: 1,
                textures: vec![ONE.into(), Paint::from(Texture::from(stripes(0.0)))],
                lines: Lines::default(),
            }
            .into(),
            "sphere_textures.textures[1].stripes.size: found 0, but a positive, finite number is needed",
        ),
        (
            SphereChecker { num_horizontal: 0, ..sphere() }.into(),
            "sphere_checker.num_horizontal: found 0, but at least 1 is needed",
        ),
        (
            SphereChecker { lines: lines(1.5, 0.0), ..sphere() }.into(),
            "sphere_checker.lines.horizontal: found 1.5, but 0 to 1 fit",
        ),
        (
            SphereChecker { lines: lines(0.5, -0.5), ..sphere() }.into(),
            "sphere_checker.lines.vertical: found -0.5, but 0 to 1 fit",
        ),
        (
            DiskChecker { num_radial: 0, ..DiskChecker::default() }.into(),
            "disk_checker.num_radial: found 0, but at least 1 is needed",
        ),
        (
            DiskChecker { unit: 0.0, ..DiskChecker::default() }.into(),
            "disk_checker.unit: found 0, but a positive, finite number is needed",
        ),
        (
            SphereTextures {
                num_horizontal: 1,
                num_vertical: 1,
                textures: vec![ONE.into(), TWO.into()],
                lines: Lines::default(),
            }
            .into(),
            "sphere_textures.textures: found 2, but from 1 to 1 fit, one for each checker",
        ),
        (
            Wireframe { line_width: -1.0, line_color: LINE.into(), color: ONE.into() }.into(),
            "wireframe.line_width: found -1, but a finite number of at least 0 is needed",
        ),
        (
            TextureInstance::new(stripes(1.0), vec![flat]).into(),
            "texture_instance.transform: the transformation is singular (condition number inf; at most \
             1e12 fits)",
        ),
        (
            TextureInstance::new(TextureInstance::new(stripes(-1.0), vec![]), vec![]).into(),
            "texture_instance.of.texture_instance.of.stripes.size: found -1, but a positive, finite \
             number is needed",
        ),
    ];
    for (texture, expected) in cases {
        let error = texture.build(&mut Resources::default()).expect_err("refused");
        assert_eq!(error.to_string(), expected);
    }
}

/// Law: scaled by a power of two, a sphere of materials responds at scaled points as the original does at the
/// original points: the textures of its materials are scaled with it. Oracle: the original response, bit for
/// bit.
#[test]
fn the_textures_of_materials_of_spheres_are_scaled() {
    let recipe =
        Recipe::from(SphereMaterials { num_horizontal: 5, num_vertical: 1, materials: opaque() });
    let response = |recipe: &Recipe, local: Point| {
        let material = recipe.build(&mut Resources::default()).expect("valid");
        let mut response = groundtruth::materials::Response::default();
        let surface = Surface::new(local, 0.0, Normal::Y);
        material.respond(&TexturePoint::new(&surface), 1.0, &mut response);
        response
    };
    let mut random = Pcg32::new(30, 7);
    for k in [1, -7, 30] {
        let larger = scaled(&recipe, power_of_two(k));
        for _ in 0..300 {
            let mut c = || 2.0 * random.uniform() - 1.0;
            let local = Point::new(c(), c(), c());
            let found = response(&larger, local.scaled(power_of_two(k)));
            assert_eq!(found, response(&recipe, local), "2^{k} at {local:?}");
        }
    }
}
