//! False colours and legends.

use groundtruth::film::Tone;
use groundtruth::math::power;
use groundtruth::rgb::Rgb;
use layers::{Colors, Layer, NOT_A_NUMBER, NOTHING};

use super::scenes::named;

/// The relative luminance of a screen colour (sRGB primaries, linear by a power of 2.2).
fn luminance(color: [u8; 3]) -> f64 {
    let linear = color.map(|byte| power(f64::from(byte) / 255.0, 2.2));
    0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
}

/// Law: on both kinds of ramp a larger value is lighter, the ends of the legend are the least and the largest value, and
/// its middle is their mean, on a logarithmic scale the geometric one. Oracle: luminance, and means by hand.
#[test]
fn a_ramp_grows_lighter() {
    let (_, world) = named("ch14/page-one", 8, 1);
    for (name, middle) in [("distance", "4.25 length"), ("error", "2 radiance")] {
        let layer = Layer::named(name, &world).expect("a layer");
        let values: Vec<Rgb> =
            (0..=60).map(|i| Rgb::grey(0.5 + 7.5 * f64::from(i) / 60.0)).collect();
        let colors = Colors::of(&layer, values.iter().copied(), &world, Tone::PLAIN);
        let shown: Vec<f64> =
            values.iter().map(|&value| luminance(colors.color(Some(value)))).collect();
        assert!(shown.windows(2).all(|pair| pair[0] < pair[1]), "{name}: {shown:?}");
        let legend = colors.legend(&layer, values.iter().map(|&value| Some(value)));
        let texts: Vec<&str> = legend.iter().map(|row| row.text.as_str()).collect();
        let unit = layer.kind().unit;
        assert_eq!(texts[0], format!("8 {unit}"));
        assert_eq!(texts[2], middle);
        assert_eq!(texts[4], format!("0.5 {unit}"));
        assert_eq!(legend[0].color, colors.color(Some(Rgb::grey(8.0))));
        assert_eq!(colors.color(None), NOTHING);
        assert_eq!(colors.color(Some(Rgb::grey(f64::NAN))), NOT_A_NUMBER);
    }
}

/// Law: an object keeps its colour when others are there and when its index is another; the legend has the objects that
/// are seen, the most frequent first. Oracle: two scenes with one object of the same name.
#[test]
fn an_object_keeps_its_colour() {
    let (mut scene, world) = named("ch14/page-one", 8, 1);
    scene.objects.reverse();
    let turned = groundtruth::world::World::build(&scene).expect("valid");
    let layer = Layer::named("object", &world).expect("a layer");
    let last = world.names.objects.len() - 1;
    let values = [Some(Rgb::grey(1.0)), None, Some(Rgb::grey(0.0)), Some(Rgb::grey(1.0))];
    let color = |world, index: usize| {
        let colors = Colors::of(&layer, values.iter().flatten().copied(), world, Tone::PLAIN);
        colors.color(Some(Rgb::grey(index as f64)))
    };
    let mut seen = Vec::new();
    for index in 0..=last {
        assert_eq!(color(&world, index), color(&turned, last - index));
        seen.push(color(&world, index));
    }
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), last + 1, "two objects of one colour");
    let colors = Colors::of(&layer, values.iter().flatten().copied(), &world, Tone::PLAIN);
    let legend = colors.legend(&layer, values.iter().copied());
    let texts: Vec<&str> = legend.iter().map(|row| row.text.as_str()).collect();
    assert_eq!(texts, [&*world.names.objects[1], &*world.names.objects[0]]);
}
