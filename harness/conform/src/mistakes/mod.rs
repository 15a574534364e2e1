//! Mistakes that people make, each with its place in the book; and how wrong answers give them away.
//!
//! All are entries of the file of mistakes, [`judge::mistakes::known`]. Those that code names stand here by their names in
//! capitals; the others change the scene or the shape of a question ([`CHANGES`]) or a question about a function
//! ([`OF_FUNCTIONS`]), and answers are compared with ours to that.
//!
//! A judge lists, for one wrong answer, the mistakes that give exactly this answer. A family is named by the mistake that
//! explains nearly all of its wrong answers, and would have changed none of the right ones.

mod clues;
mod names;

use std::sync::LazyLock;

use judge::mistakes::known::{self, KnownMistake};
use judge::mistakes::{How, find, scenes_that_show};

pub use clues::{FACTORS, clues, clues_of_color, other_colors, ratio, same, tells};
pub use names::{Name, agree, always, names, suspects};

/// A mistake of the file, as answers tell it.
#[derive(Clone, Copy, Debug)]
pub struct Mistake {
    /// Its name, also in capitals.
    name: &'static str,
    /// Whether it is told of a whole scene, as pictures tell it, and not of a single function.
    is_of_scene: bool,
}

impl Mistake {
    const fn of_function(name: &'static str) -> Self {
        Self { name, is_of_scene: false }
    }

    /// As a whole scene tells it.
    pub const fn of_scene(known: &KnownMistake) -> Self {
        Self { name: known.name, is_of_scene: true }
    }

    /// Its entry in the file.
    ///
    /// # Panics
    /// If there is none.
    pub fn known(&self) -> &'static KnownMistake {
        let name = self.name.to_lowercase().replace('_', "-");
        known::find(&name).unwrap_or_else(|| panic!("{name} is not in mistakes.toml"))
    }

    /// What was done.
    pub fn words(&self) -> &'static str {
        let KnownMistake { words, clue, .. } = self.known();
        clue.filter(|_| !self.is_of_scene).unwrap_or(words)
    }

    /// Its name, if a picture of it can be made.
    pub fn picture(&self) -> Option<&'static str> {
        Some(find(self.known().name)?.name)
    }

    /// The scene of the gallery that shows it, or shows it best.
    pub fn seen_in(&self) -> Option<&'static str> {
        let best = || Some(scenes_that_show(find(self.picture()?)?).first()?.scene);
        self.known().scene.or_else(best)
    }
}

/// Two are the same if they are of one entry of the file, in whichever words they are told.
impl PartialEq for Mistake {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name || self.known().name == other.known().name
    }
}

/// Those that change a question, of which a picture is made otherwise, or not at all.
pub static CHANGES: LazyLock<Vec<Mistake>> = LazyLock::new(|| {
    let all = known::pictures().iter().chain(known::answers()).filter(|it| !it.change.is_empty());
    let is_made = |it: &&KnownMistake| {
        find(it.name).is_some_and(|picture| matches!(picture.how, How::Edits(_)))
    };
    all.filter(|it| !is_made(it)).map(Mistake::of_scene).collect()
});

/// Those that change a question about a function, or our answer to it.
pub static OF_FUNCTIONS: LazyLock<Vec<Mistake>> = LazyLock::new(|| {
    let all = known::pictures().iter().chain(known::answers());
    let is_one = |it: &&KnownMistake| !it.change.is_empty() || !it.asked.is_empty();
    all.filter(is_one).map(|it| Mistake::of_function(it.name)).collect()
});

/// Mistakes by their names in capitals: `FAR_ROOT` is `far-root`.
macro_rules! mistakes {
    ($($name:ident)*) => {
        $(
            #[doc = concat!("The entry of this name: ", stringify!($name), ".")]
            pub static $name: Mistake = Mistake::of_function(stringify!($name));
        )*

        /// All that code names.
        pub static NAMED: &[&Mistake] = &[$(&$name),*];
    };
}

mistakes! {
    // those that have a picture
    CHECKER_TRUNCATED ETA_INVERTED HIGHLIGHT_OF_HALF_VECTOR LAMP_TWO_SIDED NORMAL_BY_MATRIX NO_ETA_SQUARED NO_LAMP_AREA
    NO_LAMP_COSINE NO_LAMP_DISTANCE ONE_OCTAVE_LESS PIXEL_CORNER EYES_EXCHANGED SCHLICK SHADOW_RAYS_WITHOUT_END
    STEPS_REVERSED TEXTURE_COLOURS_EXCHANGED
    // intersections
    FAR_ROOT BEHIND UNIT_ASSUMED NOT_NORMALISED_LENGTH NEGATED TO_VIEWER NORMAL_UNTRANSFORMED INSIDE_MISSED ONE_SIDED
    TO_VIEWER_BY_THE_BOOK NORMAL_BY_INVERSE NORMAL_BY_TRANSPOSE CANCELLATION T_NOT_SET ALWAYS_NULL NO_SHADOW_HIT
    ALWAYS_BLOCKED CONE_NORMAL_SQUARE CONE_NORMAL_EQUAL CENTER_FORGOTTEN TORUS_COEFFICIENT NEAREST_ONLY SPAN_IGNORED MISSED
    // numbers
    ZERO BLACK CLAMPED GAMMA ALWAYS DIVIDED_BY_ZERO_ANGLE DIVIDED_BY_ZERO_AXIS TIMES_PI OVER_PI TIMES_TWO HALF TIMES_2PI
    OVER_2PI TIMES_4PI OVER_4PI QUARTER_PI FOUR_OVER_PI OVER_PI_SQUARED PI_SQUARED TWO_THIRDS THREE_HALVES THREE_QUARTERS
    FOUR_THIRDS QUARTER FOUR DEGREES RADIANS SQUARED ROOT INVERSE COMPLEMENT
    // components
    SWAP_XY SWAP_YZ SWAP_XZ FLIP_X FLIP_Y FLIP_Z SWAP_RG SWAP_GB SWAP_RB ONLY_RED NO_RED NO_GREEN NO_BLUE MIRROR_U MIRROR_V
    LEFT_HANDED TRANSPOSED
    // lobes and optics
    MIRRORED_ONCE WITH_COS WITHOUT_COS ETA_SQUARED_TWICE ETA_ONCE REFRACTED_SIGN EXPONENT_FOR_DENSITY MEAN_OF_AMPLITUDES
    REFLECTED_INSTEAD ETA_MULTIPLIED INDEX_ZERO POLARISATIONS_EXCHANGED
    // lights
    FROM_LIGHT
    // cameras
    MIRRORED INTEGER_HALF NO_ROLL
    // samples and maps
    PIXELS_ALIKE SWAP_U PLAIN_DISK ANGLES_EVEN HALF_TURN POLAR_DISK
    // textures, transforms, grids
    AZIMUTH_OFF NO_HALF_TEXEL ROTATION_Z_REVERSED IMAGE_TRANSPOSED
    // meshes
    OTHER_CORNERS FIRST_CORNER AREA_WEIGHTED ANGLE_WEIGHTED LAST_TRIANGLE ACCELERATED
    // noise
    OCTAVES_REVERSED NO_EXPONENT_OF_GAIN GAIN_FOR_LACUNARITY THRESHOLDS NO_GAIN NO_LACUNARITY ONE_OCTAVE NO_ABSOLUTE
    SUM_NOT_SCALED SCALED_BY_MAX NO_EXPANSION NO_PERTURBATION NO_NOISE NO_RANGE NOISE_SUBTRACTED NOT_INTERPOLATED
    OTHER_FRACTIONS REVERSED_FRACTIONS SMOOTHED_FRACTIONS
    // lights and lenses
    LAMP_PER_AREA LAMP_INNER_AREA LAMP_ROUND_AREA LAMP_BY_AREA LEAST_WITHOUT_LS NO_SIZE
}
