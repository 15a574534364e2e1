//! A judged log as a picture whose pixels are explained: what shows ours shows it, too.

use std::collections::{BTreeMap, BTreeSet};

use explain::{
    PixelExplanation, RecordedRay, SampleExplanation, Source, Sources, Statistics, Sums,
};
use groundtruth::film::Film;
use groundtruth::render::mean;
use groundtruth::rgb::Rgb;
use groundtruth::trace::RayKind;
use text::brief::count;

use crate::laws::{BrokenRay, RayLaw};
use crate::log::Log;
use crate::recorded::Recorded;
use crate::verdict::RayVerdict;

/// The most rays of a pixel whose trees are all made; with more, one at a time.
const MAX_RAYS_PER_PIXEL: usize = 30_000;

/// The part of a sum that single precision may lose.
const ROUNDING: f64 = 1e-5;

/// A log that was judged, by pixels. A tree stands for a sample; where the log has no `pixel`, all are of pixel (0, 0).
#[derive(Debug)]
pub struct Logged {
    /// What the laws found.
    pub verdict: RayVerdict,
    /// The rays that no other sent, by pixel, in the order of samples and lines.
    roots: BTreeMap<[u32; 2], Vec<usize>>,
    /// The pixels with a ray that breaks a law.
    broken: BTreeSet<[u32; 2]>,
}

/// A number that a log has of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedValue {
    /// The place of its tree among those of the pixel.
    pub sample: u32,
    /// Its index in the log.
    pub ray: usize,
    /// The number.
    pub value: f64,
}

/// Where a ray stands: its pixel, which of the pixel's trees, and its number there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RayPlace {
    /// Its pixel.
    pub pixel: [u32; 2],
    /// The place of its tree among those of the pixel.
    pub sample: u32,
    /// Its number in the tree.
    pub number: usize,
}

impl Logged {
    /// Divides a judged log into pixels.
    pub fn of(verdict: RayVerdict) -> Self {
        let traced = &verdict.traced;
        let mut roots: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        for (index, ray) in traced.rays() {
            if traced.parents[index].is_none() {
                roots.entry(ray.pixel.unwrap_or_default()).or_default().push(index);
            }
        }
        // what belongs to no tree comes after the camera's rays
        let order = |&index: &usize| (traced.ray(index).sample, traced.ray(index).is_shadow());
        roots.values_mut().for_each(|roots| roots.sort_by_key(order));
        let findings = verdict.asked.iter().flat_map(|(_, asked)| &asked.findings);
        let broken = findings.map(|it| traced.ray(it.ray).pixel.unwrap_or_default()).collect();
        Self { roots, broken, verdict }
    }

    /// Whether its head names a scene, with a camera.
    pub fn has_scene(&self) -> bool {
        self.verdict.traced.log.head.scene.is_some()
    }

    /// The pixels whose rays it has, and whether one of them breaks a law.
    pub fn pixels(&self) -> impl Iterator<Item = ([u32; 2], bool)> {
        self.roots.keys().map(|pixel| (*pixel, self.broken.contains(pixel)))
    }

    /// The pixel with rays that is nearest to this one.
    pub fn nearest(&self, [x, y]: [u32; 2]) -> Option<[u32; 2]> {
        let square = |pixel: &&[u32; 2]| {
            let [across, down] = [pixel[0].abs_diff(x), pixel[1].abs_diff(y)].map(u64::from);
            across * across + down * down
        };
        self.roots.keys().min_by_key(square).copied()
    }

    /// How many trees a pixel has, at least 1.
    pub fn trees_of(&self, pixel: [u32; 2]) -> u32 {
        self.roots.get(&pixel).map_or(1, |roots| roots.len() as u32)
    }

    /// The mean of what a pixel's trees bring, if it has rays.
    pub fn radiance(&self, pixel: [u32; 2]) -> Option<Rgb> {
        Some(mean(self.radiances(self.roots.get(&pixel)?).into_iter()))
    }

    /// Its pixels in a picture of this size; where they stand in a grid, as cells of it.
    pub fn film(&self, mut film: Film) -> Film {
        let steps = |axis: usize| {
            let places: BTreeSet<u32> = self.roots.keys().map(|pixel| pixel[axis]).collect();
            places.iter().zip(places.iter().skip(1)).map(|(a, b)| b - a).min().unwrap_or(1)
        };
        let (step, [width, height]) = ([steps(0), steps(1)], [film.width(), film.height()]);
        for (&[x, y], roots) in &self.roots {
            let radiance = mean(self.radiances(roots).into_iter());
            for row in y..(y.saturating_add(step[1])).min(height) {
                for column in x..(x.saturating_add(step[0])).min(width) {
                    film.set([column, row], radiance);
                }
            }
        }
        film
    }

    fn radiances(&self, roots: &[usize]) -> Vec<Rgb> {
        let of = |&root: &usize| self.verdict.traced.ray(root).radiance.unwrap_or(Rgb::BLACK);
        roots.iter().map(of).collect()
    }

    /// A pixel explained from its rays: all of its trees, or only one of them if there are many rays.
    pub fn explanation(&self, pixel: [u32; 2], wanted: u32) -> Option<PixelExplanation> {
        let roots = self.roots.get(&pixel)?;
        let trees = || roots.iter().map(|&root| Recorded::of(&self.verdict.traced, root).root);
        let radiances = self.radiances(roots);
        let (mut samples, mut rays) = (Vec::new(), 0);
        let mut sums: [Vec<Sums>; 2] = Default::default();
        for (index, ray) in (0..).zip(trees()) {
            rays += ray.count();
            let [entry, first] = &mut sums;
            entry.push(by_entry(&ray));
            first.push(by_first_hit(&ray));
            if rays <= MAX_RAYS_PER_PIXEL || index == wanted {
                let (film, lens, weight, complete) = (None, None, 1.0, true);
                let (ray, radiance) = (Some(ray), radiances[index as usize]);
                let sample =
                    SampleExplanation { index, film, lens, weight, radiance, complete, ray };
                samples.push(sample);
            }
        }
        Some(PixelExplanation {
            pixel,
            notes: self.notes(roots, rays),
            samples_per_pixel: roots.len() as u32,
            exposure_time: 1.0,
            samples,
            statistics: Statistics::of(&radiances),
            sources: Sources::of([&sums[0], &sums[1]], 1.0),
            radiance: mean(radiances.iter().copied()),
            radiances,
        })
    }

    /// What a reader has to know of a pixel, of which this many rays are in trees.
    fn notes(&self, roots: &[usize], shown: usize) -> Vec<String> {
        let ray = |&root: &usize| self.verdict.traced.ray(root);
        let (mut open, mut all) = (roots.to_vec(), 0);
        while let Some(ray) = open.pop() {
            all += 1;
            open.extend(&self.verdict.traced.children[ray]);
        }
        let cut = (shown < all).then(|| format!("{shown} of {} are shown", count(all, "ray")));
        let samples: BTreeSet<u32> = roots.iter().map(|root| ray(root).sample).collect();
        let trees = (samples.len() < roots.len()).then(|| {
            let (trees, samples) = (count(roots.len(), "tree"), count(samples.len(), "sample"));
            format!("{trees} of {samples}: some rays have no sender in the log")
        });
        let dark = roots.iter().all(|root| ray(root).radiance.is_none());
        let dark =
            dark.then(|| "the log has no `radiance` here, so that there is no sum".to_owned());
        trees.into_iter().chain(dark).chain(cut).collect()
    }

    /// The numbers of a pixel's rays by name: the program's own first, then what all logs may have.
    pub fn values(&self, pixel: [u32; 2]) -> BTreeMap<(bool, String), Vec<LoggedValue>> {
        let mut values: BTreeMap<(bool, String), Vec<LoggedValue>> = BTreeMap::new();
        let traced = &self.verdict.traced;
        for (sample, &root) in (0..).zip(self.roots.get(&pixel).into_iter().flatten()) {
            let mut open = vec![root];
            while let Some(ray) = open.pop() {
                open.extend(&traced.children[ray]);
                for (is_common, name, value) in traced.ray(ray).numbers() {
                    let value = LoggedValue { sample, ray, value };
                    values.entry((is_common, name.to_owned())).or_default().push(value);
                }
            }
        }
        values
    }

    /// Where a ray of this index in the log stands.
    pub fn place(&self, ray: usize) -> RayPlace {
        let traced = &self.verdict.traced;
        let root = traced.root(ray);
        let pixel = traced.ray(root).pixel.unwrap_or_default();
        let sample = self.roots.get(&pixel).and_then(|all| all.iter().position(|it| *it == root));
        let number = Recorded::of(traced, root).number(ray).unwrap_or_default();
        RayPlace { pixel, sample: sample.unwrap_or_default() as u32, number }
    }

    /// Where to look first: the ray that breaks the law that says most, or the first ray.
    pub fn first_place(&self) -> Option<RayPlace> {
        let finding = self.verdict.first().map(|(_, _, finding)| finding.ray);
        let first = || self.roots.values().next()?.first().copied();
        Some(self.place(finding.or_else(first)?))
    }

    /// The rays that break a law and follow from no other, each once: those of the law that says most first, as the laws
    /// stand in the list.
    pub fn broken_rays(&self) -> Vec<usize> {
        let first = self.verdict.first().map(|(law, ..)| law.name);
        let (most, others): (Vec<_>, Vec<_>) =
            self.verdict.asked.iter().partition(|(law, _)| Some(law.name) == first);
        let mut seen = BTreeSet::new();
        let all = most.into_iter().chain(others).flat_map(|(_, asked)| asked.roots());
        all.map(|finding| finding.ray).filter(|ray| seen.insert(*ray)).collect()
    }

    /// The indices in the log of the rays of a tree, by their numbers.
    pub fn tree(&self, pixel: [u32; 2], sample: u32) -> BTreeMap<usize, usize> {
        let root = self.roots.get(&pixel).and_then(|roots| roots.get(sample as usize));
        let recorded = root.map(|&root| Recorded::of(&self.verdict.traced, root));
        recorded.map_or(BTreeMap::new(), |recorded| recorded.by_number().collect())
    }

    /// What the laws found of the rays of a tree, by their numbers.
    pub fn findings(&self, pixel: [u32; 2], sample: u32) -> BTreeMap<usize, Vec<String>> {
        let told =
            |(law, finding): (&RayLaw, &BrokenRay)| format!("{}: {}", law.name, finding.words);
        let tree = self.tree(pixel, sample).into_iter();
        let all = tree.map(|(number, ray)| (number, self.verdict.of_ray(ray).map(told).collect()));
        all.filter(|(_, found): &(usize, Vec<String>)| !found.is_empty()).collect()
    }
}

/// Width and height of a log's picture: what its head says, or as large as its pixels need.
pub fn size(log: &Log) -> [u32; 2] {
    let pixels = || log.rays.iter().filter_map(|ray| ray.pixel);
    let least =
        |axis: usize| pixels().map(|pixel| pixel[axis].saturating_add(1)).max().unwrap_or(1);
    log.head.size.unwrap_or_else(|| [least(0), least(1)])
}

/// The light of a tree by where it enters: each lamp's along shadow rays, and what is emitted or added where a ray ends.
fn by_entry(root: &RecordedRay) -> Sums {
    let mut sums = Sums::default();
    for ray in root.rays() {
        sums.add(lamp(ray).unwrap_or_else(|| entry(ray)), own(ray));
    }
    sums
}

/// The light of a tree by how it leaves the first hit.
fn by_first_hit(root: &RecordedRay) -> Sums {
    let mut sums = Sums::default();
    sums.add(entry(root), own(root));
    for child in &root.children {
        sums.add(lamp(child).unwrap_or_else(|| scattered(child)), child.contribution);
    }
    sums
}

/// What a ray brings that no other brought to it, so that the parts add up whatever the program counts as `direct`.
fn own(ray: &RecordedRay) -> Rgb {
    let brought: Rgb = ray.children.iter().map(|child| child.contribution).sum();
    let rest = ray.contribution - brought;
    let is_rounding = rest.map(f64::abs).average() <= ROUNDING * brought.map(f64::abs).average();
    if is_rounding { Rgb::BLACK } else { rest }
}

/// What a ray meets.
fn entry(ray: &RecordedRay) -> Source {
    match (ray.kind, &ray.hit) {
        (RayKind::Camera, None) => Source::Background,
        (RayKind::Camera, Some(_)) => Source::Emission,
        _ => scattered(ray),
    }
}

/// The lamp that a shadow ray is aimed at.
fn lamp(ray: &RecordedRay) -> Option<Source> {
    let RayKind::Shadow { light: index } = ray.kind else { return None };
    Some(Source::Light { index, light: ray.light.clone().unwrap_or_else(|| "?".into()) })
}

fn scattered(ray: &RecordedRay) -> Source {
    Source::Lobe {
        lobe: if ray.kind == RayKind::Transmitted { "transmitted" } else { "reflected" },
    }
}
