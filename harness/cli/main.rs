//! The command line: one file for each command.
//!
//! Exit status 0 means yes, 1 means the answer is no, 2 means an error, and 130 means that the user
//! interrupted the command.

mod announce;
mod bounds;
mod columns;
mod compare;
mod conform;
mod describe;
mod exercise;
mod explain;
mod export;
mod goldens;
mod kept;
mod kinds;
mod laws;
mod layers;
mod list;
mod merge;
mod mistake;
mod mistakes;
mod numbers;
mod output;
mod part;
mod probe;
mod program;
mod progress;
mod rays;
mod render;
mod replicas;
mod report;
mod scene;
mod sets;
mod verify;
mod watch;
mod why_not;
mod witness;

use std::error::Error;
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use groundtruth::printable;

/// The version, and the commit that was built.
const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), " (", env!("SOURCE"), ")");

/// Ray tracing from the ground up, verified chapter by chapter.
#[derive(Parser)]
#[command(name = "groundtruth", version = VERSION, propagate_version = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// List the gallery's scenes, by chapter
    List(list::List),
    /// Describe the contents of scene files: every kind and table, its fields, defaults and an
    /// example
    Kinds(kinds::Kinds),
    /// Render a scene to a picture file (.png, or .exr for linear radiance)
    Render(render::Render),
    /// Explain the colour of a pixel: the tree of its rays
    Explain(explain::Explain),
    /// Print the box around each object, and a camera that sees all of them
    ///
    /// Of a mesh file it prints a whole scene to begin with: `groundtruth bounds bunny.ply > bunny.toml`.
    Bounds(bounds::Bounds),
    /// Write a scene as a scene file, or in the language of another renderer
    Export(export::Export),
    /// Describe a scene in words and numbers, to build it in another renderer
    ///
    /// Prints the conventions, the ray of each film point, every light, material and object with all of its numbers,
    /// the formulas of light, and what each word means. No file of ours is needed to use it.
    Describe(describe::Describe),
    /// Compare two pictures, or a picture and a scene
    ///
    /// Prints what differs, where, and which simple change explains it (a flip, a shift by a pixel, an order of
    /// channels, an exposure factor, a transfer function). The exit status is 0 if no pixel differs, 1 if some
    /// do, 2 if they cannot be compared.
    Compare(compare::Compare),
    /// Ask a program questions, and judge its answers
    ///
    /// The program reads a question on each line of its standard input, as `probe` does, and writes a line with its
    /// answer; docs/conform.md describes it. The exit status is 0 if nothing failed, 1 if something did, 2 if the
    /// program answers nothing, or supports nothing of what is asked.
    Conform(conform::Conform),
    /// Ask a program about its own lobes, lights and maps, and hold its answers to each other
    ///
    /// No answer of ours is needed: the program lists its BSDFs and what it claims of them; docs/laws.md describes the
    /// questions, the claims and the laws. The exit status is 0 if no law is broken, 1 if one is, 2 if nothing could
    /// be judged.
    Laws(laws::Laws),
    /// Add the parts that `render --replicas R --part K/N` wrote, on any machines
    ///
    /// Writes the mean of the replicas, and its standard error: the same bits for any division into parts and any order
    /// of them. The mean of replicas is not one picture with more samples: the expected value is the same, but
    /// one large set of stratified samples varies less. docs/many-machines.md has scripts. The exit status is 0 if no
    /// replica is missing; 1 if some are (the commands that render them are printed) or if parts contradict each other;
    /// 2 if a file is damaged or of another scene.
    Merge(merge::Merge),
    /// Judge a picture of a scene by another program: noise or bug, and where
    ///
    /// Renders pictures of ours with other seeds, and says whether theirs is farther from them than they are from each
    /// other. With --before and --after, no scene is needed: two sets of pictures are held against each other, and
    /// docs/ci.md shows how to do so after each change. The exit status is 0 if it agrees, 1 if it differs, 2 if it cannot
    /// be judged.
    Verify(verify::Verify),
    /// Say which ray of a log is wrong, and why
    ///
    /// Your program writes down the rays of a pixel, and laws that need no scene are held against them; docs/rays.md
    /// describes the log. The exit status is 0 if no law is broken, 1 if one is, 2 if the log cannot be read.
    Rays(rays::Rays),
    /// List known mistakes of ray tracers, and the scenes that show them
    ///
    /// docs/mistakes.md has all of them. A picture that agrees with ours says nothing of mistakes that its scene does
    /// not show.
    Mistakes(mistakes::Mistakes),
    /// Make an exercise for a class: pictures of wrong programs, a sheet to fill in, and the key
    ///
    /// Each picture was rendered with one known mistake of the chapter. The sheet (HTML, A4) shows it beside the right
    /// picture; the teacher's key has the reasons, the rays that show each mistake, and the commands that find it.
    Exercise(exercise::Exercise),
    /// Check, review and accept the golden images
    Goldens(goldens::Goldens),
    /// Answer questions in JSON Lines, to check a ray tracer in any language
    ///
    /// Each line of the standard input is one question, such as {"fresnel": {"cos_i": 1, "eta":
    /// 1.5}},
    /// and gets one line with its answer. docs/probe.md describes the questions. The exit status
    /// is 2 if any line got an error.
    Probe,
    /// Measure speed against error on this machine: one HTML page, and its data
    ///
    /// Writes index.html, a self-contained page, and report.json. The pages are: intersections (the
    /// library compared with the textbook's formulas), acceleration (list, grid, bvh, by number of
    /// objects), samplers (by number of samples), light and textures. Each takes up to two minutes.
    Report(report::Report),
}

/// The result of a command: its exit status.
enum Exit {
    Yes = 0,
    No = 1,
    /// The command has already printed the reasons.
    Unanswered = 2,
    Interrupted = 130,
}

type Outcome = Result<Exit, Box<dyn Error>>;

/// Runs the command of the arguments.
fn main() -> ExitCode {
    let matches = with_negative_numbers(Arguments::command()).get_matches();
    let arguments = Arguments::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    let outcome = match arguments.command {
        Command::List(command) => command.run(),
        Command::Kinds(command) => command.run(),
        Command::Laws(command) => command.run(),
        Command::Render(command) => command.run(),
        Command::Explain(command) => command.run(),
        Command::Bounds(command) => command.run(),
        Command::Export(command) => command.run(),
        Command::Describe(command) => command.run(),
        Command::Compare(command) => command.run(),
        Command::Conform(command) => command.run(),
        Command::Merge(command) => command.run(),
        Command::Verify(command) => command.run(),
        Command::Rays(command) => command.run(),
        Command::Mistakes(command) => command.run(),
        Command::Exercise(command) => command.run(),
        Command::Goldens(command) => command.run(),
        Command::Probe => probe::run(),
        Command::Report(command) => command.run(),
    };
    match outcome {
        Ok(exit) => ExitCode::from(exit as u8),
        Err(error) => {
            eprintln!("error: {}", printable::text(&error.to_string()));
            ExitCode::from(2)
        }
    }
}

/// The command, in which `-4` is a number and no option: the parser of the number says what to write.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    command.allow_negative_numbers(true).mut_subcommands(with_negative_numbers)
}

/// Writes to standard output; a closed pipe (`| head`) is not an error.
fn print(text: &str) -> Outcome {
    use std::io::Write;
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(Exit::Yes),
    }
}
