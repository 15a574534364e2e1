//! False colours: the values of a layer on a screen, and the legend that says which is which.

use groundtruth::film::Tone;
use groundtruth::math::{ln, power};
use groundtruth::rgb::Rgb;
use groundtruth::world::World;

use crate::layer::Layer;

/// How the values of a layer become colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// As the picture is shown.
    Radiance,
    /// Unit vectors: −1 to 1 along x, y and z as red, green and blue.
    Directions,
    /// Texture coordinates: u as red, v as green, each without its whole part.
    Uv,
    /// Indices of objects or materials: a colour for each name.
    Names,
    /// From the least value to the largest.
    Linear,
    /// From the least positive value, or a millionth of the largest, to the largest: equal steps of colour are equal
    /// ratios.
    Logarithmic,
}

/// A colour of the screen.
pub type Color = [u8; 3];

/// Where nothing is hit.
pub const NOTHING: Color = [24, 24, 24];
/// What is not a number.
pub const NOT_A_NUMBER: Color = [255, 0, 255];

/// The colours of one layer: its scale, and the range that its values have.
#[derive(Clone, Debug, PartialEq)]
pub struct Colors {
    scale: Scale,
    /// Of ramps: the values of the first and of the last colour.
    range: [f64; 2],
    /// Of names: the colour of each index.
    of_names: Vec<(String, Color)>,
    tone: Tone,
}

/// A line of a legend.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LegendRow {
    /// Its colour.
    pub color: Color,
    /// What has it.
    pub text: String,
}

/// Viridis, at equal steps (van der Walt & Smith 2015, CC0): its lightness grows evenly, also in grey and for
/// colour-blind eyes.
const RAMP: [Color; 9] = [
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

/// The least value of a logarithmic scale, as a part of the largest.
const LEAST: f64 = 1e-6;

/// The names of a legend; others are counted.
const NAMED: usize = 12;

impl Colors {
    /// The colours of these values of a layer; radiance is shown in a tone.
    pub fn of(layer: &Layer, values: impl Iterator<Item = Rgb>, world: &World, tone: Tone) -> Self {
        let scale = layer.kind().scale;
        let names = layer.names(world).unwrap_or_default();
        let of_names = names.into_iter().map(|name| (name.to_owned(), color_of(name))).collect();
        let numbers = values.map(|value| number(layer, value)).filter(|value| value.is_finite());
        let floor = if scale == Scale::Logarithmic { 0.0 } else { f64::NEG_INFINITY };
        let ends = |[least, largest]: [f64; 2], value: f64| [least.min(value), largest.max(value)];
        let [least, largest] =
            numbers.filter(|value| *value > floor).fold([f64::INFINITY, f64::NEG_INFINITY], ends);
        let range = match scale {
            _ if least > largest => [0.0, 0.0],
            Scale::Logarithmic => [least.max(LEAST * largest), largest],
            _ => [least, largest],
        };
        Self { scale, range, of_names, tone }
    }

    /// The colour of a value; `None` is where nothing is hit.
    pub fn color(&self, value: Option<Rgb>) -> Color {
        let Some(value) = value else { return NOTHING };
        if value.to_array().iter().any(|channel| channel.is_nan()) {
            return NOT_A_NUMBER;
        }
        match self.scale {
            Scale::Radiance => self.tone.to_bytes(value),
            Scale::Directions => bytes(value.map(|x| 0.5 + 0.5 * x)),
            Scale::Uv => bytes(Rgb::new(fraction(value.r), fraction(value.g), 0.0)),
            Scale::Names => {
                self.of_names.get(value.r as usize).map_or(NOTHING, |(_, color)| *color)
            }
            Scale::Linear => ramp(self.share(value.average())),
            Scale::Logarithmic if value.average() <= 0.0 => [0, 0, 0],
            Scale::Logarithmic => ramp(self.share(value.average())),
        }
    }

    /// Where a number is between the ends of the range, from 0 to 1.
    fn share(&self, number: f64) -> f64 {
        let [least, largest] = self.range;
        let (number, least, largest) = match self.scale {
            Scale::Logarithmic => (ln(number), ln(least), ln(largest)),
            _ => (number, least, largest),
        };
        if largest > least { ((number - least) / (largest - least)).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// The legend: of a ramp five values, the largest first; of names those that `values` have, the most frequent first.
    pub fn legend(
        &self,
        layer: &Layer,
        values: impl Iterator<Item = Option<Rgb>>,
    ) -> Vec<LegendRow> {
        let row = |color: Color, text: &str| LegendRow { color, text: text.to_owned() };
        match self.scale {
            Scale::Radiance => Vec::new(),
            Scale::Directions => [
                (Rgb::new(1.0, 0.0, 0.0), "+x"),
                (Rgb::new(-1.0, 0.0, 0.0), "−x"),
                (Rgb::new(0.0, 1.0, 0.0), "+y"),
                (Rgb::new(0.0, -1.0, 0.0), "−y"),
                (Rgb::new(0.0, 0.0, 1.0), "+z"),
                (Rgb::new(0.0, 0.0, -1.0), "−z"),
            ]
            .map(|(direction, name)| row(self.color(Some(direction)), name))
            .to_vec(),
            Scale::Uv => {
                let at = |u, v| self.color(Some(Rgb::new(u, v, 0.0)));
                // 1 has no fraction
                let end = 1.0 - f64::EPSILON;
                let corners = [(0.0, 0.0), (end, 0.0), (0.0, end), (end, end)];
                let names = ["u 0, v 0", "u 1, v 0", "u 0, v 1", "u 1, v 1"];
                corners.iter().zip(names).map(|(&(u, v), name)| row(at(u, v), name)).collect()
            }
            Scale::Names => self.legend_of_names(values),
            Scale::Linear | Scale::Logarithmic => self.legend_of_ramp(layer),
        }
    }

    fn legend_of_ramp(&self, layer: &Layer) -> Vec<LegendRow> {
        let [least, largest] = self.range;
        let is_one = largest <= least;
        let shares: &[f64] = if is_one { &[0.0] } else { &[1.0, 0.75, 0.5, 0.25, 0.0] };
        let rows = shares.iter().map(|&share| {
            let value = match self.scale {
                Scale::Logarithmic => least * power(largest / least, share),
                _ => least + share * (largest - least),
            };
            let value = if is_one { least } else { value };
            let text = format!("{} {}", text::brief::brief(value), layer.kind().unit);
            LegendRow { color: ramp(share), text: text.trim_end().to_owned() }
        });
        rows.collect()
    }

    fn legend_of_names(&self, values: impl Iterator<Item = Option<Rgb>>) -> Vec<LegendRow> {
        let mut counts = vec![0_u64; self.of_names.len()];
        for value in values.flatten() {
            if let Some(count) = counts.get_mut(value.r as usize) {
                *count += 1;
            }
        }
        let mut seen: Vec<_> =
            counts.into_iter().zip(&self.of_names).filter(|it| it.0 > 0).collect();
        seen.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
        let others = seen.len().saturating_sub(NAMED);
        let row = |(_, (name, color)): (u64, &(String, Color))| LegendRow {
            color: *color,
            text: name.clone(),
        };
        let mut rows: Vec<_> = seen.into_iter().take(NAMED).map(row).collect();
        if others > 0 {
            rows.push(LegendRow { color: NOTHING, text: format!("and {others} more") });
        }
        rows
    }
}

/// The number that a ramp shows: of three channels, their mean.
fn number(layer: &Layer, value: Rgb) -> f64 {
    if layer.kind().channels.len() == 1 { value.r } else { value.average() }
}

fn fraction(x: f64) -> f64 {
    x - x.floor()
}

fn bytes(color: Rgb) -> Color {
    color.to_array().map(byte)
}

fn byte(value: f64) -> u8 {
    // the cast saturates
    (255.0 * value).round() as u8
}

/// The colour of the ramp at a share from 0 to 1.
fn ramp(share: f64) -> Color {
    let at = share * (RAMP.len() - 1) as f64;
    let below = (at as usize).min(RAMP.len() - 2);
    let between = at - below as f64;
    [0, 1, 2].map(|channel| {
        let [low, high] = [RAMP[below], RAMP[below + 1]].map(|color| f64::from(color[channel]));
        byte((low + between * (high - low)) / 255.0)
    })
}

/// The colour of a name: the same in every picture.
fn color_of(name: &str) -> Color {
    // FNV-1a of 64 bits (Fowler, Noll & Vo), mixed by the finaliser of MurmurHash3
    let mut hash = name.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    for factor in [0xff51_afd7_ed55_8ccd, 0xc4ce_b9fe_1a85_ec53] {
        hash = (hash ^ (hash >> 33)).wrapping_mul(factor);
    }
    hash ^= hash >> 33;
    let part = |shift: u32| ((hash >> shift) & 0xffff) as f64 / 65536.0;
    let (hue, saturation, value) = (6.0 * part(0), 0.45 + 0.45 * part(16), 0.65 + 0.35 * part(32));
    // from hue, saturation and value (Smith 1978)
    let channel = |offset: f64| {
        let k = (offset + hue) % 6.0;
        value * (1.0 - saturation * k.min(4.0 - k).clamp(0.0, 1.0))
    };
    [channel(5.0), channel(3.0), channel(1.0)].map(byte)
}
