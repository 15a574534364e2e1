//! What the mouse points at among lines on the screen.

use eframe::egui::{Pos2, Vec2};

/// The distance from a line within which the mouse points at it, in points of the screen.
const REACH: f32 = 6.0;

/// The ray whose line is nearest to a place on the screen, if that is within reach.
pub fn nearest(drawn: &[(usize, [Pos2; 2])], at: Pos2) -> Option<usize> {
    let distance = |[from, to]: [Pos2; 2]| -> f32 {
        let way: Vec2 = to - from;
        let part = ((at - from).dot(way) / way.length_sq()).clamp(0.0, 1.0);
        if part.is_nan() { from.distance(at) } else { (from + part * way).distance(at) }
    };
    let nearest = drawn.iter().map(|(ray, line)| (*ray, distance(*line)));
    // of equal ones the last, which is drawn over the others
    let nearest = nearest.rev().min_by(|a, b| a.1.total_cmp(&b.1));
    nearest.filter(|(_, distance)| *distance <= REACH).map(|(ray, _)| ray)
}
