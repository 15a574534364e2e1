//! Known mistakes: the recorder that weighs terms anew, each mistake, and the table of the scenes that show them.

mod beside;
mod cameras;
mod closed_forms;
mod glass;
mod lamps;
mod local;
mod mistaken;
mod paths;
mod recorder;
mod stage;
mod table;
