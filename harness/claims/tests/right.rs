//! A right lobe keeps all laws, at every roughness, in single and in double precision.

use ask::Subject;
use claims::{ClaimsCard, ClaimsOptions, LawStatus, listed, run};
use statistics::significance::proportion;

use super::rough::Rough;

pub fn card(subject: &mut dyn Subject, cases: usize, seed: u64) -> ClaimsCard {
    let lobes = listed(subject).expect("it lists its lobes");
    run(subject, &lobes, ClaimsOptions { cases, seed }, &mut |_| {})
}

fn false_alarms(seeds: std::ops::Range<u64>, cases: usize, is_single: bool) -> u64 {
    let mut alarms = 0;
    for seed in seeds {
        let card = card(&mut Rough { is_single, lacks: false }, cases, seed);
        if card.is_failed() {
            alarms += 1;
            println!("{card}");
        }
    }
    alarms
}

/// Law: a right lobe raises no alarm at any roughness, and nearly all is decided. Oracle: the papers.
#[test]
fn right_lobes_keep_all_laws() {
    for is_single in [false, true] {
        let card = card(&mut Rough { is_single, lacks: false }, 6, 0);
        assert!(!card.is_failed(), "{card}");
        let laws = &card.rows[0].laws;
        let open = laws.iter().filter(|it| matches!(it, LawStatus::Undecided(_))).count();
        assert!(open <= 1, "{laws:?}");
    }
}

/// Law: of 300 cards at most as many are wrong as the level says. Oracle: the binomial distribution at 99 %.
#[test]
#[ignore = "thorough: about half an hour in a release build"]
fn false_alarms_are_as_rare_as_the_level_says() {
    for is_single in [false, true] {
        let alarms = false_alarms(1000..1150, 8, is_single);
        println!("{alarms} of 150, single: {is_single}");
        assert!(proportion(alarms, 150, 0.99)[0] <= 0.01, "{alarms} of 150 cards");
    }
}
