//! `groundtruth probe`.

use conform::probe;

use super::{Exit, Outcome};

pub fn run() -> Outcome {
    match probe::serve(std::io::stdin().lock(), std::io::stdout().lock()) {
        Ok(true) => Ok(Exit::Yes),
        Ok(false) => Ok(Exit::Unanswered),
        // a closed pipe (`| head`) is not an error
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(Exit::Yes),
        Err(error) => Err(error.into()),
    }
}
