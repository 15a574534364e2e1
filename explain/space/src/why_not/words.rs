//! The answer in words and numbers.

use groundtruth::math::Point;
use groundtruth::printable::name;
use groundtruth::trace::RayKind;
use text::brief::brief;

use super::{Meeting, WhyNot, WhyNotAnswer};

impl WhyNot {
    /// The answer in one sentence.
    pub fn sentence(&self) -> String {
        let (ray, object) = (self.subject(), quoted(&self.object));
        let distance = self.meets.map_or(String::new(), |at| brief(at.distance));
        capital(&match &self.answer {
            WhyNotAnswer::Hits { front: true, .. } => {
                format!("{ray} hits {object} after {distance}.")
            }
            WhyNotAnswer::Hits { is_dark_back: false, .. } => {
                format!("{ray} hits the back of {object} after {distance}.")
            }
            WhyNotAnswer::Hits { .. } => format!(
                "{ray} hits {object} after {distance}, but on its back, and the material is one-sided: its back \
                 scatters nothing."
            ),
            WhyNotAnswer::Blocks => format!("{object} blocks {ray} after {distance}."),
            WhyNotAnswer::NotCast { is_too_deep: true } => {
                format!("{ray} was not cast: it is beyond the largest depth (max_depth).")
            }
            WhyNotAnswer::NotCast { is_too_deep: false } => {
                format!("{ray} was not cast: the limit on the number of rays was reached.")
            }
            WhyNotAnswer::AlsoBlocks => {
                let other = self.ended.as_ref().map_or(String::new(), |it| quoted(&it.object));
                format!(
                    "{object} is in the way of {ray} too, after {distance}; {other} was found first, and one object is \
                     enough."
                )
            }
            WhyNotAnswer::StartsOnIt => {
                format!("{ray} starts on {object}, leaves it and does not meet it again.")
            }
            WhyNotAnswer::Passes => {
                format!("{ray} does not hit {object}: it passes it{}.", self.passes())
            }
            _ => format!("{ray} does not hit {object}: {}.", self.why(&distance)),
        })
    }

    /// Why it is not hit, for answers that say so. `distance` is where it would be.
    fn why(&self, distance: &str) -> String {
        let light = self.light.as_deref().map(quoted).unwrap_or_default();
        let in_the_way = format!("it is in the way after {distance}, but");
        match &self.answer {
            WhyNotAnswer::SwitchedOff => format!("it is switched off; {}", self.if_on()),
            WhyNotAnswer::BeyondHit => self.order("is met"),
            WhyNotAnswer::BeyondBlocker => {
                format!("{}. What is beyond adds no more shadow", self.order("blocks it"))
            }
            WhyNotAnswer::BeyondLight => {
                format!("the light {light} is before it; beyond, it would be met after {distance}")
            }
            WhyNotAnswer::LightCastsNone => {
                format!("{in_the_way} nothing casts shadows in the light {light} (shadows = false)")
            }
            WhyNotAnswer::CastsNone => {
                format!("{in_the_way} it or its material casts no shadows (casts_shadows = false)")
            }
            WhyNotAnswer::LetsThrough => format!(
                "{in_the_way} transparent, and shadow rays go through (transparency.shadows = \"attenuated\")"
            ),
            WhyNotAnswer::OutsidePart { whole, at } => format!(
                "it is a part of a larger surface; the {whole} is met after {}, outside the part",
                brief(at.distance)
            ),
            WhyNotAnswer::Behind { at } => format!(
                "it is behind the origin of the ray, whose line meets it at {} behind",
                brief(at.distance)
            ),
            _ => format!(
                "its surface, after {distance}, is as near as rounding can tell to the ray's end or to another one"
            ),
        }
    }

    /// The numbers, a line each, shortened for people.
    pub fn numbers(&self) -> Vec<String> {
        let mut lines = Vec::new();
        let met = |words: &str, at: &Meeting| {
            let [t, distance] = [at.t, at.distance].map(brief);
            format!("{words} at t {t}, distance {distance}, point {}", shown(at.point))
        };
        let ends_there = matches!(self.answer, WhyNotAnswer::Hits { .. } | WhyNotAnswer::Blocks);
        if let Some(at) = &self.meets {
            let word = if ends_there { "meets" } else { "would meet" };
            lines.push(met(&format!("{word} {}", quoted(&self.object)), at));
        }
        if let Some(approach) = &self.approach {
            let (t, distance) = (brief(approach.t), brief(approach.distance));
            lines.push(format!("nearest to it at t {t}, point {}", shown(approach.on_ray)));
            lines.push(format!("its nearest point {}", shown(approach.on_surface)));
            lines.push(format!("distance of the two points {distance}"));
        }
        match &self.answer {
            WhyNotAnswer::OutsidePart { whole, at } => {
                lines.push(met(&format!("meets its {whole}"), at))
            }
            WhyNotAnswer::Behind { at } => lines.push(met("its line meets it", at)),
            _ => {}
        }
        if let Some(ended) = self.ended.as_ref().filter(|_| !ends_there) {
            let word = if self.light.is_some() { "blocked by" } else { "hits" };
            lines.push(met(&format!("{word} {}", quoted(&ended.object)), &ended.at));
        }
        lines.extend(self.black.iter().map(|zeros| format!("the ray brings no light: {zeros}")));
        let others: Vec<String> = self.met_by.iter().map(usize::to_string).collect();
        lines.push(match &others[..] {
            [] => "no ray of this sample meets it".to_owned(),
            [one] => format!("met by ray {one} of this sample"),
            _ => format!("met by rays {} of this sample", others.join(", ")),
        });
        lines
    }

    /// `the camera's ray`, `shadow ray 2 to "lamp"`.
    fn subject(&self) -> String {
        match self.kind {
            RayKind::Camera => "the camera's ray".to_owned(),
            RayKind::Reflected => format!("the reflected ray {}", self.ray),
            RayKind::Transmitted => format!("the transmitted ray {}", self.ray),
            RayKind::Shadow { .. } => {
                let light = self.light.as_deref().map(quoted).unwrap_or_default();
                format!("the shadow ray {} to {light}", self.ray)
            }
        }
    }

    /// How far the ray passes, and whether another object ends it before.
    fn passes(&self) -> String {
        let Some(approach) = &self.approach else { return String::new() };
        let mut text = format!(" at a distance of {}", brief(approach.distance));
        if let Some(ended) = self.ended.as_ref().filter(|ended| ended.at.t < approach.t) {
            text += &format!("; before that it ends on {}", quoted(&ended.object));
        }
        text
    }

    /// What would be if the object were switched on.
    fn if_on(&self) -> String {
        let Some(at) = &self.meets else {
            return format!("if it were on, the ray would pass it{}", self.passes());
        };
        let distance = brief(at.distance);
        match self.ended.as_ref() {
            Some(ended) if ended.at.t < at.t => {
                let (other, first) = (quoted(&ended.object), brief(ended.at.distance));
                format!(
                    "if it were on, it would be met after {distance}, but {other} is before it, after {first}"
                )
            }
            _ => format!("if it were on, it would be met after {distance}"),
        }
    }

    /// Which object is first.
    fn order(&self, happens: &str) -> String {
        let (Some(at), Some(ended)) = (&self.meets, &self.ended) else { return String::new() };
        let other = quoted(&ended.object);
        if ended.at.t == at.t {
            return format!("{other} is at the same place, and {happens}");
        }
        let [first, second] = [ended.at.distance, at.distance].map(brief);
        format!("{other} {happens} before it, after {first}; it would be met after {second}")
    }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", name(text))
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

fn shown(point: Point) -> String {
    let [x, y, z] = point.to_array().map(brief);
    format!("({x}, {y}, {z})")
}
