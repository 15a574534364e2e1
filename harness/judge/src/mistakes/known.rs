//! The catalogue of mistakes that people make in ray tracers: what is done wrong, and where the book has it right.
//!
//! One list for pictures and for answers: each entry has its picture in this package, and `conform` names the entries
//! that answers give away.

/// A mistake.
#[derive(Debug)]
pub struct KnownMistake {
    /// Its name, in lower case with hyphens.
    pub name: &'static str,
    /// The chapter of the book that has the right rule.
    pub chapter: u32,
    /// Completes the sentence "the picture agrees with ours if …".
    pub words: &'static str,
    /// Where the book has it right, or what to read.
    pub place: &'static str,
    /// What wrong answers tell of it, where that is other than the words.
    pub clue: Option<&'static str>,
}

/// Entries: chapter, name, words, place, and the clue if there is one.
macro_rules! catalogue {
    ($($entry:ident $chapter:literal $name:literal: $words:literal, $place:literal $(, $clue:literal)?;)*) => {
        $(
            #[doc = $words]
            pub static $entry: KnownMistake = KnownMistake {
                name: $name,
                chapter: $chapter,
                words: $words,
                place: $place,
                clue: [$(Some($clue),)? None][0],
            };
        )*

        /// All of them, by chapter.
        pub static ALL: &[&KnownMistake] = &[$(&$entry),*];
    };
}

catalogue! {
    PIXEL_CORNER 3 "pixel-corner": "samples are taken around the lower left corner of each pixel instead of its middle", "ch. 3: x = s (c − hres/2 + 0.5)", "the corner of the pixel for its middle";
    NO_ASPECT 3 "no-aspect": "the picture's height is taken for as large as its width, so that all is stretched", "ch. 3: one pixel size s along both axes";
    BACK_SIDES_BLACK 3 "back-sides-black": "the normal is not turned to the viewer on the back of two-sided surfaces", "docs/scene.md: `two_sided`";
    SPHERE_NORMAL_NOT_UNIT 3 "sphere-normal-not-unit": "the normals of spheres are p − c, as long as the radius, in direct light", "ch. 3: n = (p − c) / r";
    NO_BACKGROUND 3 "no-background": "the background is black", "ch. 3: rays that hit nothing have its colour";
    LAST_SAMPLE_LEFT_OUT 4 "last-sample-left-out": "the last of n samples of a pixel is left out of the sum, which is divided by n", "ch. 4: the mean of all n samples";
    SUB_CELL_CORNER 4 "sub-cell-corner": "samples are moved from the middle of their cells of the pixel to the lower left corner", "ch. 4: x = s (c − hres/2 + (q + 0.5)/n)";
    ROLL_REVERSED 9 "roll-reversed": "the camera is rolled to the other side", "ch. 9: a positive roll turns the camera counterclockwise", "the camera rolls in the opposite sense";
    NO_EXPOSURE_TIME 9 "no-exposure-time": "the exposure time is left out", "ch. 9: radiance times the exposure time";
    NOT_FOCUSED 10 "not-focused": "the rays of a lens meet on the view plane instead of the focal plane", "ch. 10: the focal point is the point of the view plane times f/d";
    LENS_RADIUS_DOUBLED 10 "lens-radius-doubled": "the diameter of the lens is taken for its radius", "ch. 10: the lens point is the lens radius times a point of the unit disk";
    HALF_FIELD_OF_VIEW 11 "half-field-of-view": "half of the field of view is taken for the whole", "ch. 11: ψ_max is half of the field of view", "half of the angle of view is halved again";
    WHOLE_FIELD_OF_VIEW 11 "whole-field-of-view": "the whole field of view is taken for its half", "ch. 11: ψ_max is half of the field of view", "the whole angle of view for half of it";
    FISHEYE_WITHOUT_CIRCLE 11 "fisheye-without-circle": "a fisheye fills its whole rectangle, not only the circle in it", "ch. 11: no ray where r > 1";
    EYES_EXCHANGED 12 "eyes-exchanged": "the images of both eyes are exchanged", "ch. 12: parallel viewing has the left eye's image on the left";
    LAMBERTIAN_WITHOUT_PI 13 "lambertian-without-pi": "direct light that a Lambertian BRDF reflects lacks 1/π", "ch. 13: a Lambertian BRDF is ρ/π";
    LAMBERTIAN_PI_TWICE 13 "lambertian-pi-twice": "direct light that a Lambertian BRDF reflects has 1/π twice", "ch. 13: a Lambertian BRDF is ρ/π";
    NO_COSINE 14 "no-cosine": "direct light lacks the cosine of its angle to the normal", "ch. 14: f L_i cos θ_i, summed over all lights";
    COSINE_OF_VIEWER 14 "cosine-of-viewer": "direct light has the cosine of the viewer's angle instead of the light's", "ch. 14: cos θ_i = n·ω_i";
    COSINE_TWICE 14 "cosine-twice": "direct light has the cosine of its angle to the normal twice", "ch. 13, 14: f itself has no cosine";
    NO_AMBIENT 14 "no-ambient": "ambient light is left out", "ch. 14: ka cd L_a is added once";
    AMBIENT_FOR_EACH_LIGHT 14 "ambient-for-each-light": "the ambient term is added once for each light", "ch. 14: ka cd L_a is added once";
    AMBIENT_OVER_PI 14 "ambient-over-pi": "the ambient term is divided by π", "ch. 14: ka cd L_a, without 1/π";
    SAMPLE_MAX_TO_ONE 14 "sample-max-to-one": "max-to-one maps each sample of a pixel, before their mean is taken", "ch. 14: the mean of all samples is mapped";
    AMBIENT_WITHOUT_KA 14 "ambient-without-ka": "the ambient term is not multiplied by k_a", "ch. 14: ka cd L_a";
    AMBIENT_OF_KD 14 "ambient-of-kd": "the ambient term has k_d instead of k_a", "ch. 14: ka cd L_a";
    NO_FALL_OFF 14 "no-fall-off": "light of point lights does not fall off with distance", "ch. 14: radiance over dⁿ", "distance attenuation is left out";
    LINEAR_FALL_OFF 14 "linear-fall-off": "light of point lights falls off with 1/d instead of 1/d²", "ch. 14: radiance over dⁿ";
    LIT_FROM_BEHIND 14 "lit-from-behind": "light without shadows that comes from behind a surface counts as light from the front", "ch. 14: no light where n·ωi ≤ 0";
    SUN_REVERSED 14 "sun-reversed": "directional light comes from the other side", "ch. 14: ωi points to the light";
    SUN_NOT_NORMALISED 14 "sun-not-normalised": "the direction of directional light is not normalised, so that its length is a factor", "ch. 14: l is unit", "the sun's direction is not normalised";
    LAMP_COLOURS_EXCHANGED 14 "lamp-colours-exchanged": "the colours of the first two lamps that have different ones are exchanged", "ch. 14: each light has ls · color of its own";
    SPOT_WHOLE_ANGLE 14 "spot-whole-angle": "the angles from a spotlight's axis are taken for those across its whole cone", "docs/scene.md: the angles of a spot are measured from its axis";
    ONLY_FIRST_LAMP 14 "only-first-lamp": "only the first lamp counts", "ch. 14: the sum over all lights";
    ONLY_LAST_LAMP 14 "only-last-lamp": "only the last lamp counts", "ch. 14: the sum over all lights";
    DIFFUSE_OF_KA 14 "diffuse-of-ka": "the light of lamps is reflected by ka instead of kd", "ch. 14: kd cd / π";
    NO_KD 14 "no-kd": "kd is left out", "ch. 14: kd cd / π";
    NO_LAMP_COLOUR 14 "no-lamp-colour": "the colour of lamps is left out", "ch. 14: ls · color";
    NO_LS 14 "no-ls": "the factor ls of lights is left out", "ch. 14: ls · color";
    FALL_OFF_WHERE_NONE 14 "fall-off-where-none": "light falls off with 1/d² where it should not", "ch. 14: the exponent of the distance, 0 if left out";
    SPOT_SHARP 14 "spot-sharp": "a spot has a sharp edge", "docs/scene.md: a smooth step from `inner` to `outer`";
    BOTH_SIDES_LIT 14 "both-sides-lit": "all surfaces are lit on both sides", "ch. 14: n·ωi > 0; `two_sided`";
    NO_HIGHLIGHT 15 "no-highlight": "highlights are left out", "ch. 15: ks cs (r·ωo)ᵉ";
    HIGHLIGHT_WITHOUT_COSINE 15 "highlight-without-cosine": "highlights lack the cosine of the light's angle to the normal", "ch. 15: f L_i cos θ_i, with the highlight as part of f";
    HIGHLIGHT_NORMALISED 15 "highlight-normalised": "highlights are multiplied by (e + 2)/2π", "ch. 15: ks cs (r·ωo)ᵉ";
    HIGHLIGHT_OF_HALF_VECTOR 15 "highlight-of-half-vector": "highlights are (n·h)^e of the half vector (Blinn) instead of (r·ω_o)^e", "ch. 15: (r·ωo)ᵉ", "the half vector, (n·h)ᵉ, for the mirror direction";
    HIGHLIGHT_WITHOUT_TWO 15 "highlight-without-two": "the mirror direction of highlights lacks its factor 2: (n·ω_i) n − ω_i", "ch. 15: r = 2 (n·ωi) n − ωi";
    HIGHLIGHT_DIRECTION_NOT_UNIT 15 "highlight-direction-not-unit": "the direction of directional light is not normalised in highlights alone", "ch. 14, 15: l is unit";
    HIGHLIGHT_OF_SURFACE_COLOUR 15 "highlight-of-surface-colour": "highlights have the diffuse colour of the surface instead of their own", "ch. 15: cs is a colour of its own";
    NO_KS 15 "no-ks": "ks is left out", "ch. 15: ks cs (r·ωo)ᵉ";
    NO_HIGHLIGHT_EXPONENT 15 "no-highlight-exponent": "the exponent of highlights is left out", "ch. 15: (r·ωo)ᵉ";
    SHADOW_SWITCHES_IGNORED 16 "shadow-switches-ignored": "objects and materials that are said to cast no shadows do", "docs/scene.md: `casts_shadows`";
    NO_SHADOWS 16 "no-shadows": "objects cast no shadows", "ch. 16: light counts where no object is before it", "shadows are left out";
    SHADOW_RAYS_WITHOUT_END 16 "shadow-rays-without-end": "shadow rays do not end at the lamp: objects behind it, and the lamp itself, block its light", "ch. 16: shadow rays end at the light", "occluders beyond the end count";
    NO_OFFSET 16 "no-offset": "rays that leave a surface start on it, without an offset, so that it shadows itself in spots (acne)", "ch. 16: hits of shadow rays count for t > ε";
    OFFSET_TOO_LARGE 16 "offset-too-large": "rays that leave a surface ignore all hits nearer than 1", "ch. 16: ε is small beside the objects";
    OCCLUDER_UNIFORM 17 "occluder-uniform": "ambient occlusion draws directions evenly over the hemisphere instead of by the cosine", "ch. 17: directions are distributed by the cosine";
    NO_MIN_AMOUNT 17 "no-min-amount": "ambient light is black where it is occluded, instead of its least amount", "ch. 17: min_amount · ls · color";
    NO_OCCLUSION 17 "no-occlusion": "occlusion is left out", "ch. 17: one shadow ray for each sample";
    LAMPS_UNSEEN 18 "lamps-unseen": "surfaces that shine are black where the camera sees them", "ch. 18: emissive materials have ls ce where they are seen";
    NO_LAMP_COSINE 18 "no-lamp-cosine": "the light of area lights lacks the cosine at the lamp", "ch. 18: d² / (A cos θ')", "the pdf lacks the cosine at the lamp";
    LAMP_COSINE_TWICE 18 "lamp-cosine-twice": "the light of area lights has the cosine at the lamp twice", "ch. 18: d² / (A cos θ')";
    NO_LAMP_DISTANCE 18 "no-lamp-distance": "the light of area lights lacks 1/d²", "ch. 18: d² / (A cos θ')", "the pdf lacks the square of the distance";
    LAMP_OF_RECEIVER 18 "lamp-of-receiver": "the light of area lights is multiplied by the reflectance of the lit surface once more", "ch. 18: the lamp's radiance is ls ce of its own material";
    LAST_LIGHT_SAMPLE_LEFT_OUT 18 "last-light-sample-left-out": "the last of n samples of an area light or of the sky is left out of the sum, which is divided by n", "ch. 18: the mean of all n samples";
    NO_LAMP_AREA 18 "no-lamp-area": "the light of area lights lacks the factor of the lamp's area (the density of its samples)", "ch. 18: d² / (A cos θ')", "the pdf lacks the area of the lamp";
    LAMP_TWO_SIDED 18 "lamp-two-sided": "one-sided lamps shine from both sides", "ch. 18: no light where n·ωi ≤ 0", "lamps shine from their dark side, too";
    STEPS_REVERSED 20 "steps-reversed": "the steps of an instance are applied last to first", "ch. 20: the last matrix of a product acts first";
    ROTATIONS_REVERSED 20 "rotations-reversed": "rotations of instances turn the other way", "ch. 20: counterclockwise, seen against the axis";
    NORMAL_BY_MATRIX 21 "normal-by-matrix": "the normals of instances are transformed by the matrix instead of its inverse transpose", "ch. 21: normals go by the inverse transpose", "the normal is transformed as a vector";
    FLAT_SHADING 23 "flat-shading": "smooth meshes are shaded by the normals of their faces", "ch. 23: n = (1 − β − γ) n0 + β n1 + γ n2", "the normal of the face, not interpolated";
    MIRROR_WITH_COSINE 24 "mirror-with-cosine": "light from a mirror direction is multiplied by the cosine of its angle to the normal", "ch. 24: kr cr, where the cosine cancels";
    MIRROR_WITHOUT_KR 24 "mirror-without-kr": "light from a mirror direction is not multiplied by k_r c_r", "ch. 24: kr cr";
    LAMPS_UNSEEN_IN_MIRRORS 24 "lamps-unseen-in-mirrors": "surfaces that shine are black where reflected or refracted rays meet them", "ch. 24: what the traced ray sees counts in full";
    NO_BACKGROUND_IN_MIRRORS 24 "no-background-in-mirrors": "reflected and refracted rays that meet nothing are black instead of the background", "ch. 24: what the traced ray sees counts in full";
    ONE_BOUNCE_LESS 24 "one-bounce-less": "rays are traced to one depth less", "ch. 24: rays deeper than max_depth are black";
    ONE_BOUNCE_MORE 24 "one-bounce-more": "rays are traced to one depth more", "ch. 24: rays deeper than max_depth are black";
    MIRROR_DARK 24 "mirror-dark": "a mirror does not reflect", "ch. 24";
    NO_BASE_OF_MIRROR 24 "no-base-of-mirror": "what is under a mirror is left out", "ch. 24: direct light as of Phong's material, and the mirror's";
    BASE_OF_MIRROR_LESS 24 "base-of-mirror-less": "what is under a mirror counts 1 − kr", "ch. 24: direct light as of Phong's material, and the mirror's";
    GLOSS_WITH_COSINE 25 "gloss-with-cosine": "glossy reflection has the cosine of the ray's angle in f cos θ, but not in the density", "ch. 25: f cos θ / pdf, with the cosine in both or in neither";
    GLOSS_WITHOUT_DENSITY 25 "gloss-without-density": "the rays of glossy reflection count f cos θ, not divided by their density", "ch. 25: f cos θ / pdf";
    LIGHT_COUNTED_TWICE 26 "light-counted-twice": "lamps and sky count in full both where they are sampled and where a path hits them", "ch. 26: light that is sampled counts once";
    PATH_COSINE_TWICE 26 "path-cosine-twice": "diffuse paths have cosine-distributed directions and the cosine in their weight", "ch. 26: the weight is f cos θ / pdf";
    PATH_PI_TWICE 26 "path-pi-twice": "diffuse paths have 1/π twice", "ch. 26: the weight is f cos θ / pdf, with f = ρ/π and pdf = cos θ / π";
    PATH_WITHOUT_REFLECTANCE 26 "path-without-reflectance": "light that diffuse paths collect is not multiplied by the reflectance k_d c_d", "ch. 26: the weight is f cos θ / pdf";
    PATH_WITHOUT_DENSITY 26 "path-without-density": "diffuse paths count f cos θ, not divided by the density of their direction", "ch. 26: the weight is f cos θ / pdf";
    CHOICE_NOT_COMPENSATED 26 "choice-not-compensated": "paths that choose one of several lobes are not divided by its probability", "Pharr, Jakob & Humphreys 2023, ch. 2: f over the probability of its choice";
    ROULETTE_NOT_COMPENSATED 26 "roulette-not-compensated": "paths that survive Russian roulette are not divided by their probability of survival", "Arvo & Kirk 1990: survivors are divided by their probability";
    NO_ETA_SQUARED 27 "no-eta-squared": "transmitted radiance lacks 1/η²", "ch. 27: radiance is divided by η² when it enters", "ours × η²: 1/η² is left out";
    ETA_SQUARED_INVERTED 27 "eta-squared-inverted": "transmitted radiance is multiplied by η² instead of 1/η²", "ch. 27: radiance is divided by η² when it enters";
    TOTAL_REFLECTION_BLACK 27 "total-reflection-black": "total internal reflection is black", "ch. 27: total internal reflection reflects everything";
    GLASS_WITHOUT_MIRROR 27 "glass-without-mirror": "transparent surfaces reflect nothing but by total internal reflection", "ch. 27: a reflected and a transmitted ray";
    TRANSMISSION_WITHOUT_KT 27 "transmission-without-kt": "transmitted light is not multiplied by k_t", "ch. 27: kt / η²";
    KR_KT_EXCHANGED 27 "kr-kt-exchanged": "k_r and k_t of transparent surfaces are exchanged", "ch. 27: kr of the reflected ray, kt of the transmitted one";
    GLASS_CASTS_NO_SHADOW 27 "glass-casts-no-shadow": "transparent objects cast no shadow", "ch. 27: shadows of transparent objects are black";
    ETA_NOT_INVERTED 27 "eta-not-inverted": "the index of refraction is not inverted for rays inside", "ch. 27: η is inverted where n·ωo < 0";
    ETA_INVERTED 27 "eta-inverted": "the index of refraction is inverted on both sides of a surface", "ch. 27, 28: η = η_in / η_out, inverted when the ray is inside", "η upside down";
    TOTAL_REFLECTION_KR 27 "total-reflection-kr": "total internal reflection is weighted by k_r instead of 1", "ch. 27: total internal reflection reflects everything";
    NOT_REFRACTED 27 "not-refracted": "rays are not refracted", "ch. 27: Snell's law";
    SCHLICK 28 "schlick": "Fresnel's equations are replaced by Schlick's approximation", "ch. 28: Fresnel's equations", "Schlick's approximation";
    FRESNEL_SWAPPED 28 "fresnel-swapped": "the reflected and the transmitted share of Fresnel's equations are exchanged", "ch. 28: kt = 1 − kr";
    FRESNEL_PERPENDICULAR_ONLY 28 "fresnel-perpendicular-only": "only perpendicular polarisation counts in Fresnel's equations", "ch. 28: the mean of both polarisations", "light polarised across the plane of incidence alone";
    FRESNEL_PARALLEL_ONLY 28 "fresnel-parallel-only": "only parallel polarisation counts in Fresnel's equations", "ch. 28: the mean of both polarisations", "light polarised in the plane of incidence alone";
    FRESNEL_WITHOUT_HALF 28 "fresnel-without-half": "the shares of both polarisations are added in Fresnel's equations, without 1/2", "ch. 28: kr = (r∥² + r⊥²) / 2";
    FRESNEL_TRANSMITS_ALL 28 "fresnel-transmits-all": "transmitted light is not multiplied by what Fresnel's equations leave, 1 − R", "ch. 28: kt = 1 − kr";
    FRESNEL_INDEX_INVERTED 28 "fresnel-index-inverted": "Fresnel's equations have the index of refraction inverted", "ch. 28: η = η_in / η_out";
    NO_ABSORPTION 28 "no-absorption": "media do not absorb light", "ch. 28: c^t, over the length t of each ray";
    ABSORPTION_WITHOUT_DISTANCE 28 "absorption-without-distance": "media absorb the same share of light over any distance, that of a unit length", "ch. 28: c^t, over the length t of each ray";
    ABSORPTION_TWICE 28 "absorption-twice": "media absorb light as over twice the distance", "ch. 28: c^t, over the length t of each ray";
    MEDIA_EXCHANGED 28 "media-exchanged": "the media inside and outside of dielectrics are exchanged", "ch. 28: η_in and c_in where n·ωo < 0";
    SKY_TURNED 29 "sky-turned": "the image of the sky is turned by 90°: its seam is at +x instead of +z", "ch. 29: φ goes from +z to +x";
    TEXTURE_UPSIDE_DOWN 29 "texture-upside-down": "rows of texture images are counted from the other end", "ch. 29: row 0 of a texture is at the bottom, row 0 of a file at the top", "the image stands on its head";
    TEXTURE_MIRRORED 29 "texture-mirrored": "columns of texture images are counted from the other end", "ch. 29: u goes to the right", "the image is mirrored";
    TEXTURE_TURNED 29 "texture-turned": "texture images are turned by 90° about the y axis of their objects", "ch. 29: φ goes from +z to +x";
    TEXTURE_NEAREST 29 "texture-nearest": "texture images have the nearest texel instead of bilinear interpolation", "ch. 29: filtering", "the nearest texel, without interpolation";
    TEXTURE_BILINEAR 29 "texture-bilinear": "texture images have bilinear interpolation instead of the nearest texel", "ch. 29: filtering";
    TEXTURE_OF_OTHER_RULE 29 "texture-of-other-rule": "texels cover 1/(n − 1) of the image for 1/n, or 1/n for 1/(n − 1)", "docs/book-card.md: ch. 29, texels", "n for n − 1 of the columns and rows, or the other way round";
    TEXTURE_NOT_IN_INSTANCE 30 "texture-not-in-instance": "the textures of instances are not transformed with them: they are those of the points in the world", "ch. 30: textures are looked up in the object's coordinates";
    CHECKER_TRUNCATED 30 "checker-truncated": "the cells of solid checkers are numbered by truncation instead of rounding down", "ch. 30: ⌊−0.3⌋ = −1", "numbers are truncated instead of rounded down";
    TEXTURE_COLOURS_EXCHANGED 30 "texture-colours-exchanged": "the two colours of checkers, stripes and noise are exchanged", "ch. 30: color1 where the sum of the three floors is even", "the two colours are exchanged";
    TEXTURE_OFFSET 30 "texture-offset": "checkers and stripes are moved by half a cell along each axis", "ch. 30: cells start at multiples of the size";
    TEXTURE_SIZE_DOUBLED 30 "texture-size-doubled": "the cells of textures are twice as large", "ch. 30: coordinates over the size";
    TEXTURE_SIZE_HALVED 30 "texture-size-halved": "the cells of textures are half as large", "ch. 30: coordinates over the size";
    NO_OUTLINES 30 "no-outlines": "checkers have no outlines", "ch. 30: outlines have their own width and colour";
    BUMP_REVERSED 31 "bump-reversed": "bumps turn normals to the other side, so that hills are dents", "ch. 31: n + a · fBm(p)";
    ONE_OCTAVE_LESS 31 "one-octave-less": "sums of several octaves of noise lack the last one", "ch. 31: j from 0 to n − 1", "the last octave is left out";
    ONE_OCTAVE_MORE 31 "one-octave-more": "sums of several octaves of noise have one more", "ch. 31: j from 0 to n − 1";
    OCTAVES_WITHOUT_GAIN 31 "octaves-without-gain": "all octaves of noise have the same weight", "ch. 31: fBm, gainʲ";
    OCTAVES_WITHOUT_LACUNARITY 31 "octaves-without-lacunarity": "all octaves of noise have the same frequency", "ch. 31: fBm, lacunarityʲ";
    NOISE_LINEAR 31 "noise-linear": "noise is interpolated linearly instead of by cubic splines", "ch. 31: cubic noise is interpolated by splines";
    NO_BUMPS 31 "no-bumps": "bumps are left out", "ch. 31";
}
