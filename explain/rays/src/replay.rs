//! A log of a scene beside the rays that a tracer sends from the same camera rays: where the two part.
//!
//! Random directions are the program's own. So only those rays are compared that no draw decides, and what is added up of
//! draws is not compared at all; a difference that the rounding of the camera's ray makes, too, is none.

use explain::{RayTree, RecordedRay, RecordedTerm, Unlit, UnlitLight, add_unlit};
use groundtruth::math::{Frame, Normal, Ray, Vector, power, to_degrees};
use groundtruth::render::Renderer;
use groundtruth::rgb::Rgb;
use groundtruth::trace::{RayBudget, RayKind, TermSource};
use groundtruth::world::World;
use text::digits::{short, three};

use crate::laws::{angle_between, is_near_color};
use crate::log::Purpose;
use crate::traced::Traced;
use crate::written::{leaving, media, terms_of, weight};

/// The most rays that are traced for a ray of the log.
const MAX_RAYS: u64 = 1 << 16;
/// The angle between directions that are the same at a first hit, in radians; a curved surface may widen it by [`WIDENS`].
const SAME_DIRECTION: f64 = 1e-3;
const WIDENS: f64 = 4.0;
/// The relative difference of lengths that are the same, and that of colours.
const SAME: f64 = 1e-3;
const SAME_COLOR: f64 = 1e-2;
/// What brings less than this part of its parent's light may be left out.
const NOTHING: f64 = 1e-3;

/// Where two programs part.
#[derive(Clone, Debug, PartialEq)]
pub struct Parting {
    /// The index of the ray in the log.
    pub ray: usize,
    /// What differs.
    pub what: Part,
    /// How it differs, beginning after the ray's name.
    pub words: String,
}

impl Parting {
    fn of(ray: usize, what: Part, words: impl Into<String>) -> Self {
        Self { ray, what, words: words.into() }
    }
}

/// What may differ of a ray, in the order in which it is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// Where it ends: a law of its own tells that.
    End,
    /// Where it goes, its weight, or the rays that it sends.
    Way,
    /// What it brings.
    Light,
}

/// What came of a comparison of a ray and all after it: whether all is the same; if not, what may differ is drawn, or is not in
/// the log.
type Compared = Result<bool, Parting>;

/// Where the rays after a camera's ray part, and the rays of which this is as the tracer has it.
struct Agreement {
    parted: Option<Parting>,
    agreed: Vec<(usize, Part)>,
}

/// A log beside the rays of a tracer.
struct Comparison<'a> {
    traced: &'a Traced,
    world: &'a World,
    /// The rays of which this is as the tracer has it.
    agreed: Vec<(usize, Part)>,
}

/// Where the rays after a camera's ray of the log part from those that a program sends; `None` if they do not.
pub fn parting(traced: &Traced, root: usize, program: &impl Renderer) -> Option<Parting> {
    let direction = traced.ray(root).direction.unit()?;
    let from = |direction: Vector| compared(traced, (root, direction), program)?.parted;
    let parting = from(direction)?;
    let Frame { u, v, .. } = Frame::around(Normal::new(direction)?);
    let [u, v] = [u, v].map(|side| traced.tolerance() * side);
    let is_same = |off: Vector| from(direction + off).is_some_and(|it| it.ray == parting.ray);
    [u, -u, v, -v].into_iter().all(is_same).then_some(parting)
}

/// Whether a program sends the rays after a camera's ray as the log has them, which part from another program's.
pub fn explains(
    program: &impl Renderer,
    traced: &Traced,
    (root, parting): (usize, &Parting),
) -> bool {
    let direction = traced.ray(root).direction.unit();
    let compared = direction.and_then(|it| compared(traced, (root, it), program));
    compared.is_some_and(|Agreement { parted, agreed }| {
        let is_there = |&(ray, part): &(usize, Part)| ray == parting.ray && part >= parting.what;
        parted.is_none() && agreed.iter().any(is_there)
    })
}

/// A camera's ray, in this direction, and all after it beside what a program sends; `None` if it cannot be traced.
fn compared(
    traced: &Traced,
    (root, direction): (usize, Vector),
    program: &impl Renderer,
) -> Option<Agreement> {
    let origin = Some(traced.ray(root).origin).filter(|origin| origin.is_finite())?;
    let (world, ray) = (program.world(), Ray::new(origin, direction.unit()?));
    let (mut tree, mut budget) = (RayTree::of(world), RayBudget::up_to(MAX_RAYS));
    program.radiance(&ray, world.draws([0, 0], 0), &mut tree, &mut budget);
    let mut ours = tree.into_root().filter(|_| !budget.is_exceeded())?;
    // which of the reasons of a light without a sample it is does not matter here
    add_unlit((world, &[]), world.draws([0, 0], 0), &mut ours);
    let mut comparison = Comparison { traced, world, agreed: Vec::new() };
    let parted = comparison.ray(root, &ours, 1.0).err();
    Some(Agreement { parted, agreed: comparison.agreed })
}

impl Comparison<'_> {
    /// A ray of the log and all after it, beside ours in its place, where the log's radiance is this many times ours.
    fn ray(&mut self, index: usize, ours: &RecordedRay, times: f64) -> Compared {
        let traced = self.traced;
        if !ends_alike(traced, index, ours) {
            return Err(Parting::of(index, Part::End, "ends where ours does not"));
        }
        self.agreed.push((index, Part::End));
        let mut is_whole = self.are_decided(&ours.terms) && self.are_lamps_decided(ours);
        let mut most: Option<(f64, Parting)> = None;
        for child in ours.children.iter().filter(|child| !child.is_shadow() && child.is_cast()) {
            let is_decided = self.is_sent_alike(ours, child);
            match is_decided.then(|| self.child(index, (ours, child), times)) {
                Some(Err(parting)) => {
                    let light = (weight(ours, child) * child.radiance).average();
                    most = most.filter(|it| it.0 >= light).or(Some((light, parting)));
                }
                same => is_whole &= same == Some(Ok(true)),
            }
        }
        let parted = most.map(|it| it.1).or_else(|| self.shadow_ray(index, ours));
        if let Some(parting) = parted.or_else(|| self.too_much(index, ours)) {
            return Err(parting);
        }
        self.agreed.push((index, Part::Way));
        let his = match (traced.ray(index).radiance, is_whole) {
            // what a program calls the radiance of a ray in a medium is not known: that of the one before shows it
            (_, true) if ours.transmittance != Rgb::WHITE => return Ok(true),
            (Some(his), true) => his,
            _ => return Ok(false),
        };
        let expected = times * leaving(ours);
        if is_near_color(his, expected, SAME_COLOR) {
            self.agreed.push((index, Part::Light));
            return Ok(true);
        }
        let [his, expected] = [his, expected].map(|it| three(it.to_array()));
        let is_last = ours.children.iter().all(RecordedRay::is_shadow);
        let after = if is_last { "" } else { ", though the rays after it agree" };
        let words = format!("brings {his}, where ours brings {expected}{after}");
        Err(Parting::of(index, Part::Light, words))
    }

    /// The ray of the log in the place of a child of ours, and all after it.
    fn child(
        &mut self,
        parent: usize,
        (ours, child): (&RecordedRay, &RecordedRay),
        times: f64,
    ) -> Compared {
        let traced = self.traced;
        let (kind, counts) = (purpose(child), weight(ours, child));
        let angle =
            |index: &usize| angle_between(traced.ray(*index).direction, child.ray.direction);
        let sent = traced.children[parent].iter().filter(|&&it| traced.ray(it).is(&kind)).copied();
        let parted = |ray: usize, words: String| Err(Parting::of(ray, Part::Way, words));
        let Some(index) = sent.min_by(|a, b| angle(a).total_cmp(&angle(b))) else {
            let brings = (counts * child.radiance).average();
            if brings <= NOTHING * leaving(ours).average() {
                return Ok(false);
            }
            let counts = three(counts.to_array());
            let words = format!("sends no {kind} ray, where ours sends one that counts {counts}");
            return parted(parent, words);
        };
        let apart = angle(&index);
        if apart > SAME_DIRECTION * power(WIDENS, f64::from(child.depth.min(8)) - 1.0) {
            return parted(index, format!("goes {}° beside ours", short(to_degrees(apart))));
        }
        let his = traced.ray(index).factors.weight.filter(|_| child.transmittance == Rgb::WHITE);
        let is = |it: &f64| his.is_none_or(|his| is_near_color(*it * his, counts, SAME_COLOR));
        match [1.0, denser(ours, child)].into_iter().find(is) {
            Some(more) => self.ray(index, child, more * times),
            None => {
                let [his, counts] =
                    [his.unwrap_or_default(), counts].map(|it| three(it.to_array()));
                parted(index, format!("counts {his}, where ours counts {counts}"))
            }
        }
    }

    /// A shadow ray to a lamp of our name in another direction than ours.
    fn shadow_ray(&self, parent: usize, ours: &RecordedRay) -> Option<Parting> {
        let traced = self.traced;
        let sign = if traced.conventions.shadow_from_lamp { -1.0 } else { 1.0 };
        let mut one_direction =
            ours.children.iter().filter(|it| it.is_shadow() && self.is_sent_alike(ours, it));
        one_direction.find_map(|child| {
            let is_its = |index: &&usize| {
                let ray = traced.ray(**index);
                ray.is(&Purpose::Shadow) && ray.light.is_some() && ray.light == child.light
            };
            let index = *traced.children[parent].iter().find(is_its)?;
            let apart = angle_between(sign * traced.ray(index).direction, child.ray.direction);
            let words = format!("goes {}° beside ours to this lamp", short(to_degrees(apart)));
            (apart > SAME_DIRECTION * WIDENS).then(|| Parting::of(index, Part::Way, words))
        })
    }

    /// A mirrored or refracted ray where ours sends none of its kind, and no draw decides that.
    fn too_much(&self, parent: usize, ours: &RecordedRay) -> Option<Parting> {
        let sent = || ours.children.iter().filter(|child| !child.is_shadow());
        let has = |kind: &Purpose| sent().any(|child| child.is_cast() && purpose(child) == *kind);
        let traced = self.traced;
        let most = traced.ray(parent).radiance.map_or(0.0, Rgb::average);
        let is_lit = |index: usize| {
            let ray = traced.ray(index);
            let [light, weight] =
                [ray.radiance, ray.factors.weight].map(|it| it.unwrap_or(Rgb::WHITE));
            (weight * light).average() > NOTHING * most
        };
        let kinds = [Purpose::Reflected, Purpose::Transmitted];
        let is_too_much = |index: &usize| {
            kinds.iter().any(|kind| traced.ray(*index).is(kind) && !has(kind)) && is_lit(*index)
        };
        let are_all_sent = sent().all(|it| !it.is_cast() || self.is_sent_alike(ours, it));
        let index =
            traced.children[parent].iter().copied().find(is_too_much).filter(|_| are_all_sent)?;
        Some(Parting::of(index, Part::Way, "is sent, where ours sends none"))
    }

    /// Whether no draw decides where a ray of ours goes and whether it is sent at all.
    fn is_sent_alike(&self, ours: &RecordedRay, child: &RecordedRay) -> bool {
        let has_terms = terms_of(ours, child).next().is_some();
        has_terms && self.are_decided(terms_of(ours, child))
    }

    /// Whether no draw decides that a lamp adds nothing at a hit.
    fn are_lamps_decided(&self, ours: &RecordedRay) -> bool {
        // what the light's kind, the tracer, the viewer or the material says is so for all its points
        let is_of_point = |unlit: &&UnlitLight| {
            !matches!(
                unlit.reason,
                Unlit::SwitchedOff
                    | Unlit::LeftOut
                    | Unlit::NotSampled
                    | Unlit::FirstHitOnly
                    | Unlit::TooDeep
                    | Unlit::NoAmbientReflectance
                    | Unlit::ViewerBehind { .. }
                    | Unlit::NoLobes
                    | Unlit::TracedLobesOnly
            )
        };
        let unlit = ours.unlit.iter().filter(is_of_point).map(|unlit| &unlit.light);
        let asked = ours.children.iter().filter_map(|child| child.light.as_ref());
        let mut lights = self.world.lights.iter().filter(|it| it.light.draws() > 0);
        let names: Vec<_> = unlit.chain(asked).collect();
        !lights.any(|it| names.contains(&&it.name))
    }

    fn are_decided<'t>(&self, terms: impl IntoIterator<Item = &'t RecordedTerm>) -> bool {
        let is_one_direction = |index: u32| {
            let mut lights = self.world.lights.iter();
            lights.any(|it| it.index == index && it.light.draws() == 0)
        };
        terms.into_iter().all(|term| match &term.source {
            TermSource::Traced { pdf, lobe_probability, survival, .. } => {
                pdf.is_none() && *lobe_probability == 1.0 && *survival == 1.0
            }
            TermSource::Background { mis } | TermSource::Emission { mis } => mis.is_none(),
            TermSource::Direct { light, .. }
            | TermSource::Ambient { light, .. }
            | TermSource::Light { light } => is_one_direction(*light),
        })
    }
}

/// The square of the ratio of the indices in the weight of a refracted ray: a program may leave it out, and the radiance of
/// its ray is then as much smaller than ours as its weight is larger.
fn denser(sender: &RecordedRay, ray: &RecordedRay) -> f64 {
    let media = media(Some(sender)).filter(|_| ray.kind == RayKind::Transmitted);
    media.map_or(1.0, |[front, behind]| (front / behind) * (front / behind))
}

/// Whether both rays hit the same, or nothing; where they do not, that is told by the law of the nearest hit.
fn ends_alike(traced: &Traced, index: usize, ours: &RecordedRay) -> bool {
    let (ray, end) = (traced.ray(index), traced.end_point(index));
    match (&ours.hit, end) {
        (None, None) => true,
        (Some(hit), Some(end)) => {
            let is_known = |world: &World, name| world.names.objects.contains(name);
            let is_named = |name| traced.world.as_ref().is_some_and(|it| is_known(it, name));
            let named = ray.object.as_ref().filter(|name| is_named(name));
            let length = (end - ray.origin).length();
            named.is_none_or(|name| *name == hit.object)
                && end.distance(hit.point) <= SAME * length.max(traced.scale)
        }
        _ => false,
    }
}

fn purpose(ray: &RecordedRay) -> Purpose {
    match ray.kind {
        RayKind::Camera => Purpose::Camera,
        RayKind::Reflected => Purpose::Reflected,
        RayKind::Transmitted => Purpose::Transmitted,
        RayKind::Shadow { .. } => Purpose::Shadow,
    }
}
