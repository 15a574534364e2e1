//! Mistakes that people make, each with its place in the book; and how wrong answers give them away.
//!
//! A judge lists, for one wrong answer, the mistakes that give exactly this answer. A family is named by the few
//! mistakes that explain most of its wrong answers, each with how many it explains.

use std::f64::consts::PI;

use serde_json::Value;

use super::judgement::Wrong;

/// A mistake.
#[derive(Debug, PartialEq)]
pub struct Mistake {
    /// What was done.
    pub name: &'static str,
    /// Where the book has it right, or what to read.
    pub place: &'static str,
    /// A scene of the gallery in whose picture it shows.
    pub scene: Option<&'static str>,
}

macro_rules! mistakes {
    ($($name:ident: $text:literal, $place:literal $(, $scene:literal)?;)*) => {
        $(
            #[doc = $text]
            pub static $name: Mistake = Mistake {
                name: $text,
                place: $place,
                scene: [$(Some($scene),)? None][0],
            };
        )*

        /// All of them.
        pub static ALL: &[&Mistake] = &[$(&$name),*];
    };
}

mistakes! {
    // intersections
    FAR_ROOT: "the far root", "ch. 3: the smallest t > ε counts", "ch03/three-objects";
    BEHIND: "a hit behind the origin", "ch. 3: hits count for t > ε only";
    UNIT_ASSUMED: "t is counted in a unit direction", "ch. 3, 19: a = d·d, which is 1 only for unit d", "ch21/ellipsoid";
    NOT_NORMALISED_LENGTH: "a direction is not normalised", "ch. 3, 9: normals and camera rays are unit";
    NEGATED: "the sign is wrong", "the sign of every component";
    TO_VIEWER: "the normal is turned to the viewer", "docs/probe.md: `normal` is geometric, never turned", "ch28/glass-sphere";
    NORMAL_BY_MATRIX: "the normal is transformed as a vector", "ch. 21: normals go by the inverse transpose", "ch21/ellipsoid";
    NORMAL_UNTRANSFORMED: "the normal is left in object space", "ch. 21: normals go by the inverse transpose";
    INSIDE_MISSED: "hits from inside are missed", "ch. 3: if the near root is behind, test the far root", "ch28/glass-sphere";
    ONE_SIDED: "back sides are missed", "ch. 3, 19: flat shapes are hit from both sides";
    TO_VIEWER_BY_THE_BOOK: "the normal is turned to the viewer, and the book does this, too", "docs/book-card.md, \"Conventions\"";
    NORMAL_BY_INVERSE: "the normal is transformed by the inverse, not its transpose", "ch. 21: normals go by the inverse transpose", "ch21/ellipsoid";
    NORMAL_BY_TRANSPOSE: "the normal is transformed by the transpose, not that of the inverse", "ch. 21: normals go by the inverse transpose", "ch21/ellipsoid";
    CANCELLATION: "digits are lost in b² − 4ac", "docs/book-card.md: ch. 3 subtracts nearly equal numbers if the ray starts far away";
    T_NOT_SET: "t is never set", "ch. 3: hit() has to write tmin where it returns true";
    ALWAYS_NULL: "nothing is ever hit", "ch. 3: hit() returns false for every ray";
    NO_SHADOW_HIT: "shadow rays never hit it: is there a shadow_hit for this kind?", "ch. 16: the one of GeometricObject returns false", "ch16/shadows";
    ALWAYS_BLOCKED: "shadow rays always hit it", "ch. 16: shadow_hit returns true only where t lies before the light", "ch16/shadows";
    CONE_NORMAL_SQUARE: "the cone's normal is right for h = r² only", "ch. 19: the gradient is (h² x / r², h − y, h² z / r²)";
    CONE_NORMAL_EQUAL: "the cone's normal is right for h = r only", "ch. 19: the gradient is (h² x / r², h − y, h² z / r²)";
    CENTER_FORGOTTEN: "the centre is left out of the normal", "ch. 3: normal = (o − c + t d) / r", "ch03/three-objects";
    NEAREST_ONLY: "the nearest hit alone", "docs/probe.md: `all` asks for every root";
    SPAN_IGNORED: "the span is ignored", "docs/probe.md: hits count if min < t < max";
    OCCLUDER_BEYOND: "occluders beyond the end count", "ch. 16: shadow rays end at the light", "ch16/shadows";
    MISSED: "hits are missed", "ch. 3, 19: is a bound, a border or ε too strict?";
    // numbers
    ZERO: "0: the value is left out", "is a term missing, or a variable never set?";
    BLACK: "black: the light is left out", "is a term missing, or a variable never set?";
    ALWAYS: "the same value every time", "is a variable never set?";
    DIVIDED_BY_ZERO_ANGLE: "0/0 in the middle of the picture", "ch. 11: where r = 0 there is no angle, and the direction is −w";
    DIVIDED_BY_ZERO_AXIS: "0/0 on the axis of the mapping", "ch. 29: where d = 0, u = v = 1/2";
    NAN_AS_INTEGER: "NaN, from 0/0 on the axis of a light probe, cast to an integer: the first pixel", "ch. 29: where d = 0, u = v = 1/2";
    TIMES_PI: "π times too large", "ch. 13: a Lambertian BRDF is ρ/π", "ch14/set";
    OVER_PI: "π times too small", "ch. 13, 14: π is left out, or divided out twice", "ch14/set";
    TIMES_TWO: "twice as large", "a factor 2";
    HALF: "half as large", "a factor ½";
    TIMES_2PI: "2π times too large", "ch. 7: the density of the hemisphere";
    OVER_2PI: "2π times too small", "ch. 7: the density of the hemisphere";
    TIMES_4PI: "4π times too large", "ch. 18: the density of the sphere";
    OVER_4PI: "4π times too small", "ch. 18: the density of the sphere";
    DEGREES: "degrees for radians", "ch. 2: radians = π/180 × degrees";
    RADIANS: "radians for degrees", "ch. 2: radians = π/180 × degrees";
    SQUARED: "the square of the value", "a square too many";
    ROOT: "the square root of the value", "a square is left out";
    INVERSE: "the reciprocal of the value", "the ratio is upside down";
    COMPLEMENT: "1 minus the value", "the complement";
    // components
    SWAP_XY: "the first two components are swapped", "the order of components";
    SWAP_YZ: "the last two components are swapped", "y is up in the book";
    SWAP_XZ: "the first and the third component are swapped", "the order of components";
    FLIP_X: "the first component has the wrong sign", "ch. 2: axes are right-handed";
    FLIP_Y: "the second component has the wrong sign", "ch. 3: rows of pixels count from the bottom in the book, from the top in files";
    FLIP_Z: "the third component has the wrong sign", "ch. 2: axes are right-handed";
    SWAP_RG: "red and green are exchanged", "colours are (r, g, b)";
    SWAP_GB: "green and blue are exchanged", "colours are (r, g, b)";
    SWAP_RB: "red and blue are exchanged", "colours are (r, g, b); some image files are (b, g, r)";
    ONLY_RED: "the red channel for all three", "colours are multiplied channel by channel";
    NO_RED: "red is left out", "all three channels count";
    NO_GREEN: "green is left out", "all three channels count";
    NO_BLUE: "blue is left out", "all three channels count";
    MIRROR_U: "1 − u for u", "ch. 29: φ goes from +z to +x";
    MIRROR_V: "1 − v for v", "ch. 29: v goes up, rows of files go down", "ch29/earth";
    TRANSPOSED: "rows for columns", "ch. 20: points are columns";
    // lobes and optics
    WITH_COS: "with the cosine of the incoming direction", "ch. 13: f has no cosine", "ch14/set";
    WITHOUT_COS: "without the cosine of the incoming direction", "ch. 13, 26: the weight is f cos θ / pdf", "ch26/cornell-box";
    NO_ETA_SQUARED: "ours × η²: 1/η² is left out", "ch. 27: radiance is divided by η² when it enters", "ch28/snell-window";
    ETA_SQUARED_TWICE: "ours / η²: 1/η² twice", "ch. 27: radiance is divided by η² when it enters", "ch28/snell-window";
    ETA_INVERTED: "η upside down", "ch. 27, 28: η = η_in / η_out, inverted when the ray is inside", "ch28/snell-window";
    ONLY_S: "light polarised across the plane of incidence alone", "ch. 28: the mean of both polarisations";
    MEAN_OF_AMPLITUDES: "the mean of the amplitudes, not of their squares", "ch. 28: kr = (r∥² + r⊥²) / 2";
    REFLECTED_INSTEAD: "the reflected direction for the refracted one", "ch. 27: t leaves behind the surface";
    ETA_MULTIPLIED: "−η ωo for −ωo/η in the refracted direction", "ch. 27: t = −ωo/η − (cosθt − cosθi/η) n", "ch27/common-set";
    INDEX_ZERO: "the index is 0, or never set: everything is reflected", "ch. 27: the constructor sets η", "ch28/glass-sphere";
    ONLY_P: "light polarised in the plane of incidence alone", "ch. 28: the mean of both polarisations";
    SCHLICK: "Schlick's approximation", "ch. 28: Fresnel's equations";
    SWAPPED_DIRECTIONS: "wi and wo exchanged", "ch. 13: wo points to the viewer, wi to the light";
    EXPONENT_OFF: "the exponent is larger by 1", "ch. 7: cosᵉθ has the density (e + 1) cosᵉθ / 2π";
    NO_EXPONENT: "the exponent is 1", "ch. 7, 15";
    // lights
    FROM_LIGHT: "the direction goes away from the light", "ch. 14: wi points to the light", "ch14/set";
    NO_FALL_OFF: "distance attenuation is left out", "ch. 14: radiance over dⁿ";
    TIMES_DISTANCE: "the direction is not made unit", "ch. 14: wi is unit";
    DISTANCE_SQUARED: "the square of the distance", "a root is left out";
    SUN_NOT_NORMALISED: "the sun's direction is not normalised", "ch. 14: l is unit";
    // cameras
    WHOLE_ANGLE: "the whole angle of view for half of it", "ch. 11: ψ_max is half of the field of view";
    QUARTER_ANGLE: "half of the angle of view is halved again", "ch. 11: ψ_max is half of the field of view";
    TURNED_BY_HALF: "the picture is turned by 180°", "ch. 9: u = up × w, v = w × u";
    CORNERS: "the corner of the pixel for its middle", "ch. 3: x = s (c − hres/2 + 0.5)", "ch03/three-objects";
    UPSIDE_DOWN: "rows from the bottom", "docs/probe.md: row 0 is at the top";
    MIRRORED: "the picture is mirrored: columns from the right", "ch. 9: u = up × w, not w × up";
    INTEGER_HALF: "half of an odd number of pixels is rounded down", "ch. 3: hres / 2 is a real number";
    AXES_SWAPPED: "u and v are exchanged", "ch. 9: u points right, v up";
    PLACE_DOWN: "the place in the pixel counts from the top", "docs/probe.md: `place` starts at the lower left corner";
    NO_PIXEL_SIZE: "the pixel size is left out", "ch. 3: x = s (c − hres/2 + 0.5)";
    NO_ROLL: "the roll angle is left out", "ch. 9";
    ROLL_REVERSED: "the camera rolls in the opposite sense", "ch. 9: a positive roll turns the camera counterclockwise";
    ZOOM_INVERTED: "the zoom is upside down", "ch. 9: the pixel size is divided by the zoom";
    NO_ZOOM: "the zoom is left out", "ch. 9: the pixel size is divided by the zoom";
    BACKWARDS: "the camera looks along +w", "ch. 9: the camera looks along −w";
    // samples and maps
    SWAP_U: "the two numbers of u are swapped", "ch. 5 to 7: which of the two is the radius";
    COMPLEMENT_U: "1 − u for u", "ch. 7: cos θ = (1 − r₂)^(1/(e+1))";
    PLAIN_DISK: "rings of equal width for rings of equal area", "ch. 6: the concentric map";
    // textures, transforms, grids
    REVERSED_STEPS: "the steps are applied last to first", "ch. 20: the last matrix of a product acts first", "ch21/ellipsoid";
    INVERSE_FOR_MATRIX: "the inverse for the matrix", "ch. 21: the ray goes by the inverse";
    TURNED_BACKWARDS: "rotations turn the other way", "ch. 20: counterclockwise, seen against the axis";
    SWAPPED_COLORS: "the two colours are exchanged", "ch. 30: color1 where the sum of the three floors is even", "ch30/solid-checkers";
    TRUNCATED_FLOOR: "numbers are truncated instead of rounded down", "ch. 30: ⌊−0.3⌋ = −1", "ch30/solid-checkers";
    IMAGE_UPSIDE_DOWN: "the image stands on its head", "ch. 29: row 0 of a texture is at the bottom, row 0 of a file at the top", "ch29/earth";
    IMAGE_MIRRORED: "the image is mirrored", "ch. 29: u goes to the right";
    NEAREST_FOR_BILINEAR: "the nearest texel, without interpolation", "ch. 29: filtering";
    BOOK_RULE: "n for n − 1 of the columns and rows, or the other way round", "docs/book-card.md: ch. 29, texels";
    WRAPS_CLAMPED: "coordinates outside 0 … 1 are clamped", "ch. 29: wraps";
    WRAPS_REPEATED: "the image always repeats", "ch. 29: wraps";
    WRAPS_SWAPPED: "the wraps of u and v are exchanged", "ch. 29: wraps";
    NO_UNIT: "the unit of the mapping is left out", "ch. 29: generic objects have radius 1";
    // meshes
    FLAT_FOR_SMOOTH: "the normal of the face, not interpolated", "ch. 23: n = (1 − β − γ) n0 + β n1 + γ n2", "ch23/smooth-sphere";
    NO_VERTEX_NORMALS: "the normals of the vertices are left out", "ch. 23";
    REVERSED_FORGOTTEN: "reverse_normals is left out", "ch. 23: reverse_normal";
    MESH_SCALE: "the scale of the mesh is left out", "docs/scene.md: scale";
    NO_SIZE: "the size is left out", "ch. 30: coordinates over the size";
    ONE_CELL_LESS: "one cell less along each axis", "ch. 22: n = ⌊m w / s⌋ + 1";
    NO_MULTIPLIER: "the multiplier is left out", "ch. 22: m = 2";
    IN_BLACK_SHADOW: "the light is left out", "ch. 14, 16", "ch16/shadows";
    NO_SHADOWS: "shadows are left out", "ch. 16", "ch16/shadows";
    NO_AMBIENT: "ambient light is left out", "ch. 14: ka cd L_a is added once", "ch14/set";
}

/// Factors by which whole answers are off.
static FACTORS: [(&Mistake, f64); 11] = [
    (&TIMES_PI, PI),
    (&OVER_PI, 1.0 / PI),
    (&TIMES_TWO, 2.0),
    (&HALF, 0.5),
    (&TIMES_2PI, 2.0 * PI),
    (&OVER_2PI, 0.5 / PI),
    (&TIMES_4PI, 4.0 * PI),
    (&OVER_4PI, 0.25 / PI),
    (&DEGREES, 180.0 / PI),
    (&RADIANS, PI / 180.0),
    (&NEGATED, -1.0),
];

/// How closely a mistake has to explain an answer, relative to its largest number: programs in single precision
/// make mistakes, too.
const CLOSE: f64 = 1e-5;

/// Whether the numbers are the same, as far as a mistake is to be told.
pub fn same(theirs: &[f64], alternative: &[f64]) -> bool {
    let largest = alternative.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let close = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= CLOSE * largest;
    theirs.len() == alternative.len() && theirs.iter().zip(alternative).all(close)
}

/// The mistakes that turn the right numbers into theirs: factors, signs, exchanged components.
pub fn clues(theirs: &[f64], right: &[f64]) -> Vec<&'static Mistake> {
    let mut clues = Vec::new();
    let mut candidate = |mistake, alternative: &[f64]| {
        clues.extend(matched(mistake, alternative, theirs, right));
    };
    candidate(&ZERO, &vec![0.0; right.len()]);
    for (mistake, factor) in &FACTORS {
        let scaled: Vec<f64> = right.iter().map(|x| factor * x).collect();
        candidate(mistake, &scaled);
    }
    match *right {
        [x] => {
            candidate(&SQUARED, &[x * x]);
            candidate(&ROOT, &[x.abs().sqrt()]);
            candidate(&INVERSE, &[1.0 / x]);
            candidate(&COMPLEMENT, &[1.0 - x]);
        }
        [x, y] => {
            candidate(&SWAP_XY, &[y, x]);
            candidate(&FLIP_X, &[-x, y]);
            candidate(&FLIP_Y, &[x, -y]);
            candidate(&MIRROR_U, &[1.0 - x, y]);
            candidate(&MIRROR_V, &[x, 1.0 - y]);
        }
        [x, y, z] => {
            candidate(&SWAP_XY, &[y, x, z]);
            candidate(&SWAP_YZ, &[x, z, y]);
            candidate(&SWAP_XZ, &[z, y, x]);
            candidate(&FLIP_X, &[-x, y, z]);
            candidate(&FLIP_Y, &[x, -y, z]);
            candidate(&FLIP_Z, &[x, y, -z]);
            let length = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
            if (length(right) - 1.0).abs() < CLOSE && theirs.len() == 3 {
                let scaled = [x, y, z].map(|x| length(theirs) * x);
                candidate(&NOT_NORMALISED_LENGTH, &scaled);
            }
        }
        _ => {}
    }
    clues
}

/// The same for a colour, whose components are channels and not axes.
pub fn clues_of_color(theirs: &[f64], right: &[f64]) -> Vec<&'static Mistake> {
    let mut clues = Vec::new();
    let mut candidate = |mistake, alternative: &[f64]| {
        clues.extend(matched(mistake, alternative, theirs, right));
    };
    let [r, g, b] = *right else { return clues };
    candidate(&BLACK, &[0.0; 3]);
    for (mistake, factor) in &FACTORS {
        candidate(mistake, &[r, g, b].map(|x| factor * x));
    }
    candidate(&SWAP_RG, &[g, r, b]);
    candidate(&SWAP_GB, &[r, b, g]);
    candidate(&SWAP_RB, &[b, g, r]);
    candidate(&ONLY_RED, &[r, r, r]);
    candidate(&NO_RED, &[0.0, g, b]);
    candidate(&NO_GREEN, &[r, 0.0, b]);
    candidate(&NO_BLUE, &[r, g, 0.0]);
    candidate(&SQUARED, &[r * r, g * g, b * b]);
    candidate(&ROOT, &[r, g, b].map(|x| x.abs().sqrt()));
    candidate(&COMPLEMENT, &[1.0 - r, 1.0 - g, 1.0 - b]);
    clues
}

/// The mistake, if it gives theirs; an alternative that is right explains nothing.
fn matched(
    mistake: &'static Mistake,
    alternative: &[f64],
    theirs: &[f64],
    right: &[f64],
) -> Option<&'static Mistake> {
    (same(theirs, alternative) && !same(right, alternative)).then_some(mistake)
}

/// The one factor between theirs and the right numbers, if there is one.
pub fn ratio(theirs: &[f64], right: &[f64]) -> Option<f64> {
    let largest = |numbers: &[f64]| {
        (0..numbers.len()).max_by(|&i, &j| numbers[i].abs().total_cmp(&numbers[j].abs()))
    };
    let at = largest(right)?;
    let ratio = theirs.get(at)? / right[at];
    let scaled: Vec<f64> = right.iter().map(|x| ratio * x).collect();
    // 0 is no factor: something is left out
    (ratio.is_finite() && ratio != 0.0 && same(theirs, &scaled)).then_some(ratio)
}

/// What explains wrong answers of a family.
#[derive(Clone, Debug, PartialEq)]
pub enum Name {
    /// A known mistake.
    Known {
        /// The mistake.
        mistake: &'static Mistake,
        /// How many wrong answers it explains.
        explains: usize,
        /// Of how many.
        of: usize,
    },
    /// A constant factor that is none of the known ones.
    Factor(f64),
}

/// The least share of the wrong answers that a name has to explain, as a divisor.
const SHARE: usize = 3;
/// Names for the same wrong answers: more would only say that one cannot tell.
const MOST_ALIKE: usize = 2;
/// A factor this close to 1 is an error of rounding or of a constant, and is not named.
const NEAR_ONE: f64 = 1e-4;

/// The names of a family's wrong answers: in each step the mistake that explains most of those not yet explained,
/// until none explains a third of all. Of mistakes that explain the same answers, the most specific are named, at most
/// two. Of a single answer, known mistakes only: one ratio says nothing.
pub fn names(wrong: &[Wrong]) -> Vec<Name> {
    let mut open: Vec<usize> = (0..wrong.len()).collect();
    let mut names = Vec::new();
    while !open.is_empty() {
        let best = most_explaining(wrong, &open);
        let Some(first) = best.first() else { break };
        let explained = |index: &usize| wrong[*index].clues.contains(first);
        let count = open.iter().filter(|index| explained(index)).count();
        if count < wrong.len() && count < wrong.len().div_ceil(SHARE).max(2) {
            break;
        }
        open.retain(|index| !explained(index));
        names.extend(best.into_iter().map(|mistake| {
            let explains = wrong.iter().filter(|one| one.clues.contains(&mistake)).count();
            Name::Known { mistake, explains, of: wrong.len() }
        }));
    }
    let is_vague = |name: &Name| matches!(name, Name::Known { mistake, .. } if tier(mistake) == LEAST_SPECIFIC);
    if names.iter().all(is_vague) && has_one_value(wrong) {
        names = vec![Name::Known { mistake: &ALWAYS, explains: wrong.len(), of: wrong.len() }];
    }
    if names.is_empty() {
        names.extend(common_factor(wrong).map(Name::Factor));
    }
    names
}

/// The name of a family whose answers are all this one, if its wrong answers have no better name.
pub fn always(question: &str, answer: &Value, names: &[Name], wrong: &[Wrong]) -> Option<Name> {
    let is_vague = |name: &Name| match name {
        Name::Known { mistake, .. } => tier(mistake) == LEAST_SPECIFIC,
        Name::Factor(_) => false,
    };
    let mistake = match (question, answer) {
        ("occluded", Value::Bool(false)) => &NO_SHADOW_HIT,
        ("occluded", Value::Bool(true)) => &ALWAYS_BLOCKED,
        ("intersect", Value::Null) => &ALWAYS_NULL,
        _ => return None,
    };
    let is_named = wrong.len() >= 2 && names.iter().all(is_vague);
    is_named.then_some(Name::Known { mistake, explains: wrong.len(), of: wrong.len() })
}

/// Whether all answers are the same numbers, though others are right.
fn has_one_value(wrong: &[Wrong]) -> bool {
    let [first, second, third, others @ ..] = wrong else { return false };
    let rights: std::collections::BTreeSet<&str> =
        wrong.iter().map(|one| one.expected.as_str()).collect();
    let is_same = |other: &Wrong| other.theirs == first.theirs && other.symptom == first.symptom;
    let is_zero = first.theirs.iter().all(|x| *x == 0.0);
    !is_zero && rights.len() >= 3 && [second, third].into_iter().chain(others).all(is_same)
}

/// The mistake that explains most of these answers, and those that explain the same ones and are as specific.
fn most_explaining(wrong: &[Wrong], open: &[usize]) -> Vec<&'static Mistake> {
    let explained = |mistake: &Mistake| -> Vec<usize> {
        open.iter().copied().filter(|index| wrong[*index].clues.contains(&mistake)).collect()
    };
    let mut candidates: Vec<(&'static Mistake, Vec<usize>)> = Vec::new();
    for mistake in open.iter().flat_map(|index| &wrong[*index].clues) {
        if !candidates.iter().any(|(known, _)| known == mistake) {
            candidates.push((mistake, explained(mistake)));
        }
    }
    // stable: of equals, the order in which the judges found them
    candidates.sort_by_key(|(mistake, all)| (std::cmp::Reverse(all.len()), tier(mistake)));
    let Some((first, most)) = candidates.first().cloned() else { return Vec::new() };
    let is_equal = |(mistake, all): &(&'static Mistake, Vec<usize>)| {
        *all == most && tier(mistake) == tier(first)
    };
    let equal = candidates.into_iter().filter(is_equal).map(|(mistake, _)| mistake);
    equal.take(MOST_ALIKE).collect()
}

/// The tier of what says least.
const LEAST_SPECIFIC: u8 = 2;

/// How specific a mistake is: 0 says what was done, 1 how components differ, 2 how numbers differ.
fn tier(mistake: &Mistake) -> u8 {
    let components = [
        &SWAP_XY,
        &SWAP_YZ,
        &SWAP_XZ,
        &FLIP_X,
        &FLIP_Y,
        &FLIP_Z,
        &SWAP_RG,
        &SWAP_GB,
        &SWAP_RB,
        &ONLY_RED,
        &NO_RED,
        &NO_GREEN,
        &NO_BLUE,
        &MIRROR_U,
        &MIRROR_V,
        &BLACK,
        &ZERO,
        &NEGATED,
        &NOT_NORMALISED_LENGTH,
    ];
    let numbers = [&SQUARED, &ROOT, &INVERSE, &COMPLEMENT, &MISSED];
    if components.contains(&mistake) {
        1
    } else if numbers.contains(&mistake) || FACTORS.iter().any(|(factor, _)| *factor == mistake) {
        LEAST_SPECIFIC
    } else {
        0
    }
}

/// The one factor by which all answers are off.
fn common_factor(wrong: &[Wrong]) -> Option<f64> {
    let ratios = wrong.iter().map(|one| one.ratio).collect::<Option<Vec<f64>>>()?;
    let [ratio, others @ ..] = &ratios[..] else { return None };
    let is_common = others.len() >= 2 && others.iter().all(|other| same(&[*other], &[*ratio]));
    (is_common && (ratio - 1.0).abs() > NEAR_ONE).then_some(*ratio)
}

impl std::fmt::Display for Name {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Known { mistake: Mistake { name, place, scene }, explains, of } => {
                write!(f, "{name} ({place}")?;
                scene.iter().try_for_each(|scene| write!(f, "; seen in {scene}"))?;
                write!(f, ")")?;
                if explains < of { write!(f, ", explains {explains} of {of}") } else { Ok(()) }
            }
            Self::Factor(factor) => write!(f, "theirs = ours × {}, every time", digits(*factor)),
        }
    }
}

/// A number with six digits.
fn digits(x: f64) -> String {
    if (1e-4..1e6).contains(&x.abs()) { format!("{x:.6}") } else { format!("{x:.5e}") }
}
