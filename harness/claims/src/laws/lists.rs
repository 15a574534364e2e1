//! The lists of laws.

use super::{Check, Law, integrals, lights, maps, values};

/// Of lobes.
pub const LOBES: [Law; 10] = [
    Law {
        name: "repeated",
        sentence: "the same question has the same answer, whatever was asked between",
        cause: "a record kept from the last call, or a generator of random numbers that is not given",
        applies: |_| true,
        check: Check::Lobe(values::repeated),
    },
    Law {
        name: "positive",
        sentence: "f, pdf and weights are finite and not negative, at the limb too",
        cause: "0/0 or a cosine without its absolute value at grazing directions",
        applies: |claims| !claims.delta,
        check: Check::Lobe(values::positive),
    },
    Law {
        name: "sides",
        sentence: "light comes from the sides that are claimed, and samples are unit directions there",
        cause: "the normal, or the sign of a cosine, is not that of the viewer's side",
        applies: |_| true,
        check: Check::Lobe(values::sides),
    },
    Law {
        name: "same pdf",
        sentence: "the pdf of a sample is the pdf of its direction",
        cause: "the Jacobian of the half vector, or the probability of choosing a lobe, is in one of them alone",
        applies: |claims| !claims.delta,
        check: Check::Lobe(values::same_pdf),
    },
    Law {
        name: "weight",
        sentence: "the weight of a sample is f |cos θi| / pdf",
        cause: "the cosine twice or not at all, or a factor that cancels in one place alone",
        applies: |claims| !claims.delta,
        check: Check::Lobe(values::weight),
    },
    Law {
        name: "density",
        sentence: "samples have the density pdf",
        cause: "the pdf lacks the Jacobian 1/(4 ωo·h), or the sampled function is another",
        applies: |claims| !claims.delta,
        check: Check::Lobe(|case, scale| integrals::density(case, scale)),
    },
    Law {
        name: "whole",
        sentence: "the integral of the pdf is 1, less the share of samples that scatter nothing",
        cause: "the pdf lacks a Jacobian or a normalisation, or samples below the surface are thrown away in silence",
        applies: |claims| !claims.delta,
        check: Check::Lobe(|case, scale| integrals::whole(case, scale)),
    },
    Law {
        name: "turned",
        sentence: "a turn of both directions about the normal changes nothing",
        cause: "a fixed axis of the world, or x and y exchanged, in an isotropic lobe",
        applies: |claims| claims.isotropic && !claims.delta,
        check: Check::Lobe(values::turned),
    },
    Law {
        name: "reciprocal",
        sentence: "f is the same with viewer and light exchanged (divided by the square of the viewer's index)",
        cause: "1/η² is left out, or a term of the viewer alone",
        applies: |claims| claims.reciprocal && !claims.delta,
        check: Check::Lobe(values::reciprocal),
    },
    Law {
        name: "albedo",
        sentence: "the mean weight is the integral of f |cos θi|; it is at most 1, and 1 where nothing is lost",
        cause: "more light leaves than arrives: a normalisation or a Fresnel term is left out",
        applies: |_| true,
        check: Check::Lobe(integrals::albedo),
    },
];

/// Of lights.
pub const LIGHTS: [Law; 11] = [
    Law {
        name: "repeated",
        sentence: "the same question has the same answer, whatever was asked between",
        cause: "a sample point kept from the last call, or a generator of random numbers that is not given",
        applies: |_| true,
        check: Check::Light(lights::repeated),
    },
    Law {
        name: "positive",
        sentence: "radiance and pdf are finite and not negative; the pdf of a sample is above 0",
        cause: "0/0 where the light is seen edge-on, or a cosine without its absolute value",
        applies: |_| true,
        check: Check::Light(lights::positive),
    },
    Law {
        name: "directions",
        sentence: "samples are unit directions to points at a distance, of infinite lights without one",
        cause: "the direction is not normalised, or points from the light",
        applies: |_| true,
        check: Check::Light(lights::directions),
    },
    Law {
        name: "same pdf",
        sentence: "the pdf of a sample is the pdf of its direction",
        cause: "the density of area in one of them, of solid angle in the other",
        applies: |_| true,
        check: Check::Light(lights::same_pdf),
    },
    Law {
        name: "same radiance",
        sentence: "the radiance of a sample is the radiance of its direction",
        cause: "the cosine or 1/d² is in one of them alone",
        applies: |_| true,
        check: Check::Light(lights::same_radiance),
    },
    Law {
        name: "sides",
        sentence: "behind the points that shine a one-sided light is dark, and a two-sided one shines",
        cause: "the sign of the cosine at the light is not looked at, or its absolute value is not taken",
        applies: |claims| !claims.infinite,
        check: Check::Light(lights::sides),
    },
    Law {
        name: "along",
        sentence: "the radiance is the same all along a ray",
        cause: "radiance is divided by d²: only the pdf knows the distance",
        applies: |_| true,
        check: Check::Light(lights::along),
    },
    Law {
        name: "distance",
        sentence: "the pdf of a point falls with the square of the distance, or is the same in all directions, as is claimed",
        cause: "d² is left out, or not squared",
        applies: |claims| claims.sampling.is_some(),
        check: Check::Light(lights::distance),
    },
    Law {
        name: "density",
        sentence: "samples from where it is lit have the density pdf",
        cause: "points are not uniform on the light, or the Jacobian d²/cos θ' is left out",
        applies: |_| true,
        check: Check::Light(|case, scale| integrals::density(case, scale)),
    },
    Law {
        name: "whole",
        sentence: "the integral of the pdf over what is lit is 1, less the share of samples that bring no light",
        cause: "the area, or the Jacobian d²/cos θ', is another than that of the samples",
        applies: |_| true,
        check: Check::Light(|case, scale| integrals::whole(case, scale)),
    },
    Law {
        name: "arriving",
        sentence: "the mean of radiance / pdf is the integral of the radiance",
        cause: "a part of the light is never sampled, or its size is another in one function",
        applies: |_| true,
        check: Check::Light(integrals::arriving),
    },
];

/// Of maps.
pub const MAPS: [Law; 8] = [
    Law {
        name: "repeated",
        sentence: "the same question has the same answer, whatever was asked between",
        cause: "the map draws numbers of its own",
        applies: |_| true,
        check: Check::Map(maps::repeated),
    },
    Law {
        name: "inside",
        sentence: "all points lie in the domain, from the corners of the square too",
        cause: "a square that is not halved, or directions that are not unit",
        applies: |_| true,
        check: Check::Map(maps::inside),
    },
    Law {
        name: "positive",
        sentence: "the pdf is finite and not negative",
        cause: "a cosine without its absolute value",
        applies: |_| true,
        check: Check::Map(maps::positive),
    },
    Law {
        name: "jacobian",
        sentence: "the pdf is 1 over the area that the map makes of a unit of the square",
        cause: "the radius without its root, or a pdf of angles in place of solid angle",
        applies: |_| true,
        check: Check::Map(maps::jacobian),
    },
    Law {
        name: "inverse",
        sentence: "the inverse gives back the pair that was mapped",
        cause: "u and v exchanged, or an angle that begins elsewhere",
        applies: |claims| claims.invertible,
        check: Check::Map(maps::inverse),
    },
    Law {
        name: "density",
        sentence: "points have the density pdf",
        cause: "a part of the domain is covered twice",
        applies: |_| true,
        check: Check::Map(|case, scale| integrals::density(case, scale)),
    },
    Law {
        name: "whole",
        sentence: "the integral of the pdf is 1",
        cause: "the pdf of a part of the domain, or of all of the sphere for a half of it",
        applies: |_| true,
        check: Check::Map(|case, scale| integrals::whole(case, scale)),
    },
    Law {
        name: "stratified",
        sentence: "stratified pairs become stratified points",
        cause: "pairs are rejected or scrambled: neighbours are torn apart",
        applies: |claims| claims.stratified,
        check: Check::Map(maps::stratified),
    },
];
