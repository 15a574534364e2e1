//! The oracle's shapes of questions.

use conform::{self, Profile, Status};
use oracle::Shape;
use oracle::hard::{Family, Kind, cases};

use super::altered::card;

/// The shape inside all instances.
fn innermost(shape: &Shape) -> &Shape {
    match shape {
        Shape::Instance { of, .. } => innermost(of),
        shape => shape,
    }
}

/// Law: a shape of the oracle, written as one of ours and read back, is the same shape; of an instance, the shape inside
/// it (the contract of instances has the law of the matrix). Oracle: the shape at the start.
#[test]
fn shapes_go_to_ours_and_back() {
    for kind in Kind::ALL {
        for (shape, _) in cases(kind, Family::Ordinary, 3, 5) {
            let ours = exact::our_shape(&shape).expect("ours has this shape");
            let back = exact::oracle_shape(&ours).expect("the oracle has this shape");
            assert_eq!(innermost(&back), innermost(&shape), "{kind:?}");
        }
    }
}

/// Law: the library's own answers pass everything, no judge fails at them, and most of them are decided. Oracle: exact answers and laws;
/// values held against themselves cannot fail.
#[test]
fn our_own_answers_pass() {
    let card = card(&mut conform::Ours, &[], Profile::Careful, 4);
    assert!(!card.is_failed() && !card.is_not_judged(), "{card}");
    assert!(card.count(Status::Pass) > 4 * card.count(Status::Undecided), "{card}");
}
