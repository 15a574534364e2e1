//! Why no golden sees some fields.

const DEFAULT: &str = "what counts if nothing is said: every golden without the field has it";
const DISPLAY: &str = "of display only, and goldens hold radiance; laws of `film` hold it";
const FILE: &str = "any other file would be another picture, and a scene without it is refused; readers have laws of their own";
const LAYERED: &str =
    "no file of the goldens has several layers; laws of image files read them by name";
const SPEED: &str = "changes the time, not the picture: each method finds the same hits, which is a law of chapter 22";
const TEXT: &str = "a text for people, or a name that other parts of the scene repeat; errors of wrong names are pinned";

/// The fields that no golden sees, each with the reason, in alphabetical order.
pub const REASONS: &[(&str, &str)] = &[
    ("acceleration method grid", SPEED),
    ("acceleration method list", SPEED),
    ("filter box", DEFAULT),
    ("image.gamma", DISPLAY),
    ("intersection routine robust", DEFAULT),
    (
        "light area.object",
        "no other object of these scenes is a lamp: every change is refused, and each lamp's other fields are seen",
    ),
    ("light.name", TEXT),
    ("material.name", TEXT),
    ("object.name", TEXT),
    ("out of gamut rule clamp_to_color", DISPLAY),
    ("part.name", TEXT),
    ("pattern image.file", FILE),
    ("pattern image.layer", LAYERED),
    ("scene.about", TEXT),
    ("shape mesh.file", FILE),
    ("texture image.file", FILE),
    ("texture image.layer", LAYERED),
];

/// The reason of a field, if it has one.
pub fn reason(field: &str) -> Option<&'static str> {
    REASONS.iter().find(|(known, _)| *known == field).map(|(_, reason)| *reason)
}
