//! Mistakes of tracers, cameras and pixels (Suffern, ch. 3, 9, 10, 24, 26, 27, 28).

use serde_json::{Value, json};

use super::super::super::mistakes as m;
use super::{Fields, Mistake, SceneMistake, bases, changes, instead, number, set, without};

pub(super) const ALL: &[SceneMistake] = changes! {
    "rays of mirrors and glass are left out", "ch. 24: whitted" => |data| {
        depth(data, |depth| if *depth == json!(0) { None } else { Some(0) })
    };
    "the depth of rays has no limit", "ch. 24: max_depth" => |data| depth(data, |_| Some(12));
    "light comes from lamps alone, none from other surfaces", "ch. 26: the path goes on" => |data| {
        depth(data, |depth| if *depth == json!(1) { None } else { Some(1) })
    };
    "1/π stands twice at every hit of a path", "ch. 26: f cos θ / pdf = kd cd" => |data| of_paths(data, std::f64::consts::FRAC_1_PI);
    "π is left over at every hit of a path", "ch. 26: f cos θ / pdf = kd cd" => |data| of_paths(data, std::f64::consts::PI);
    "a factor 2 stands at every hit of a path", "ch. 26: f cos θ / pdf = kd cd" => |data| of_paths(data, 2.0);
    "a factor ½ stands at every hit of a path", "ch. 26: f cos θ / pdf = kd cd" => |data| of_paths(data, 0.5);
    "the exposure time counts twice", "ch. 9: it is a factor" => |data| number(camera(data)?, "exposure_time", |x| x * x);
    "media around the camera do not absorb", "ch. 28: c^t from the eye on" => |data| without(camera(data)?, "medium");
    "attenuated shadows of glass are black", "docs/scene.md: [transparency]" => |data| {
        let shadows = scene(data)?.get_mut("transparency")?.as_object_mut()?;
        instead(shadows, "shadows", json!("opaque"))
    };
    "glass that blocks shadow rays lets them through", "ch. 27: shadows of glass are black" => |data| {
        set(scene(data)?, "transparency", json!({"shadows": "attenuated"}))
    };
    "refracted radiance is scaled although scales_radiance is false", "docs/scene.md: [transparency]" => |data| {
        let fields = scene(data)?.get_mut("transparency")?.as_object_mut()?;
        instead(fields, "scales_radiance", json!(true))
    };
    "the exposure time divides", "ch. 9: it is a factor" => |data| number(camera(data)?, "exposure_time", |x| 1.0 / x);
    "a sky turns the other way", "docs/scene.md: `rotate_y`" => |data| number(sky(data)?, "rotate_y", |x| -x);
    "a sky is not turned", "docs/scene.md: `rotate_y`" => |data| instead(sky(data)?, "rotate_y", json!(0.0));
    "the factor ls of a sky is left out", "docs/scene.md: `ls`" => |data| instead(sky(data)?, "ls", json!(1.0));
    "the image of a sky stands on its head", "ch. 29: v goes up" => |data| {
        sky(data)?.get_mut("texels")?.as_array_mut()?.reverse();
        Some(())
    };
    "the image of a sky is mirrored", "ch. 29: u goes from +z towards +x" => |data| {
        let rows = sky(data)?.get_mut("texels")?.as_array_mut()?;
        rows.iter_mut().filter_map(Value::as_array_mut).for_each(|row| row.reverse());
        Some(())
    };
    "the lens is a point", "ch. 10" => |data| instead(lens(data)?, "lens_radius", json!(0.0));
    "the radius of the lens is taken for its diameter", "ch. 10" => |data| number(lens(data)?, "lens_radius", |r| 0.5 * r);
    "the focal distance is measured from the view plane", "ch. 10: from the lens" => |data| {
        let distance = lens(data)?.get("distance")?.as_f64()?;
        number(lens(data)?, "focal_distance", |f| f + distance)
    };
};

/// Mistakes that conform has known before.
pub(super) const KNOWN: &[SceneMistake] = &[
    SceneMistake { mistake: &m::NO_PIXEL_SIZE, apply: |data| without(image(data)?, "pixel_size") },
    SceneMistake { mistake: &m::NO_ZOOM, apply: |data| without(lens(data)?, "zoom") },
    SceneMistake {
        mistake: &m::ZOOM_INVERTED,
        apply: |data| number(lens(data)?, "zoom", |zoom| 1.0 / zoom),
    },
    SceneMistake { mistake: &m::NO_ROLL, apply: |data| without(camera(data)?, "roll") },
    SceneMistake { mistake: &m::UPSIDE_DOWN, apply: |data| from_other_end(data, 1, "height") },
    SceneMistake { mistake: &m::MIRRORED, apply: |data| from_other_end(data, 0, "width") },
];

fn scene(data: &mut Value) -> Option<&mut Fields> {
    data.get_mut("scene")?.as_object_mut()
}

fn camera(data: &mut Value) -> Option<&mut Fields> {
    scene(data)?.get_mut("camera")?.as_object_mut()
}

fn sky(data: &mut Value) -> Option<&mut Fields> {
    scene(data)?.get_mut("background")?.get_mut("image")?.as_object_mut()
}

fn image(data: &mut Value) -> Option<&mut Fields> {
    scene(data)?.get_mut("image")?.as_object_mut()
}

fn lens(data: &mut Value) -> Option<&mut Fields> {
    camera(data)?.get_mut("lens")?.as_object_mut()?.values_mut().next()?.as_object_mut()
}

/// Changes the depth of the tracer.
fn depth(data: &mut Value, change: fn(&Value) -> Option<u32>) -> Option<()> {
    let tracer = scene(data)?.get_mut("tracer")?.as_object_mut()?;
    let fields = tracer.values_mut().next()?.as_object_mut()?;
    let other = change(fields.get("max_depth")?)?;
    set(fields, "max_depth", json!(other))
}

/// Scales what diffuse surfaces reflect, where paths go on from them.
fn of_paths(data: &mut Value, factor: f64) -> Option<()> {
    let tracer = scene(data)?.get("tracer")?.as_object()?;
    let _ = ["path_trace", "global_trace", "path"].iter().find_map(|path| tracer.get(*path))?;
    bases(data, |base| number(base, "kd", |kd| factor * kd))
}

/// Counts the pixel's columns or rows from the other end.
fn from_other_end(data: &mut Value, axis: usize, side: &str) -> Option<()> {
    let size = image(data)?.get(side)?.as_u64()?;
    let slot = data.get_mut("pixel")?.get_mut(axis)?;
    *slot = json!(size.checked_sub(1 + slot.as_u64()?)?);
    Some(())
}
