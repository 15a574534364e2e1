//! Known mistakes: the recorder that weighs terms anew, each mistake, and the table of the scenes that show them.

#[path = "mistakes/recorder.rs"]
mod recorder;
