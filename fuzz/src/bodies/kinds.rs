//! Round, cut and composite shapes from bytes: every kind of chapters 19, 21 and 22 that `Input::shape` does
//! not make itself. Most parameters of a shape must be positive or ascending, so the numbers made here mostly
//! are. Building refuses the others.

use groundtruth::math::Vector;
use groundtruth::shapes::{self, BoundaryMaterials, Kind, Materials, Term};

use super::input::{Input, Mode};

/// A size: in grid mode from ⅛ to 8, otherwise any number, mostly its absolute value.
fn size(input: &mut Input<'_>) -> f64 {
    match input.mode {
        Mode::Grid => (1.0 + f64::from(input.byte() % 64)) / 8.0,
        Mode::Chaos => {
            let any = input.number();
            if input.byte() < 240 { any.abs() } else { any }
        }
    }
}

/// Two sizes, mostly the smaller one first.
fn sizes(input: &mut Input<'_>) -> [f64; 2] {
    let [a, b] = [size(input), size(input)];
    if a < b || input.byte() >= 240 { [a, b] } else { [b, a] }
}

/// Two numbers, mostly the smaller one first.
fn heights(input: &mut Input<'_>) -> [f64; 2] {
    let [a, b] = [input.number(), input.number()];
    if a < b || input.byte() >= 240 { [a, b] } else { [b, a] }
}

/// An angle in degrees: a multiple of 15 up to `most`, or any number.
fn degrees(input: &mut Input<'_>, most: u8) -> f64 {
    match input.byte() {
        choice @ 0..200 => 15.0 * f64::from(choice % (most / 15 + 1)),
        _ => input.number(),
    }
}

fn azimuths(input: &mut Input<'_>) -> [f64; 2] {
    // up to 360, which is too large for `most`, a `u8`
    [(); 2].map(|()| degrees(input, 180) + degrees(input, 180))
}

fn polar_angles(input: &mut Input<'_>) -> [f64; 2] {
    [degrees(input, 90), degrees(input, 90) + 90.0]
}

/// The number of kinds of surfaces.
const SURFACES: u8 = 10;
/// The number of kinds of solids.
const SOLIDS: u8 = 12;

/// A surface, a solid, or a composite shape.
pub fn kind(input: &mut Input<'_>) -> Kind {
    let choice = input.byte();
    match choice {
        0..120 => surface(choice % SURFACES, input),
        120..230 => solid(choice % SOLIDS, input),
        _ => composite(choice % 5, input),
    }
}

fn surface(choice: u8, input: &mut Input<'_>) -> Kind {
    let inward = choice.is_multiple_of(2);
    let center = input.point();
    match choice {
        0 => {
            let (normal, [inner_radius, outer_radius]) = (input.vector(), sizes(input));
            shapes::Annulus { center, normal, inner_radius, outer_radius }.into()
        }
        1 => {
            let ([inner_radius, outer_radius], phi) = (sizes(input), azimuths(input));
            let normal = match input.byte() % 3 {
                0 => Vector::Y,
                1 => -Vector::Y,
                _ => input.vector(), // refused, most of the time
            };
            shapes::PartAnnulus { center, inner_radius, outer_radius, phi, normal }.into()
        }
        2 => shapes::Cone { height: size(input), radius: size(input), inward }.into(),
        3 => shapes::Paraboloid { height: size(input), radius: size(input), inward }.into(),
        4 => {
            let (radius, phi) = (size(input), azimuths(input));
            shapes::PartSphere { center, radius, phi, theta: polar_angles(input), inward }.into()
        }
        5 => {
            let ([y0, y1], radius) = (heights(input), size(input));
            shapes::PartCylinder { y0, y1, radius, phi: azimuths(input), inward }.into()
        }
        6 => {
            let [tube_radius, swept_radius] = sizes(input);
            shapes::Torus { swept_radius, tube_radius, inward }.into()
        }
        7 => {
            let [tube_radius, swept_radius] = sizes(input);
            let [phi, theta] = [azimuths(input), azimuths(input)];
            shapes::PartTorus { swept_radius, tube_radius, phi, theta, inward }.into()
        }
        8 => {
            let terms = 1 + input.byte() % 6;
            let terms = (0..terms).map(|_| Term {
                coefficient: input.number(),
                powers: std::array::from_fn(|_| u32::from(input.byte() % 3)),
            });
            let terms = terms.collect();
            shapes::Algebraic { terms, min: center, max: input.point() }.into()
        }
        _ => {
            let [radius, size] = sizes(input);
            shapes::CutFace { size, radius }.into()
        }
    }
}

fn solid(choice: u8, input: &mut Input<'_>) -> Kind {
    let materials = Materials::new();
    let ([y0, y1], [inner_radius, outer_radius]) = (heights(input), sizes(input));
    let bevel = 0.25 * size(input);
    match choice {
        0 => shapes::SolidCylinder { y0, y1, radius: outer_radius, materials }.into(),
        1 => shapes::SolidCone { height: inner_radius, radius: outer_radius, materials }.into(),
        2 => shapes::ThickRing { y0, y1, inner_radius, outer_radius, materials }.into(),
        3 | 4 => {
            let opening = degrees(input, 180) + degrees(input, 180);
            if choice == 3 {
                shapes::FlatRimmedBowl { inner_radius, outer_radius, opening, materials }.into()
            } else {
                shapes::RoundRimmedBowl { inner_radius, outer_radius, opening, materials }.into()
            }
        }
        5 => {
            let [min_distance, thickness] = [inner_radius, outer_radius];
            shapes::ConcaveLens { radius: size(input), thickness, min_distance, materials }.into()
        }
        6 => {
            let min = input.point();
            let sides = Vector::new(size(input), size(input), size(input));
            shapes::BeveledBox { min, max: min + sides, bevel, materials }.into()
        }
        7 => shapes::BeveledCylinder { y0, y1, radius: outer_radius, bevel, materials }.into(),
        8 => vessel_of_water(input),
        9 => fish_bowl(input),
        10 => shapes::BeveledRing { y0, y1, inner_radius, outer_radius, bevel, materials }.into(),
        _ => {
            let phi = azimuths(input);
            shapes::BeveledWedge { y0, y1, inner_radius, outer_radius, phi, bevel, materials }
                .into()
        }
    }
}

fn vessel_of_water(input: &mut Input<'_>) -> Kind {
    let [meniscus_radius, inner_radius] = sizes(input);
    let [base_thickness, water_height] = sizes(input);
    shapes::GlassOfWater {
        height: water_height + meniscus_radius + size(input),
        inner_radius,
        wall_thickness: size(input),
        base_thickness,
        water_height,
        meniscus_radius: 0.5 * meniscus_radius,
        materials: BoundaryMaterials::default(),
    }
    .into()
}

fn fish_bowl(input: &mut Input<'_>) -> Kind {
    let [meniscus_radius, inner_radius] = sizes(input);
    shapes::FishBowl {
        inner_radius,
        glass_thickness: 0.25 * size(input),
        water_depth: 0.5 * (size(input) + inner_radius),
        meniscus_radius: 0.125 * meniscus_radius,
        opening: degrees(input, 180),
        materials: BoundaryMaterials::default(),
    }
    .into()
}

/// A composite shape of few parts, because one is built for every input.
fn composite(choice: u8, input: &mut Input<'_>) -> Kind {
    let count = 1 + u32::from(input.byte() % 4);
    let (materials, accel) = (Materials::new(), None);
    let [small, large] = sizes(input);
    let bevel = 0.25 * size(input);
    match choice {
        0 => {
            let [y0, y1] = heights(input);
            let [hole_radius, ring_width] = [small, large];
            let rings = count.min(2);
            let rosette =
                shapes::Rosette { rings, hole_radius, ring_width, bevel, y0, y1, accel, materials };
            rosette.into()
        }
        1 => shapes::Archway {
            width: large,
            height: size(input) + large,
            depth: size(input),
            column_width: 0.25 * small,
            blocks: count,
            wedges: 2 + count,
            bevel,
            accel,
            materials,
        }
        .into(),
        2 => {
            let spacing = input.vector();
            let counts = [count, 1 + u32::from(input.byte() % 3), 1];
            let of = Box::new(surface(input.byte() % SURFACES, input));
            shapes::Lattice { of, counts, spacing, accel }.into()
        }
        3 => {
            let seed = u64::from(input.byte());
            let (radius, half_side) = (small, large);
            shapes::RandomSpheres { count: 4 * count, radius, half_side, seed, accel }.into()
        }
        _ => {
            let part = |_| {
                let choice = input.byte();
                if choice < 200 {
                    surface(choice % SURFACES, input)
                } else {
                    solid(choice % SOLIDS, input)
                }
            };
            shapes::Compound::of((0..count).map(part).collect::<Vec<_>>()).into()
        }
    }
}
