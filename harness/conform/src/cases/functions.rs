//! What files of families call by name because it needs more than ranges and choices.

use serde_json::{Value, json};

use crate::judgement::triple;
use exact::Draw;

/// From arguments to a value; `None` if they are no such arguments.
pub type Function = fn(&mut Draw, &[Value]) -> Option<Value>;

/// The function of this name.
pub fn function(name: &str) -> Option<Function> {
    Some(match name {
        "direction" => |draw, _| Some(json!(draw.direction().to_array())),
        "up" => |draw, _| {
            let [x, y, z] = draw.direction().to_array();
            Some(json!([x, y.abs(), z]))
        },
        "unequal" => |_, of| {
            let [a, b] = of else { return None };
            Some(json!(a.as_u64()? + u64::from(a == b)))
        },
        "shadow" => |_, of| Some(json!(shadow(triple(of.first()?)?, triple(of.get(1)?)?))),
        _ => return None,
    })
}

/// The shadow on the ground of a point in the light of a lamp; the point itself if there is none.
fn shadow(of: [f64; 3], lamp: [f64; 3]) -> [f64; 3] {
    let height = lamp[1] - of[1];
    if height < 0.1 {
        return of;
    }
    let along = (of[1] / height).min(4.0);
    std::array::from_fn(|i| of[i] + along * (of[i] - lamp[i]))
}
