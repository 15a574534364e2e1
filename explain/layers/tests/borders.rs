//! False colours and legends, recomputed: ranges, steps, counts; and which layers a scene has.

use groundtruth::film::Tone;
use groundtruth::math::power;
use groundtruth::rgb::Rgb;
use groundtruth::world::World;
use layers::{Colors, Layer, NOT_A_NUMBER, NOTHING, Part};

use super::scenes::named;

/// Viridis at ninths of its range, as van der Walt and Smith published it (entries 0, 32, 64 … 255 of 256).
const VIRIDIS: [[u8; 3]; 9] = [
    [68, 1, 84],
    [71, 45, 123],
    [59, 82, 139],
    [44, 114, 142],
    [33, 145, 140],
    [40, 174, 128],
    [94, 201, 98],
    [173, 220, 48],
    [253, 231, 37],
];

fn layer(name: &str, world: &World) -> Layer {
    Layer::named(name, world).expect("a layer")
}

fn colors(layer: &Layer, values: &[Rgb], world: &World) -> Colors {
    Colors::of(layer, values.iter().copied(), world, Tone::PLAIN)
}

/// The rows of a legend: the number before the unit, and the colour.
fn rows(colors: &Colors, layer: &Layer, values: &[Rgb]) -> Vec<(f64, [u8; 3])> {
    let legend = colors.legend(layer, values.iter().map(|it| Some(*it)));
    let number = |text: &str| {
        let word = text.split(' ').next().unwrap_or_default();
        word.replace('−', "-").parse().unwrap_or(f64::NAN)
    };
    legend.iter().map(|row| (number(&row.text), row.color)).collect()
}

/// Law: the five rows of a ramp's legend are at quarters of the range, of a logarithmic one of the ratio; at eighths of it the
/// colours are those of the published map. Oracle: both formulas, and the table of the map.
#[test]
fn a_ramp_has_its_steps_and_its_colours() {
    let (_, world) = named("ch14/page-one", 8, 1);
    for (name, least, largest, is_log) in [
        ("distance", 2.0, 10.0, false),
        ("tree-depth", -8.0, 8.0, false),
        ("error", 0.25, 64.0, true),
    ] {
        let layer = layer(name, &world);
        let values = [Rgb::grey(least), Rgb::grey(largest)];
        let colors = colors(&layer, &values, &world);
        let at = |share: f64| match is_log {
            true => least * power(largest / least, share),
            false => least + share * (largest - least),
        };
        let found = rows(&colors, &layer, &values);
        assert_eq!(found.len(), 5, "rows of the legend of {name}");
        for (row, (found, color)) in found.into_iter().enumerate() {
            let share = 1.0 - 0.25 * row as f64;
            let off = (found - at(share)).abs();
            // two digits are shown
            assert!(
                off <= 0.051 * at(share).abs(),
                "row {row} of {name}: {found}, not {}",
                at(share)
            );
            assert_eq!(color, VIRIDIS[8 - 2 * row], "the colour of row {row} of {name}");
        }
        for (eighth, expected) in VIRIDIS.into_iter().enumerate() {
            // a rounding of the share moves no byte at a knot of the map by more than 1
            let found = colors.color(Some(Rgb::grey(at(eighth as f64 / 8.0))));
            let off = (0..3).map(|i| found[i].abs_diff(expected[i])).max();
            assert!(
                off <= Some(1),
                "the colour of {name} at {eighth}/8: {found:?}, not {expected:?}"
            );
        }
        assert_eq!(colors.color(None), NOTHING);
        assert_eq!(colors.color(Some(Rgb::grey(f64::NAN))), NOT_A_NUMBER);
        let middle = colors.color(Some(Rgb::grey(at(1.0 / 16.0))));
        let mean = |i: usize| (f64::from(VIRIDIS[0][i]) + f64::from(VIRIDIS[1][i])) / 2.0;
        let off = (0..3).map(|i| (f64::from(middle[i]) - mean(i)).abs()).fold(0.0, f64::max);
        assert!(off <= 1.0, "the colour of {name} at 1/16: {middle:?}, off by {off} from the mean");
    }
}

/// Law: a range has no value that is not finite; a logarithmic one begins at the least positive value, but not below a
/// millionth of the largest; of one value, or of none, the legend has one row. Oracle: lists by hand.
#[test]
fn a_range_is_that_of_the_values_that_count() {
    let (_, world) = named("ch14/page-one", 8, 1);
    let nan = f64::NAN;
    let inf = f64::INFINITY;
    for (name, values, expected) in [
        ("distance", &[3.0, nan, inf, -1.0, -inf][..], &[3.0, 2.0, 1.0, 0.0, -1.0][..]),
        ("error", &[0.0, 1.0, 16.0, -4.0, inf], &[16.0, 8.0, 4.0, 2.0, 1.0]),
        // the fourth root of a million is 31.62
        ("error", &[1e-9, 1.0], &[1.0, 0.03162, 0.001, 3.162e-5, 1e-6]),
        ("error", &[1.01e-6, 1.0], &[1.0, 0.0317, 0.001005, 3.186e-5, 1.01e-6]),
        ("distance", &[7.0, 7.0], &[7.0]),
        ("distance", &[], &[0.0]),
        ("error", &[0.0], &[0.0]),
    ] {
        let layer = layer(name, &world);
        let values: Vec<Rgb> = values.iter().map(|x| Rgb::grey(*x)).collect();
        let found = rows(&colors(&layer, &values, &world), &layer, &values);
        let found: Vec<f64> = found.into_iter().map(|row| row.0).collect();
        assert_eq!(found.len(), expected.len(), "rows of {name} for {values:?}: {found:?}");
        for (found, expected) in found.iter().zip(expected) {
            let off = (found - expected).abs();
            // two digits are shown
            assert!(off <= 0.051 * expected.abs(), "a row of {name} is {found}, not {expected}");
        }
    }
}

/// A world with so many balls beside each other.
fn balls(count: usize) -> World {
    let mut text = "image = { width = 4, height = 4 }\n\
                    camera = { eye = [0, 0, 9], lens.orthographic = {} }\n\
                    [[materials]]\nname = \"white\"\nrecipe.matte = { cd = 1 }\n"
        .to_owned();
    for index in 0..count {
        text += &format!(
            "[[objects]]\nname = \"ball {index}\"\nmaterial = \"white\"\n\
             shape.sphere = {{ center = [{index}, 0, 0], radius = 0.25 }}\n"
        );
    }
    scenefile::from_toml(&text, std::path::Path::new("here.toml")).expect("valid").1
}

/// Law: the legend of names has the twelve most frequent, those that are as frequent in the order of the scene, and says how
/// many more there are. Oracle: counts by hand.
#[test]
fn a_legend_of_names_has_twelve_and_counts_the_others() {
    for seen in [0, 1, 11, 12, 13, 15] {
        let world = balls(16);
        let layer = layer("object", &world);
        // ball 3 three times, ball 2 and 1 twice, the others once
        let times = |index: usize| [1, 2, 2, 3].get(index).copied().unwrap_or(1);
        let values: Vec<Rgb> = (0..seen)
            .flat_map(|index| std::iter::repeat_n(Rgb::grey(index as f64), times(index)))
            .collect();
        let colors = colors(&layer, &values, &world);
        let found = colors.legend(&layer, values.iter().map(|it| Some(*it)).chain([None]));
        let mut order: Vec<usize> = (0..seen).collect();
        order.sort_by_key(|index| std::cmp::Reverse(times(*index)));
        let mut expected: Vec<String> =
            order.iter().take(12).map(|index| format!("ball {index}")).collect();
        if seen > 12 {
            expected.push(format!("and {} more", seen - 12));
        }
        let texts: Vec<&str> = found.iter().map(|row| row.text.as_str()).collect();
        assert_eq!(texts, expected, "the legend of {seen} objects");
        for (row, index) in found.iter().zip(order.iter().take(12)) {
            let color = colors.color(Some(Rgb::grey(*index as f64)));
            assert_eq!(row.color, color, "the colour of {}", row.text);
        }
        assert!(seen <= 12 || found[12].color == NOTHING, "the colour of the others: {found:?}");
    }
}

/// Law: the colours of directions and of texture coordinates are their formulas: (1 + x)/2, and the fraction. Oracle: these.
#[test]
fn directions_and_coordinates_have_their_colours() {
    let (_, world) = named("ch14/page-one", 8, 1);
    let byte = |x: f64| (255.0 * x).round() as u8;
    for [x, y, z] in [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.6, -0.8, 0.0], [0.0, 0.28, -0.96]] {
        let layer = layer("normal", &world);
        let found = colors(&layer, &[], &world).color(Some(Rgb::new(x, y, z)));
        let expected = [x, y, z].map(|x| byte(0.5 * (1.0 + x)));
        assert_eq!(found, expected, "the colour of the normal ({x}, {y}, {z})");
    }
    for [u, v] in [[0.0, 0.5], [0.25, 1.75], [-0.25, 2.0]] {
        let layer = layer("uv", &world);
        let found = colors(&layer, &[], &world).color(Some(Rgb::new(u, v, 0.0)));
        let expected = [byte(u - u.floor()), byte(v - v.floor()), 0];
        assert_eq!(found, expected, "the colour of u = {u}, v = {v}");
    }
}

/// Law: a scene has one layer of each kind without a part, one of each light that is on, and depths from 0 to the
/// largest of the tracer, at most 9. Oracle: the scene.
#[test]
fn a_scene_has_layers_of_its_lights_and_depths() {
    for (max_depth, depths) in [(0, 1), (1, 2), (8, 9), (9, 10), (10, 10), (30, 10)] {
        let (mut scene, _) = named("ch24/hall-of-mirrors", 8, 1);
        *scene.tracer.max_depth().expect("it has one") = max_depth;
        scene.lights[0].enabled = false;
        let on = scene.lights.iter().filter(|light| light.enabled).count();
        let world = World::build(&scene).expect("valid");
        let found = Layer::of_scene(&world);
        let count = |is: fn(&Part) -> bool| found.iter().filter(|it| is(it.part())).count();
        let numbers: Vec<u32> = found
            .iter()
            .filter_map(|it| if let Part::Depth(depth) = it.part() { Some(*depth) } else { None })
            .collect();
        let expected: Vec<u32> = (0..depths).collect();
        assert_eq!(numbers, expected, "depths of a tracer of at most {max_depth}");
        assert_eq!(count(|part| matches!(part, Part::Light(..))), on, "lights that are on");
        let plain = layers::KINDS.iter().filter(|kind| kind.argument.is_none()).count();
        assert_eq!(count(|part| *part == Part::Only), plain, "layers without a part");
        let deepest = Layer::named(&format!("depth:{max_depth}"), &world);
        assert!(deepest.is_ok(), "the deepest layer: {deepest:?}");
        let deeper = Layer::named(&format!("depth:{}", max_depth + 1), &world);
        assert!(deeper.is_err(), "a layer beyond the deepest: {deeper:?}");
    }
}

/// Law: an object keeps its colour when others are there and when its index is another. Oracle: two scenes with one object of the same name.
#[test]
fn an_object_keeps_its_colour() {
    let (mut scene, world) = named("ch14/page-one", 8, 1);
    scene.objects.reverse();
    let turned = World::build(&scene).expect("valid");
    let layer = layer("object", &world);
    let last = world.names.objects.len() - 1;
    let color = |world, index: usize| {
        colors(&layer, &[Rgb::WHITE, Rgb::BLACK], world).color(Some(Rgb::grey(index as f64)))
    };
    let mut seen = Vec::new();
    for index in 0..=last {
        assert_eq!(color(&world, index), color(&turned, last - index));
        seen.push(color(&world, index));
    }
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), last + 1, "two objects of one colour");
}
