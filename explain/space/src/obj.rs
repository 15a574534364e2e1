//! The rays of a tree as lines of an OBJ file, for modelling programs.

use std::fmt::Write;

use explain::RecordedRay;
use groundtruth::printable;

use super::{Role, Segment};

/// The pieces of the rays of a tree as an OBJ file: two vertices and a line for each, in one group for each kind of ray.
/// All digits are kept; `about` stands in the first line as a comment.
pub fn obj(root: &RecordedRay, segments: &[Segment], about: &str) -> String {
    let rays = root.rays();
    let mut text = format!("# {}\n", printable::name(about));
    let mut vertices = 0;
    for (role, group, _) in Role::RAYS {
        let is_of = |segment: &&Segment| {
            // numbers are places in the list
            let ray = rays.get(segment.ray - root.number);
            ray.is_some_and(|ray| Role::of(ray.kind, segment.end) == role)
        };
        let mut pieces = segments.iter().filter(is_of).peekable();
        if pieces.peek().is_some() {
            let _ = writeln!(text, "g {group}");
        }
        for Segment { ray, from, to, .. } in pieces {
            let _ = writeln!(text, "# ray {ray}");
            for [x, y, z] in [from.to_array(), to.to_array()] {
                let _ = writeln!(text, "v {x} {y} {z}");
            }
            let _ = writeln!(text, "l {} {}", vertices + 1, vertices + 2);
            vertices += 2;
        }
    }
    text
}
