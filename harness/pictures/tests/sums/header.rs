//! The header of a file of sums.

use pictures::sums::{Header, Made, Seeds};

/// The header of an invented scene.
pub fn header(size: [u32; 2]) -> Header {
    Header {
        program: "1".to_owned(),
        scene: "5".repeat(64),
        made: Made {
            name: "a name".to_owned(),
            image: size,
            tracer: "path".to_owned(),
            max_depth: Some(9),
        },
        size,
        samples: 4,
        arguments: vec!["scene".to_owned()],
        wanted: Seeds::range(0, 8).expect("they fit"),
        seeds: Seeds::default(),
    }
}
