//! The oracle's shapes of questions.

use conform::{self, Profile, Status};
use exact::backward_error;
use oracle::hard::{Family, Kind, cases};

use super::altered::card;

/// Law: a shape of the oracle, written as one of ours and read back, is the same shape. Oracle: the shape at the
/// start.
#[test]
fn shapes_go_to_ours_and_back() {
    for kind in Kind::ALL {
        for (shape, _) in cases(kind, Family::Ordinary, 3, 5) {
            let (ours, expected) = backward_error::ours(&shape).expect("ours has this shape");
            assert_eq!(exact::oracle_shape(&ours), Some(expected), "{kind:?}");
        }
    }
}

/// Law: the library's own answers pass everything, and most of them are decided. Oracle: exact answers and laws;
/// values held against themselves cannot fail.
#[test]
fn our_own_answers_pass() {
    let card = card(&mut conform::Ours, &[], Profile::Careful, 4);
    assert!(!card.is_failed(), "{card}");
    assert!(card.count(Status::Pass) > 4 * card.count(Status::Undecided), "{card}");
}
