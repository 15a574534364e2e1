//! A right lobe keeps all laws, at every roughness, in single and in double precision.

use ask::Subject;
use claims::{ClaimsCard, ClaimsOptions, LawStatus, listed, run};
use testkit::as_many;

use super::rough::Rough;

pub fn card(subject: &mut dyn Subject, cases: usize, seed: u64) -> ClaimsCard {
    let lobes = listed(subject).expect("it lists its lobes");
    run(subject, &lobes, ClaimsOptions { cases, seed }, &mut |_| {})
}

/// Law: right lobes raise no alarm at any roughness, and nearly all is decided. Oracle: the papers; the binomial distribution, by
/// which of 20 cards more than 2 are wrong at a level of 1 % with a probability of 0.001.
#[test]
fn right_lobes_keep_all_laws() {
    let (cards, most) = as_many((1, 0), (20, 2));
    for is_single in [false, true] {
        let mut alarms = 0;
        for seed in 0..cards {
            let card = card(&mut Rough { is_single, lacks: false }, 6, seed);
            if card.is_failed() {
                alarms += 1;
                println!("{card}");
            }
            let laws = &card.rows[0].laws;
            let open = laws.iter().filter(|it| matches!(it, LawStatus::Undecided(_))).count();
            assert!(open <= 1, "{laws:?}");
        }
        assert!(alarms <= most, "{alarms} of {cards} cards are wrong, single: {is_single}");
    }
}
