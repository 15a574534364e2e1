//! Times that are not work.

use std::time::Duration;

use report::clock::*;

/// Law: a waiting thread uses no processor time, and its time is flagged; a computing thread is
/// not flagged. Oracle: the length of the sleep; the definition of 10 %.
#[test]
fn waiting_is_not_work() {
    let (_, waited) = time(|| std::thread::sleep(Duration::from_millis(50)));
    assert!(waited.wall >= 0.05 && waited.cpu < 0.025, "{waited:?}");
    assert!(waited.is_disturbed());
    assert!(!Time { cpu: 0.95, wall: 1.0 }.is_disturbed());
    assert!(Time { cpu: 0.85, wall: 1.0 }.is_disturbed());
}
