//! The judges that files of families name.

use super::super::family::{Judge, Namer};
use super::super::questions::{cameras, images, meshes, noise, optics, sampling, spaces, surfaces};
use super::super::{intersections, laws, radiance, scenes};

/// The judge of this name, and what names the mistakes of wrong answers in scenes.
pub fn judge(name: &str) -> Option<(Judge, Option<Namer>)> {
    let in_scene = ["radiance", "mean", "rays", "first_hit", "occluded"].contains(&name);
    let judge = match name {
        "radiance" => Judge::Answer(radiance::judge),
        "mean" => Judge::Law(radiance::mean_agrees),
        "rays" => Judge::Answer(scenes::judge_rays),
        "first_hit" => Judge::Answer(scenes::judge_hit),
        "occluded" => Judge::Answer(scenes::judge_occluded),
        "hit" => Judge::Answer(intersections::judge),
        "in_the_way" => Judge::Answer(intersections::judge_occluded),
        "mesh" => Judge::Answer(meshes::judge),
        "image" => Judge::Answer(images::judge),
        "lobe" => Judge::Answer(optics::lobe),
        "light" => Judge::Answer(surfaces::light),
        "texture" => Judge::Answer(surfaces::texture),
        "camera_ray" => Judge::Answer(cameras::camera_ray),
        "project" => Judge::Answer(cameras::project),
        "energy" => Judge::Law(laws::energy),
        "reciprocity" => Judge::Law(laws::reciprocity),
        "sample_agrees" => Judge::Law(laws::sample_agrees),
        "density" => Judge::Law(laws::density),
        "there_and_back" => Judge::Law(laws::there_and_back),
        "stratified" => Judge::Law(laws::stratified),
        "stream" => Judge::Law(laws::stream),
        "mapping" => Judge::Answer(surfaces::mapping),
        "fresnel" => Judge::Answer(optics::fresnel),
        "sample_sets" => Judge::Answer(sampling::samples),
        "map" => Judge::Answer(sampling::map),
        "transform" => Judge::Answer(spaces::transform),
        "grid" => Judge::Answer(spaces::grid),
        "given_noise" => Judge::Answer(noise::given),
        "still" => Judge::Answer(noise::still),
        "lamp_sample" => Judge::Law(laws::lamp_sample),
        "sky_sample" => Judge::Law(laws::sky_sample),
        "cosine_drawn" => Judge::Law(laws::cosine_drawn),
        "irradiance" => Judge::Law(laws::irradiance),
        "jittered_moments" => Judge::Law(laws::jittered_moments),
        "shares_add_up" => Judge::Law(laws::shares_add_up),
        "map_and_back" => Judge::Law(laws::map_and_back),
        "inverse_is_inverse" => Judge::Law(laws::inverse_is_inverse),
        "noise_is_smooth" => Judge::Law(laws::noise_is_smooth),
        "repeats" => Judge::Law(laws::repeats),
        "interpolates" => Judge::Law(laws::interpolates),
        "knots_differ" => Judge::Law(laws::knots_differ),
        "octaves_add_up" => Judge::Law(laws::octaves_add_up),
        "texture_of_noise" => Judge::Law(laws::texture_of_noise),
        "bump_adds_noise" => Judge::Law(laws::bump_adds_noise),
        _ => return None,
    };
    Some((judge, in_scene.then_some(radiance::NAMER)))
}
