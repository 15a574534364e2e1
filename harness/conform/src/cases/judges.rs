//! The judges that files of families name.

use super::super::family::{ByAnswer, Judge};
use super::super::questions::{optics, sampling, spaces};
use super::super::values::{self, Rules};
use super::super::{intersections, laws, radiance, scenes};

/// The judge of this name, by the rules of a family. `values` compares the numbers of an answer with ours.
pub fn judge(name: &str, rules: &'static Rules) -> Option<Judge> {
    let answer: ByAnswer = match name {
        "values" => values::judge,
        "rays" => scenes::judge_rays,
        "hit" => intersections::judge,
        "in_the_way" => intersections::judge_occluded,
        "lobe" => optics::lobe,
        "sample_sets" => sampling::samples,
        "transform" => spaces::transform,
        "grid" => spaces::grid,
        _ => return law(name),
    };
    Some(Judge::Answer(answer, rules))
}

/// The law of this name.
fn law(name: &str) -> Option<Judge> {
    Some(Judge::Law(match name {
        "mean" => radiance::mean_agrees,
        "energy" => laws::energy,
        "reciprocity" => laws::reciprocity,
        "sample_agrees" => laws::sample_agrees,
        "density" => laws::density,
        "there_and_back" => laws::there_and_back,
        "stratified" => laws::stratified,
        "stream" => laws::stream,
        "lamp_sample" => laws::lamp_sample,
        "sky_sample" => laws::sky_sample,
        "cosine_drawn" => laws::cosine_drawn,
        "irradiance" => laws::irradiance,
        "jittered_moments" => laws::jittered_moments,
        "shares_add_up" => laws::shares_add_up,
        "map_and_back" => laws::map_and_back,
        "inverse_is_inverse" => laws::inverse_is_inverse,
        "noise_is_smooth" => laws::noise_is_smooth,
        "unaccelerated" => laws::unaccelerated,
        "repeats" => laws::repeats,
        "seeds_differ" => laws::seeds_differ,
        "vectors_are_even" => laws::vectors_are_even,
        "interpolates" => laws::interpolates,
        "knots_differ" => laws::knots_differ,
        "octaves_add_up" => laws::octaves_add_up,
        "texture_of_noise" => laws::texture_of_noise,
        "bump_adds_noise" => laws::bump_adds_noise,
        _ => return None,
    }))
}
