//! Why a pixel has its colour: the ray tree in words and numbers, for people and for scripts.
//!
//! A [`RayExplanation`] is a [`RayTree`] with names in place of numbers, and what each ray adds to
//! its pixel. The command line prints it, the inspector shows it; neither computes anything.

use std::fmt::{self, Write as _};

use serde::Serialize;

use crate::render::{self, CameraSample};
use crate::rgb::Rgb;
use crate::scene::Scene;
use crate::trace::{RayKind, RayTree, RecordedOutcome, What};
use crate::world::World;

/// A pixel explained: its samples and the sum that it is.
#[derive(Clone, Debug, Serialize)]
pub struct PixelExplanation {
    /// x right and y down from the top left, from 0.
    pub pixel: [u32; 2],
    /// How many samples the pixel has.
    pub samples_per_pixel: u32,
    /// Multiplies the mean of the samples.
    pub exposure_time: f64,
    /// The explained samples: all of them, or those asked for.
    pub samples: Vec<SampleExplanation>,
    /// The pixel: the exposure time times the mean of all its samples.
    pub radiance: Rgb,
}

/// One sample explained.
#[derive(Clone, Debug, Serialize)]
pub struct SampleExplanation {
    /// Its index.
    pub index: u32,
    /// Where it is on the view plane, in world units from its centre; `None` in the gap of a stereo
    /// pair.
    pub film: Option<[f64; 2]>,
    /// Where it is on the lens, in the unit disk, if the camera has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lens: Option<[f64; 2]>,
    /// What the filter lets it count.
    pub weight: f64,
    /// What it adds to the mean.
    pub radiance: Rgb,
    /// Whether all its rays are shown; a tree of more than a million is cut off.
    pub complete: bool,
    /// The camera's ray and all that came of it; `None` where the camera sees nothing.
    pub ray: Option<RayExplanation>,
}

/// One ray explained.
#[derive(Clone, Debug, Serialize)]
pub struct RayExplanation {
    /// `camera`, `reflected`, `transmitted` or `shadow`.
    pub kind: &'static str,
    /// The light a shadow ray goes to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<String>,
    /// Edges before it; 0 for the camera's ray.
    pub depth: u32,
    /// Where it starts.
    pub origin: [f64; 3],
    /// Where it goes.
    pub direction: [f64; 3],
    /// What it counts for the ray before it.
    pub weight: Rgb,
    /// `hit`, `background`, `too deep`, `unblocked` or `blocked`.
    pub outcome: &'static str,
    /// What it hit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hit: Option<HitExplanation>,
    /// What stands in the way of a blocked shadow ray (there may be more).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blocked_by: Option<String>,
    /// What leaves the surface towards the ray's origin, term by term.
    pub terms: Vec<TermExplanation>,
    /// The share that the medium lets through.
    pub transmittance: Rgb,
    /// What arrives at its origin: the transmittance times the sum of the terms.
    pub radiance: Rgb,
    /// What it adds to its sample.
    pub contribution: Rgb,
    /// The rays it sent, in order.
    pub children: Vec<RayExplanation>,
}

/// What a ray hit.
#[derive(Clone, Debug, Serialize)]
pub struct HitExplanation {
    /// The object.
    pub object: String,
    /// Its material.
    pub material: String,
    /// Along the ray.
    pub t: f64,
    /// Where.
    pub point: [f64; 3],
    /// How far the point may be from the true surface.
    pub error: f64,
    /// The true normal.
    pub normal: [f64; 3],
    /// The normal used for shading.
    pub shading_normal: [f64; 3],
    /// Whether the ray met the side the normal points to.
    pub front: bool,
}

/// One term of what leaves a surface: `weight · light`.
#[derive(Clone, Debug, Serialize)]
pub struct TermExplanation {
    /// What it is, in words.
    pub what: String,
    /// What the light is multiplied by.
    pub weight: Rgb,
    /// What it adds.
    pub value: Rgb,
    /// Which of the ray's children it comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub child: Option<usize>,
}

/// Explains a pixel (x right, y down): one of its samples, or all.
pub fn pixel(scene: &Scene, world: &World, pixel: [u32; 2], only: Option<u32>) -> PixelExplanation {
    let count = world.samples_per_pixel();
    let samples = match only {
        Some(index) => vec![sample(scene, world, pixel, index)],
        None => (0..count).map(|index| sample(scene, world, pixel, index)).collect(),
    };
    let radiance = match only {
        Some(_) => render::pixel(world, pixel),
        None => render::expose(world, samples.iter().map(|sample| sample.radiance)),
    };
    PixelExplanation {
        pixel,
        samples_per_pixel: count,
        exposure_time: world.view.exposure_time,
        samples,
        radiance,
    }
}

/// Explains one sample of a pixel.
pub fn sample(scene: &Scene, world: &World, pixel: [u32; 2], index: u32) -> SampleExplanation {
    let mut tree = RayTree::default();
    let radiance = render::sample(world, pixel, index, &mut tree);
    let complete = tree.is_complete();
    let Some(CameraSample { film, lens, weight, ray, .. }) =
        render::camera_sample(world, pixel, index)
    else {
        let (film, lens, weight, ray) = (None, None, 0.0, None);
        return SampleExplanation { index, film, lens, weight, radiance, complete, ray };
    };
    let ray = ray.map(|_| explain(scene, &tree, 0, Rgb::grey(weight)));
    SampleExplanation { index, film: Some(film), lens, weight, radiance, complete, ray }
}

/// Explains a recorded tree.
pub fn ray(scene: &Scene, tree: &RayTree) -> RayExplanation {
    explain(scene, tree, 0, Rgb::WHITE)
}

/// `reaches` is the share of what arrives at the node's origin that reaches the eye.
fn explain(scene: &Scene, tree: &RayTree, at: usize, reaches: Rgb) -> RayExplanation {
    let node = &tree.nodes()[at];
    let (kind, light) = match node.kind {
        RayKind::Camera => ("camera", None),
        RayKind::Reflected => ("reflected", None),
        RayKind::Transmitted => ("transmitted", None),
        RayKind::Shadow { light } => ("shadow", Some(light_name(scene, light))),
    };
    let object = |place: u32| &scene.objects[place as usize];
    let (mut hit, mut blocked_by) = (None, None);
    let outcome = match &node.outcome {
        RecordedOutcome::Hit(recorded) => {
            let object = object(recorded.object);
            hit = Some(HitExplanation {
                object: object.name.clone(),
                material: scene.materials[recorded.material as usize].name.clone(),
                t: recorded.t,
                point: recorded.point.into(),
                error: recorded.error,
                normal: recorded.normal.into(),
                shading_normal: recorded.shading.into(),
                front: recorded.front,
            });
            "hit"
        }
        RecordedOutcome::Background => "background",
        RecordedOutcome::TooDeep => "too deep",
        RecordedOutcome::Unblocked => "unblocked",
        RecordedOutcome::Blocked { object: place } => {
            blocked_by = Some(object(*place).name.clone());
            "blocked"
        }
    };
    // a shadow ray serves every lobe that takes its light: their weights add up
    let weight_of = |child: usize| -> Rgb {
        let terms = node.terms.iter().filter(|recorded| recorded.child == Some(child));
        terms.map(|recorded| recorded.term.weight).sum()
    };
    let children = node
        .children
        .iter()
        .map(|&child| explain(scene, tree, child, reaches * node.transmittance * weight_of(child)));
    let terms = node.terms.iter().map(|recorded| TermExplanation {
        what: words(scene, recorded.term.what),
        weight: recorded.term.weight,
        value: recorded.term.value,
        child: recorded.child.and_then(|c| node.children.iter().position(|&other| other == c)),
    });
    RayExplanation {
        kind,
        light,
        depth: node.depth,
        origin: node.ray.origin.into(),
        direction: node.ray.direction.into(),
        weight: node.weight,
        outcome,
        hit,
        blocked_by,
        terms: terms.collect(),
        transmittance: node.transmittance,
        radiance: node.radiance,
        contribution: reaches * node.radiance,
        children: children.collect(),
    }
}

fn light_name(scene: &Scene, place: u32) -> String {
    scene.lights[place as usize].name.clone()
}

fn words(scene: &Scene, what: What) -> String {
    match what {
        What::Background => "background".to_owned(),
        What::Emission => "emission".to_owned(),
        What::Ambient { light } => format!("ambient, light \"{}\"", light_name(scene, light)),
        What::Direct { light, lobe, .. } => {
            format!("{lobe}, light \"{}\"", light_name(scene, light))
        }
        What::Traced { lobe } => format!("{lobe}, traced"),
        What::Light { light } => format!("light \"{}\"", light_name(scene, light)),
    }
}

/// A colour as `(0.12, 0.03, 0.03)`, shortened for people.
pub fn short(color: Rgb) -> String {
    let [r, g, b] = color.to_array().map(brief);
    format!("({r}, {g}, {b})")
}

/// Three significant digits, or so.
fn brief(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        a if (1e-3..1e4).contains(&a) => format!("{}", (x * 1e3).round() / 1e3),
        _ => format!("{x:.2e}"),
    }
}

impl RayExplanation {
    /// One line that a person can read:
    /// `reflected  t 12.3  hits "red sphere"  contributes (0.12, 0.03, 0.03)`.
    pub fn line(&self) -> String {
        let mut line = match &self.light {
            Some(light) => format!("shadow ray to \"{light}\""),
            None => self.kind.to_owned(),
        };
        let _ = match (&self.hit, &self.blocked_by) {
            (Some(hit), _) => write!(line, "  t {}  hits \"{}\"", brief(hit.t), hit.object),
            (None, Some(object)) => write!(line, "  blocked by \"{object}\""),
            (None, None) if self.outcome == "too deep" => {
                write!(line, "  beyond the largest depth: black")
            }
            (None, None) if self.outcome == "background" => write!(line, "  hits nothing"),
            (None, None) => write!(line, "  {}", self.outcome),
        };
        let _ = write!(line, "  contributes {}", short(self.contribution));
        line
    }

    fn print(&self, f: &mut fmt::Formatter<'_>, indent: usize) -> fmt::Result {
        let pad = "    ".repeat(indent);
        writeln!(f, "{pad}{}", self.line())?;
        let more = format!("{pad}      ");
        writeln!(f, "{more}from {:?} towards {:?}", self.origin, self.direction)?;
        if let Some(hit) = &self.hit {
            let side = if hit.front { "front" } else { "back" };
            writeln!(f, "{more}at {:?}, {side}, material \"{}\"", hit.point, hit.material)?;
            writeln!(f, "{more}normal {:?}", hit.normal)?;
            if hit.shading_normal != hit.normal {
                writeln!(f, "{more}shading normal {:?}", hit.shading_normal)?;
            }
        }
        if self.kind != "shadow" {
            writeln!(f, "{more}weight {}  radiance {}", short(self.weight), short(self.radiance))?;
            for term in &self.terms {
                let (value, weight) = (short(term.value), short(term.weight));
                let from =
                    term.child.map_or(String::new(), |child| format!(" × ray {}", child + 1));
                writeln!(f, "{more}  + {value}  {} (weight {weight}{from})", term.what)?;
            }
            if self.transmittance != Rgb::WHITE {
                writeln!(f, "{more}  × {}  through the medium", short(self.transmittance))?;
            }
        }
        self.children.iter().try_for_each(|child| child.print(f, indent + 1))
    }
}

impl fmt::Display for RayExplanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.print(f, 0)
    }
}

impl fmt::Display for PixelExplanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = self.pixel;
        writeln!(
            f,
            "pixel ({x}, {y}), {} of {} samples",
            self.samples.len(),
            self.samples_per_pixel
        )?;
        for sample in &self.samples {
            let Some([px, py]) = sample.film else {
                writeln!(f, "\nsample {}: between the two images, no ray", sample.index)?;
                continue;
            };
            write!(
                f,
                "\nsample {} at ({}, {}) on the view plane",
                sample.index,
                brief(px),
                brief(py)
            )?;
            if let Some([lx, ly]) = sample.lens {
                write!(f, ", ({}, {}) on the lens", brief(lx), brief(ly))?;
            }
            if sample.weight != 1.0 {
                write!(f, ", counts {} by the filter", brief(sample.weight))?;
            }
            writeln!(f)?;
            match &sample.ray {
                Some(ray) => write!(f, "{ray}")?,
                None => writeln!(f, "no ray: the camera sees nothing there")?,
            }
            if !sample.complete {
                writeln!(
                    f,
                    "(cut off: the tree has more rays; a smaller max_depth makes a smaller one)"
                )?;
            }
        }
        writeln!(f)?;
        for sample in &self.samples {
            writeln!(f, "sample {:>4}: {:?}", sample.index, sample.radiance.to_array())?;
        }
        let exposure = match self.exposure_time {
            1.0 => String::new(),
            time => format!(", exposure time {time}"),
        };
        let count = self.samples_per_pixel;
        writeln!(f, "the pixel is the mean of {count}{exposure}: {:?}", self.radiance.to_array())
    }
}
