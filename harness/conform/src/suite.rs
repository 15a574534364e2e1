//! All families: what `conform` asks.

use ask::{Asking, Draw, Stop};
use serde_json::{Value, json};

use super::family::{Family, Judge};
use super::judgement::{Judgement, Profile};
use super::questions::{self, kinds, outside, ray_question, square};
use super::{cases, intersections, laws};
use groundtruth::lobes::{Claims, Lobe};
use groundtruth::similar::did_you_mean;
use groundtruth::{cameras, samplers};
use oracle::hard;

/// A law as a family has it.
pub type Law = fn(&mut Asking<'_>, &Value, Profile) -> Result<Judgement, Stop>;

/// Every family, by chapter.
pub fn all() -> Vec<Family> {
    let mut all = intersections::families();
    all.extend(cases::families());
    all.extend(questions::families());
    all.extend(of_laws());
    all.sort_by_key(|family| family.chapter);
    all
}

/// The error text for a word that selects nothing.
pub fn unknown(word: &str, families: &[Family]) -> String {
    let hint = similar(word, families);
    format!("nothing is called `{word}`{hint} (chapters are ch03, ch04 …)")
}

/// `; did you mean …?` with words that select families and are like a mistyped one, the shortest first.
pub fn similar(word: &str, families: &[Family]) -> String {
    let words = families.iter().flat_map(|Family { chapter, about, name, .. }| {
        let beginnings = name.match_indices(['.', '_']).map(|(end, _)| &name[..end]);
        [*chapter, about, name].into_iter().chain(beginnings)
    });
    let mut known: Vec<&str> = words.collect();
    known.sort_by_key(|word| (word.len(), *word));
    known.dedup();
    did_you_mean(word, &known)
}

/// The families judged by laws.
fn of_laws() -> Vec<Family> {
    let mut all = Vec::new();
    all.extend(of_lobes());
    all.extend(of_shapes());
    all.extend(of_cameras());
    all.extend(of_samples());
    all
}

fn law(
    name: &str,
    about: &str,
    chapter: &'static str,
    law: Law,
    case: impl Fn(&mut Draw) -> Value + Send + Sync + 'static,
) -> Family {
    questions::family(name, about, chapter, Judge::Law(law), case)
}

fn of_lobes() -> Vec<Family> {
    let mut all = Vec::new();
    for (entry, (tag, chapter, data)) in Lobe::ENTRIES.iter().zip(kinds(Lobe::ENTRIES)) {
        let specimens = (entry.specimens)();
        let Some(first) = specimens.first() else { continue };
        let Claims { reciprocal, conserves_energy } = first.claims();
        let about = format!("lobes/{tag}");
        let mut add = |name: &str, of: Law, share: f64, case: fn(&mut Draw, Value) -> Value| {
            let data = data.clone();
            let case = move |draw: &mut Draw| {
                let lobe = data[draw.below(data.len())].clone();
                case(draw, lobe)
            };
            let mut family = law(&format!("lobe.{tag}.{name}"), &about, chapter, of, case);
            family.share = share;
            all.push(family);
        };
        if conserves_energy && !tag.contains("transmitter") {
            add(
                "energy",
                laws::energy,
                0.5,
                |draw, lobe| json!({"lobe": {"lobe": lobe, "wo": outside(draw)}}),
            );
        }
        if first.is_specular() {
            continue;
        }
        if reciprocal {
            add(
                "reciprocity",
                laws::reciprocity,
                0.5,
                |draw, lobe| json!({"lobe": {"lobe": lobe, "wo": outside(draw), "wi": outside(draw)}}),
            );
        }
        add(
            "sample",
            laws::sample_agrees,
            0.5,
            |draw, lobe| json!({"lobe": {"lobe": lobe, "wo": outside(draw), "u": square(draw)}}),
        );
        // one case asks 1500 questions
        add(
            "density",
            laws::density,
            0.04,
            |draw, lobe| json!({"lobe": {"lobe": lobe, "wo": outside(draw), "u": square(draw)}}),
        );
    }
    all
}

fn of_shapes() -> Vec<Family> {
    let mut all = Vec::new();
    for nearest in intersections::families() {
        let mut parts = nearest.name.split('.');
        let (question, tag, last) = (parts.next(), parts.next(), parts.next());
        let (Some("intersect"), Some(tag)) = (question, tag) else { continue };
        let (name, of): (&str, Law) = match last {
            Some("ordinary") => ("direction_length", laws::direction_length),
            Some("all_roots") if is_closed(tag) => ("sides", laws::sides_alternate),
            _ => continue,
        };
        let full_name = format!("intersect.{tag}.{name}");
        let mut family = Family { name: full_name, judge: Judge::Law(of), share: 0.25, ..nearest };
        let cases = family.cases;
        family.cases = Box::new(move |seed, n| cases(seed ^ 0x5eed, n));
        all.push(family);
    }
    all
}

/// Whether shapes of this tag have an inside.
fn is_closed(tag: &str) -> bool {
    ["sphere", "box", "torus"].contains(&tag)
        || hard::Kind::ALL
            .into_iter()
            .filter(|kind| kind.is_solid())
            .any(|kind| groundtruth::kinds::tag(&format!("{kind:?}")) == tag)
}

fn of_cameras() -> Vec<Family> {
    let family = |(tag, chapter, specimens): (String, &'static str, Vec<Value>)| {
        // through a view of a millionth of a degree, the rounding of a direction is many pixels
        let wide = |lens: &Value| {
            let angles = lens.as_object().into_iter().flat_map(|lens| lens.values());
            let angles = angles.filter_map(Value::as_object).flatten();
            angles.into_iter().all(|(name, x)| !name.ends_with("fov") || x.as_f64() >= Some(1.0))
        };
        let specimens: Vec<Value> = specimens.into_iter().filter(wide).collect();
        let case = move |draw: &mut Draw| {
            let mut question = ray_question(draw, &specimens);
            // through the centre of the lens
            question["camera_ray"].as_object_mut().map(|fields| fields.remove("lens"));
            question
        };
        let name = format!("camera_ray.{tag}.there_and_back");
        law(&name, &format!("cameras/{tag}"), chapter, laws::there_and_back, case)
    };
    kinds(cameras::Kind::ENTRIES).into_iter().map(family).collect()
}

fn of_samples() -> Vec<Family> {
    let mut all = Vec::new();
    for (tag, chapter, specimens) in kinds(samplers::Kind::ENTRIES) {
        let for_sets = specimens.clone();
        let case = move |draw: &mut Draw| {
            let side = 2 + draw.below(8);
            let seed = draw.below(1 << 30);
            let sampler = for_sets[draw.below(for_sets.len())].clone();
            json!({"samples": {"sampler": sampler, "n": side * side, "seed": seed, "sets": 2}})
        };
        let is_random = !["regular", "hammersley"].contains(&&*tag);
        if is_random {
            let sampler = specimens[0].clone();
            let draws = move |draw: &mut Draw| {
                let (side, seed) = (8 + draw.below(3), draw.below(1 << 30));
                let draw = json!({"pixel": [0, 0], "index": 0});
                json!({"samples": {"sampler": sampler, "n": side * side, "seed": seed, "draw": draw}})
            };
            let name = format!("samples.{tag}.stream");
            let mut family = law(&name, &format!("samplers/{tag}"), chapter, laws::stream, draws);
            // one case asks about 500 questions
            family.share = 0.08;
            all.push(family);
        }
        let name = format!("samples.{tag}.strata");
        all.push(law(&name, &format!("samplers/{tag}"), chapter, laws::stratified, case));
    }
    all
}
