//! The contract of each trait, tested for every kind in its list, and the golden images.
//!
//! The names are made from the lists: `ch19::disk::contract::hits_lie_on_the_surface`,
//! `ch24::golden::hall_of_mirrors`. So a new kind is tested as soon as it has an entry, and `cargo test ch19`
//! runs the contracts of chapter 19 beside its own laws.

mod bump;
mod camera;
mod filter;
mod golden;
mod light;
mod light_sampling;
mod lobe;
mod material;
mod rays;
mod sampler;
mod sampler_draws;
mod shape;
mod shape_exact;
mod shape_hard;
mod shape_leaving;
mod texture;

use std::fmt::Debug;

use groundtruth::kinds::Entry;
use libtest_mimic::{Arguments, Trial};

/// Whether a law holds, or what breaks it.
type Holds = Result<(), String>;

/// Breaks the law unless the condition is true.
macro_rules! ensure {
    ($condition:expr, $($words:tt)+) => {
        match $condition {
            true => {}
            // also if a number is NaN
            false => {
                let found = format!($($words)+);
                return Err(format!("found {found}\nexpected `{}`", stringify!($condition)));
            }
        }
    };
}
pub(crate) use ensure;

/// A law of one specimen: its name, as a sentence, and its test.
type Law<Kind> = (&'static str, fn(&Kind) -> Holds);

/// One test for each kind and law.
fn trials<Kind: Debug + 'static>(
    entries: &'static [Entry<Kind>],
    laws: &'static [Law<Kind>],
) -> Vec<Trial> {
    let mut trials = Vec::new();
    for entry in entries {
        for (name, law) in laws {
            let name = format!("{}::{}::contract::{name}", entry.chapter, entry.module);
            trials.push(Trial::test(name, || {
                let specimens = (entry.specimens)();
                if specimens.is_empty() {
                    return Err(format!("{} has no specimens", entry.module).into());
                }
                for specimen in specimens {
                    law(&specimen).map_err(|broken| format!("{specimen:?}: {broken}"))?;
                }
                Ok(())
            }));
        }
    }
    trials
}

fn main() {
    let arguments = Arguments::from_args();
    let mut all = Vec::new();
    all.extend(shape::trials());
    all.extend(lobe::trials());
    all.extend(sampler::trials());
    all.extend(camera::trials());
    all.extend(filter::trials());
    all.extend(light::trials());
    all.extend(texture::trials());
    all.extend(material::trials());
    all.extend(bump::trials());
    all.extend(golden::trials());
    all.sort_by(|a, b| a.name().cmp(b.name()));
    libtest_mimic::run(&arguments, all).exit();
}
