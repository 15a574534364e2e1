//! The contract of [`Bump`] (Suffern, ch. 31).

use std::sync::Arc;

use groundtruth::bumps::{Bump, Kind};
use groundtruth::kinds::Resources;
use groundtruth::math::{Vector, power_of_two};
use groundtruth::shapes::Surface;
use groundtruth::textures::TexturePoint;
use libtest_mimic::Trial;

use super::texture::{scaled_surface, surfaces};
use super::{Holds, ensure};
use testkit::scaling::scaled;

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("normals_are_turned_everywhere", normals_are_turned_everywhere),
            ("the_bump_moves_with_the_object", the_bump_moves_with_the_object),
            ("scaling_by_a_power_of_two_keeps_every_bit", scaling_keeps_every_bit),
        ],
    )
}

fn built(kind: &Kind) -> Arc<dyn Bump> {
    kind.build(&mut Resources::default()).expect("specimens are valid")
}

fn perturbed(bump: &dyn Bump, at: &Surface) -> Vector {
    bump.perturbed(&TexturePoint::new(at), at.normal)
}

/// Law: a bump gives the same answer each time, at every point, and a specimen turns many normals.
fn normals_are_turned_everywhere(kind: &Kind) -> Holds {
    let bump = built(kind);
    let mut changed = 0;
    for at in surfaces() {
        let found = perturbed(&*bump, &at);
        ensure!(found.is_finite(), "{:?}: {found:?}", at.local);
        ensure!(perturbed(&*bump, &at) == found, "{:?}: two answers", at.local);
        let tilt = found.cross(at.normal).length();
        changed += u32::from(tilt > 1e-3);
    }
    // far away a planet's map has no slope
    ensure!(changed > 100, "only {changed} of 2000 normals were turned");
    Ok(())
}

/// Law: the position of the object in the world does not matter, only the point on it.
fn the_bump_moves_with_the_object(kind: &Kind) -> Holds {
    let bump = built(kind);
    for at in surfaces() {
        let moved = Surface { point: at.point + Vector::new(0.3, -7.0, 11.1), ..at.clone() };
        let (here, there) = (perturbed(&*bump, &at), perturbed(&*bump, &moved));
        ensure!(here == there, "{:?}: {here:?}, moved {there:?}", at.local);
    }
    Ok(())
}

fn scaling_keeps_every_bit(kind: &Kind) -> Holds {
    let bump = built(kind);
    for k in [1, -7, 30, -30] {
        let larger = built(&scaled(kind, power_of_two(k)));
        for at in surfaces() {
            let (here, there) = (
                perturbed(&*bump, &at),
                perturbed(&*larger, &scaled_surface(&at, power_of_two(k))),
            );
            ensure!(here == there, "{:?}, 2^{k}: {there:?}, not {here:?}", at.local);
        }
    }
    Ok(())
}
