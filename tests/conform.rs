//! Laws of `conform`: the judge is judged.

#[path = "conform/altered.rs"]
mod altered;
#[path = "conform/book.rs"]
mod book;
#[path = "conform/constants.rs"]
mod constants;
#[path = "conform/exact.rs"]
mod exact;
#[path = "conform/harmless.rs"]
mod harmless;
#[path = "conform/mistakes.rs"]
mod mistakes;
#[path = "conform/processes.rs"]
mod processes;
#[path = "conform/radiance.rs"]
mod radiance;
#[path = "conform/runs.rs"]
mod runs;
#[path = "conform/scenes.rs"]
mod scenes;
#[path = "conform/statuses.rs"]
mod statuses;
#[path = "conform/streams.rs"]
mod streams;
