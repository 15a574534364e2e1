//! Development only.
#[path = "chapters/replicas.rs"]
mod replicas;
#[path = "chapters/support.rs"]
mod support;
#[path = "chapters/ch14"]
mod ch14 {
    pub mod stage;
}
#[path = "chapters/ch31"]
mod ch31 {
    mod bumps;
    mod furnace;
    mod noise;
    mod oracle;
    mod statistics;
    mod sums;
    mod textures;
    mod wood;
}
