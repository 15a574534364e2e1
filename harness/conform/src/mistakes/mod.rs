//! Mistakes that people make, each with its place in the book; and how wrong answers give them away.
//!
//! Those of which a picture can be made are entries of the catalogue, [`judge::mistakes::known`]; the others are told by
//! numbers alone.
//!
//! A judge lists, for one wrong answer, the mistakes that give exactly this answer. A family is named by the mistake that
//! explains nearly all of its wrong answers, and would have changed none of the right ones.

mod clues;
mod names;

use judge::mistakes::known::{self, KnownMistake};
use judge::mistakes::{find, scenes_that_show};

pub use clues::{FACTORS, clues, clues_of_color, other_colors, ratio, same};
pub use names::{Name, agree, always, names, suspects};

/// A mistake.
#[derive(Debug)]
pub struct Mistake {
    /// What was done.
    pub name: &'static str,
    /// Where the book has it right, or what to read.
    pub place: &'static str,
    /// A scene of the gallery in whose picture it shows; of entries of the catalogue the table has it.
    pub scene: Option<&'static str>,
    /// The name of its entry in the catalogue, as `verify` and `mistakes` print it.
    pub picture: Option<&'static str>,
}

impl Mistake {
    /// A mistake that only answers tell.
    pub const fn of_answers(
        name: &'static str,
        place: &'static str,
        scene: Option<&'static str>,
    ) -> Self {
        Self { name, place, scene, picture: None }
    }

    /// An entry of the catalogue, as answers of single functions tell it.
    pub const fn of_pictures(known: &KnownMistake) -> Self {
        let KnownMistake { name, words, place, clue, .. } = *known;
        let told = match clue {
            Some(clue) => clue,
            None => words,
        };
        Self { name: told, place, scene: None, picture: Some(name) }
    }

    /// The scene of the gallery that shows it, or shows it best.
    pub fn seen_in(&self) -> Option<&'static str> {
        let best = |name| Some(scenes_that_show(find(name)?).first()?.scene);
        self.scene.or_else(|| best(self.picture?))
    }
}

/// Two are the same if they are of one entry of the catalogue, in whichever words they are told.
impl PartialEq for Mistake {
    fn eq(&self, other: &Self) -> bool {
        match (self.picture, other.picture) {
            (None, None) => (self.name, self.place) == (other.name, other.place),
            (ours, theirs) => ours == theirs,
        }
    }
}

/// Entries of the catalogue that answers of single functions give away.
macro_rules! known {
    ($($name:ident)*) => {$(
        #[doc = concat!("As [`known::", stringify!($name), "`].")]
        pub static $name: Mistake = Mistake::of_pictures(&known::$name);
    )*};
}

known! {
    CHECKER_TRUNCATED ETA_INVERTED FLAT_SHADING FRESNEL_PARALLEL_ONLY FRESNEL_PERPENDICULAR_ONLY
    HALF_FIELD_OF_VIEW HIGHLIGHT_OF_HALF_VECTOR LAMP_TWO_SIDED LENS_RADIUS_DOUBLED NORMAL_BY_MATRIX
    NO_AMBIENT NO_ETA_SQUARED NO_FALL_OFF NO_LAMP_AREA NO_LAMP_COSINE NO_LAMP_DISTANCE NO_SHADOWS
    ONE_OCTAVE_LESS PIXEL_CORNER ROLL_REVERSED SCHLICK SHADOW_RAYS_WITHOUT_END SUN_NOT_NORMALISED
    TEXTURE_COLOURS_EXCHANGED TEXTURE_MIRRORED TEXTURE_NEAREST TEXTURE_OF_OTHER_RULE
    TEXTURE_UPSIDE_DOWN WHOLE_FIELD_OF_VIEW
}

macro_rules! mistakes {
    ($($name:ident: $text:literal, $place:literal $(, $scene:literal)?;)*) => {
        $(
            #[doc = $text]
            pub static $name: Mistake =
                Mistake::of_answers($text, $place, [$(Some($scene),)? None][0]);
        )*

        /// All that only answers tell.
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
    MISSED: "hits are missed", "ch. 3, 19: there is a root, and the answer has none";
    // numbers
    ZERO: "0: the value is left out", "is a term missing, or a variable never set?";
    BLACK: "black: the light is left out", "is a term missing, or a variable never set?";
    CLAMPED: "values are cut off at 1", "docs/probe.md: radiance has no upper limit";
    GAMMA: "the radiance is encoded for a screen, with an exponent of 1/2.2", "docs/probe.md: radiance is linear";
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
    QUARTER_PI: "π/4 times as large", "ch. 6, 18: a disk has π/4 of the area of the square around it";
    FOUR_OVER_PI: "4/π times as large", "ch. 6, 18: the square around a disk has 4/π of its area";
    OVER_PI_SQUARED: "π² times too small", "ch. 13: a Lambertian BRDF is ρ/π, divided by π once";
    PI_SQUARED: "π² times too large", "ch. 13: a Lambertian BRDF is ρ/π";
    TWO_THIRDS: "2/3 as large", "ch. 7, 26: a cosine too many under a mean over the hemisphere makes 2/3";
    THREE_HALVES: "3/2 times as large", "ch. 7, 26: a cosine too few, where samples are denser towards the normal by cos²";
    THREE_QUARTERS: "3/4 as large", "ch. 7, 26: a cosine in place of its square, or the other way round";
    FOUR_THIRDS: "4/3 times as large", "ch. 7, 26: a cosine in place of its square, or the other way round";
    QUARTER: "a quarter as large", "a factor ¼: a radius for a diameter, squared, or ½ twice";
    FOUR: "four times as large", "a factor 4: a diameter for a radius, squared, or 2 twice";
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
    LEFT_HANDED: "left-handed axes: negate z of what the adapter reads and writes; or columns are counted from the right", "docs/probe.md: x to the right, y up, z to the viewer";
    TRANSPOSED: "rows for columns", "ch. 20: points are columns";
    // lobes and optics
    MIRRORED_ONCE: "the mirror direction lacks its factor 2", "ch. 24: r = −ωo + 2 (n·ωo) n";
    WITH_COS: "with the cosine of the incoming direction", "ch. 13: f has no cosine", "ch14/set";
    WITHOUT_COS: "without the cosine of the incoming direction", "ch. 13, 26: the weight is f cos θ / pdf", "ch26/cornell-box";
    ETA_SQUARED_TWICE: "ours / η²: 1/η² twice", "ch. 27: radiance is divided by η² when it enters", "ch28/snell-window";
    ETA_ONCE: "ours × η: 1/η for 1/η²", "ch. 27: radiance is divided by η² when it enters", "ch28/snell-window";
    REFRACTED_SIGN: "−ωo/η − (cosθt + cosθi/η) n: a sign in the refracted direction", "ch. 27: t = −ωo/η − (cosθt − cosθi/η) n", "ch27/common-set";
    EXPONENT_FOR_DENSITY: "e for e + 1 in the density", "ch. 7, 25: (e + 1) cosᵉθ / 2π";
    MEAN_OF_AMPLITUDES: "the mean of the amplitudes, not of their squares", "ch. 28: kr = (r∥² + r⊥²) / 2";
    REFLECTED_INSTEAD: "the reflected direction for the refracted one", "ch. 27: t leaves behind the surface";
    ETA_MULTIPLIED: "−η ωo for −ωo/η in the refracted direction", "ch. 27: t = −ωo/η − (cosθt − cosθi/η) n", "ch27/common-set";
    INDEX_ZERO: "the index is 0, or never set: everything is reflected", "ch. 27: the constructor sets η", "ch28/glass-sphere";
    SWAPPED_DIRECTIONS: "wi and wo exchanged", "ch. 13: wo points to the viewer, wi to the light";
    EXPONENT_OFF: "the exponent is larger by 1", "ch. 7: cosᵉθ has the density (e + 1) cosᵉθ / 2π";
    NO_EXPONENT: "the exponent is 1", "ch. 7, 15";
    // lights
    FROM_LIGHT: "the direction goes away from the light", "ch. 14: wi points to the light", "ch14/set";
    TIMES_DISTANCE: "the direction is not made unit", "ch. 14: wi is unit";
    DISTANCE_SQUARED: "the square of the distance", "a root is left out";
    // cameras
    TURNED_BY_HALF: "the picture is turned by 180°", "ch. 9: u = up × w, v = w × u";
    UPSIDE_DOWN: "rows from the bottom", "docs/probe.md: row 0 is at the top";
    MIRRORED: "the picture is mirrored: columns from the right", "ch. 9: u = up × w, not w × up";
    INTEGER_HALF: "half of an odd number of pixels is rounded down", "ch. 3: hres / 2 is a real number";
    AXES_SWAPPED: "u and v are exchanged", "ch. 9: u points right, v up";
    PLACE_DOWN: "the place in the pixel counts from the top", "docs/probe.md: `place` starts at the lower left corner";
    NO_PIXEL_SIZE: "the pixel size is left out", "ch. 3: x = s (c − hres/2 + 0.5)";
    NO_ROLL: "the roll angle is left out", "ch. 9";
    ZOOM_INVERTED: "the zoom is upside down", "ch. 9: the pixel size is divided by the zoom";
    NO_ZOOM: "the zoom is left out", "ch. 9: the pixel size is divided by the zoom";
    BACKWARDS: "the camera looks along +w", "ch. 9: the camera looks along −w";
    // samples and maps
    SWAP_U: "the two numbers of u are swapped", "ch. 5 to 7: which of the two is the radius";
    COMPLEMENT_U: "1 − u for u", "ch. 7: cos θ = (1 − r₂)^(1/(e+1))";
    PLAIN_DISK: "rings of equal width for rings of equal area", "ch. 6: the concentric map";
    ANGLES_EVEN: "θ = π u: even in the angle, not in the area", "ch. 7: cos θ = 1 − 2 r₁";
    HALF_TURN: "half a turn for a whole one: π for 2π", "ch. 7, 29: φ = 2π u";
    EXPONENT_LESS: "e for e + 1 in the root", "ch. 7: cos θ = (1 − r₂)^(1/(e+1))";
    POLAR_DISK: "polar coordinates with the radius r = u", "ch. 6: the area is even in r²";
    // textures, transforms, grids
    AZIMUTH_OFF: "to negative azimuths not 2π is added", "ch. 29: φ = tan⁻¹(x/z), + 2π where it is negative";
    HEIGHT_FOR_ANGLE: "the height y for the polar angle", "ch. 29: v = 1 − θ/π";
    AZIMUTH_FROM_X: "the azimuth is measured from +x", "ch. 29: from +z towards +x";
    REVERSED_STEPS: "the steps are applied last to first", "ch. 20: the last matrix of a product acts first", "ch21/ellipsoid";
    INVERSE_FOR_MATRIX: "the inverse for the matrix", "ch. 21: the ray goes by the inverse";
    TURNED_BACKWARDS: "rotations turn the other way", "ch. 20: counterclockwise, seen against the axis";
    NO_HALF_TEXEL: "texels are at their corners, not their middles", "ch. 29: bilinear, x = n u − 1/2";
    MIRROR_REPEATS: "a mirrored wrap repeats", "docs/scene.md: wraps";
    PROBE_TWICE: "the angle of a light probe is taken for twice itself", "ch. 29: r = α/π";
    WRAPS_CLAMPED: "coordinates outside 0 … 1 are clamped", "ch. 29: wraps";
    WRAPS_REPEATED: "the image always repeats", "ch. 29: wraps";
    WRAPS_SWAPPED: "the wraps of u and v are exchanged", "ch. 29: wraps";
    NO_UNIT: "the unit of the mapping is left out", "ch. 29: generic objects have radius 1";
    // meshes
    NO_VERTEX_NORMALS: "the normals of the vertices are left out", "ch. 23";
    OTHER_CORNERS: "what is interpolated belongs to other corners: β and γ are exchanged, for instance", "ch. 23: n = (1 − β − γ) n0 + β n1 + γ n2", "ch23/smooth-sphere";
    FIRST_CORNER: "what one corner of the triangle has, not interpolated", "ch. 23: n = (1 − β − γ) n0 + β n1 + γ n2", "ch23/smooth-sphere";
    AREA_WEIGHTED: "the mean of the faces' normals is weighted by their areas", "docs/book-card.md: ch. 23 adds unit normals";
    ANGLE_WEIGHTED: "the mean of the faces' normals is weighted by their angles", "docs/book-card.md: ch. 23 adds unit normals";
    LAST_TRIANGLE: "the last triangle is left out", "ch. 23: for all triangles";
    REVERSED_FORGOTTEN: "reverse_normals is left out", "ch. 23: reverse_normal";
    MESH_SCALE: "the scale of the mesh is left out", "docs/scene.md: scale";
    // noise
    NO_EXPONENT_OF_GAIN: "the sum is scaled as for the gain 1/2", "ch. 31: fBm lies within ± (1 − gainⁿ) / (1 − gain)";
    GAIN_FOR_LACUNARITY: "gain and lacunarity are exchanged", "ch. 31: gainʲ noise(lacunarityʲ p)";
    THRESHOLDS: "the thresholds are compared with the noise before it is expanded", "ch. 31: noise = expansion · fBm";
    NO_GAIN: "the gain is 1/2, whatever it is", "ch. 31: fBm, gainʲ";
    NO_LACUNARITY: "the lacunarity is 2, whatever it is", "ch. 31: fBm, lacunarityʲ";
    ONE_OCTAVE: "one octave for all", "ch. 31: the sum over the octaves";
    NO_ABSOLUTE: "turbulence without the absolute value", "ch. 31: Σ |noise(2ʲ p)| / 2ʲ";
    SUM_NOT_SCALED: "the sum is not scaled to 0 … 1", "ch. 31: (sum − min) / (max − min)";
    SCALED_BY_MAX: "the sum is divided by its maximum alone", "ch. 31: (sum − min) / (max − min)";
    NO_EXPANSION: "the expansion number is left out", "ch. 31: noise = expansion · fBm";
    NO_PERTURBATION: "the perturbation is left out", "ch. 31: a · fBm";
    NO_NOISE: "the noise is left out", "ch. 31";
    NO_RANGE: "min and max are left out", "ch. 31: min + (max − min) · noise";
    NOISE_SUBTRACTED: "the noise is subtracted", "ch. 31: n + a · fBm(p)";
    NOT_INTERPOLATED: "the value of one corner of the cell, not interpolated", "ch. 31: lerp(fx, lerp(fy, …), …)";
    OTHER_FRACTIONS: "the fractions of two axes are exchanged in the interpolation", "ch. 31: lerp(fz, lerp(fy, lerp(fx, …)))";
    REVERSED_FRACTIONS: "1 − f for the fraction f", "ch. 31: lerp(f, a, b) = a + f (b − a)";
    SMOOTHED_FRACTIONS: "the fraction is smoothed: f² (3 − 2 f)", "ch. 31: linear noise has f itself";
    OTHER_PERMUTATION: "the permutation takes the coordinates in another order", "ch. 31: PERM(ix + PERM(iy + PERM(iz)))";
    // lights and lenses
    LAMP_PER_AREA: "the pdf is 1/A: that of an area, not of a solid angle", "ch. 18: d² / (A cos θ')", "ch18/rectangle";
    LAMP_INNER_AREA: "the area of the lamp is that before its transformation", "ch. 18, 21", "ch18/stretched-lamp";
    LAMP_ROUND_AREA: "the formula of the area is that of something else", "ch. 18: π r², 4π r²", "ch18/disk";
    LAMP_BY_AREA: "the pdf is that of points that are even in area", "docs/scene.md: `sampling`";
    LEAST_WITHOUT_LS: "ls is left out of what is occluded", "ch. 17: min_amount · ls · color", "ch17/corner";
    LENS_POINT: "the lens is a point", "ch. 10: the ray starts at the point of the lens", "ch10/near-focus";
    LENS_DIAMETER: "the radius of the lens is taken for its diameter", "ch. 10", "ch10/near-focus";
    LENS_UNSCALED: "the point of the lens is not scaled by d/f", "ch. 10: p + (p − l) …, d/f of the lens point", "ch10/near-focus";
    NO_SIZE: "the size is left out", "ch. 30: coordinates over the size";
    ONE_CELL_LESS: "one cell less along each axis", "ch. 22: n = ⌊m w / s⌋ + 1";
    NO_MULTIPLIER: "the multiplier is left out", "ch. 22: m = 2";
    IN_BLACK_SHADOW: "the light is left out", "ch. 14, 16", "ch16/shadows";
}
