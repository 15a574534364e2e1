//! Which light is in the picture: the tracer, shadows, normals and media, in words.

use serde_json::Value;

use groundtruth::scene::{Scene, Tracer, TransparentShadows};

use super::tables::{absorbs, all_of, field_of_scene, has, tag};
use super::texts::text;
use super::values::DescribedValues;

/// The section of the tracer.
pub fn write(to: &mut DescribedValues, scene: &Scene, data: &Value) {
    to.page.heading("Light along a ray");
    to.page.blank();
    to.value(0, "tracer", &data["tracer"], field_of_scene("tracer"));
    to.page.tell("light");
    if has_two_normals(data) {
        to.page.tell("two normals");
    }
    to.page.tell(&format!("tracer: {}", tag(&data["tracer"])));
    let mut its = scene.tracer;
    if let Some(depth) = its.max_depth() {
        to.page.fill("depth", &[("depth", depth.to_string())]);
    }
    if let Some(transparency) = data.get("transparency") {
        to.page.blank();
        to.value(0, "transparency", transparency, field_of_scene("transparency"));
    }
    shadows(to, scene, data);
    if absorbs(data) {
        to.page.tell("media");
    }
}

/// Whether some surface is shaded with another normal than its own.
fn has_two_normals(data: &Value) -> bool {
    let smooth = all_of(data, "smooth").contains(&&Value::Bool(true));
    smooth || has(data, "normals") || has(data, "bump")
}

fn shadows(to: &mut DescribedValues, scene: &Scene, data: &Value) {
    let is_path = !matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_));
    let mut shadows = text("shadows");
    if is_path {
        shadows += &format!(" {}", text("shadows of paths"));
    }
    to.page.say(&shadows);
    if !(has(data, "dielectric") || has(data, "transparent")) {
        return;
    }
    let transparent = match scene.transparency.shadows {
        TransparentShadows::Opaque => "transparent: opaque",
        TransparentShadows::Attenuated => "transparent: attenuated",
    };
    to.page.tell(transparent);
    if !scene.transparency.scales_radiance {
        to.page.tell("unscaled");
    }
}
