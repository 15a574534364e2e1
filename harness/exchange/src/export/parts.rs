//! Shapes that are made of others, taken apart.

use groundtruth::math::{Pcg32, Point, Step, Vector, hash};
use groundtruth::rgb::Rgb;
use groundtruth::shapes::{
    Annulus, Cone, Disk, Instance, Kind, Lattice, Materials, OpenCylinder, SolidCone,
    SolidCylinder, ThickRing,
};

/// A part of a shape.
pub struct SolidPart {
    /// Its place in the whole, as `parts[2]` or `wall`.
    pub name: String,
    /// The name of its material; that of the whole if `None`.
    pub material: Option<String>,
    /// Its shape.
    pub shape: Kind,
}

/// The parts of a shape, in order, of a lattice its copies; `None` if it has none.
pub fn parts(kind: &Kind) -> Option<Vec<SolidPart>> {
    Some(match kind {
        Kind::Compound(it) => {
            let parts = it.parts.iter().map(|part| (part.material.clone(), part.shape.clone()));
            numbered("parts", parts)
        }
        Kind::SolidCylinder(it) => solid_cylinder(it),
        Kind::SolidCone(it) => solid_cone(it),
        Kind::ThickRing(it) => thick_ring(it),
        Kind::RandomSpheres(it) => {
            numbered("spheres", it.spheres().into_iter().map(|sphere| (None, sphere.into())))
        }
        Kind::Lattice(it) => copies(it),
        _ => return None,
    })
}

fn copies(it: &Lattice) -> Vec<SolidPart> {
    let [columns, rows, layers] = it.counts;
    let [x, y, z] = it.spacing.to_array();
    let mut copies = Vec::new();
    for k in 0..layers {
        for j in 0..rows {
            for i in 0..columns {
                let [i, j, k] = [i, j, k].map(f64::from);
                let shift = Step::Translate(Vector::new(i * x, j * y, k * z));
                copies.push((None, Instance::new((*it.of).clone(), vec![shift]).into()));
            }
        }
    }
    numbered("copies", copies)
}

/// How many shapes that are not taken apart are in a shape.
pub fn leaves(kind: &Kind) -> u64 {
    match kind {
        Kind::Compound(it) => it.parts.iter().map(|part| leaves(&part.shape)).sum(),
        Kind::SolidCylinder(_) => 3,
        Kind::SolidCone(_) => 2,
        Kind::ThickRing(_) => 4,
        Kind::RandomSpheres(it) => it.count.into(),
        Kind::Instance(it) => leaves(&it.of),
        Kind::Lattice(it) => {
            it.counts.iter().fold(leaves(&it.of), |all, &count| all.saturating_mul(count.into()))
        }
        _ => 1,
    }
}

/// The colour that `random_colors` gives to a shape of an object.
pub fn random_color(seed: u64, leaf: u64) -> Rgb {
    let mut random = Pcg32::new(hash(&[seed, leaf]), 0);
    let mut channel = || random.uniform();
    Rgb::new(channel(), channel(), channel())
}

fn numbered(list: &str, parts: impl IntoIterator<Item = (Option<String>, Kind)>) -> Vec<SolidPart> {
    let part = |(index, (material, shape))| SolidPart {
        name: format!("{list}[{index}]"),
        material,
        shape,
    };
    parts.into_iter().enumerate().map(part).collect()
}

fn named<const N: usize>(parts: [(&str, Kind); N], materials: &Materials) -> Vec<SolidPart> {
    let part = |(name, shape): (&str, Kind)| SolidPart {
        name: name.to_owned(),
        material: materials.get(name).cloned(),
        shape,
    };
    parts.into_iter().map(part).collect()
}

fn solid_cylinder(it: &SolidCylinder) -> Vec<SolidPart> {
    let SolidCylinder { y0, y1, radius, .. } = *it;
    let parts = [
        ("bottom", Disk { center: on_axis(y0), normal: -Vector::Y, radius }.into()),
        ("top", Disk { center: on_axis(y1), normal: Vector::Y, radius }.into()),
        ("wall", OpenCylinder { y0, y1, radius, inward: false }.into()),
    ];
    named(parts, &it.materials)
}

fn solid_cone(it: &SolidCone) -> Vec<SolidPart> {
    let SolidCone { height, radius, .. } = *it;
    let parts = [
        ("base", Disk { center: on_axis(0.0), normal: -Vector::Y, radius }.into()),
        ("wall", Cone { height, radius, inward: false }.into()),
    ];
    named(parts, &it.materials)
}

fn thick_ring(it: &ThickRing) -> Vec<SolidPart> {
    let ThickRing { y0, y1, inner_radius, outer_radius, .. } = *it;
    let lid = |y, normal| Annulus { center: on_axis(y), normal, inner_radius, outer_radius }.into();
    let wall = |radius, inward| OpenCylinder { y0, y1, radius, inward }.into();
    let parts = [
        ("bottom", lid(y0, -Vector::Y)),
        ("top", lid(y1, Vector::Y)),
        ("inner_wall", wall(inner_radius, true)),
        ("outer_wall", wall(outer_radius, false)),
    ];
    named(parts, &it.materials)
}

fn on_axis(y: f64) -> Point {
    Point::new(0.0, y, 0.0)
}
