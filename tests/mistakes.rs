//! Known mistakes: the recorder that weighs terms anew, each mistake, and the table of the scenes that show them.

#[path = "mistakes/cameras.rs"]
mod cameras;
#[path = "mistakes/closed_forms.rs"]
mod closed_forms;
#[path = "mistakes/glass.rs"]
mod glass;
#[path = "mistakes/lamps.rs"]
mod lamps;
#[path = "mistakes/local.rs"]
mod local;
#[path = "mistakes/paths.rs"]
mod paths;
#[path = "mistakes/recorder.rs"]
mod recorder;
#[path = "mistakes/stage.rs"]
mod stage;
#[path = "mistakes/table.rs"]
mod table;
#[path = "mistakes/textures.rs"]
mod textures;
#[path = "mistakes/twins.rs"]
mod twins;
