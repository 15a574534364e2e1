//! One known mistake: as an argument of commands, and told.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use clap::Args;
use groundtruth::film;
use groundtruth::scene::Scene;
use groundtruth::similar;
use groundtruth::world::{DEFAULT_SEED, World};
use judge::mistakes::known::KnownMistake;
use judge::mistakes::table::{self, CHANGE, SAMPLES, sized};
use judge::mistakes::{self, Beside, Mistake, MistakeInScene, Mistaken};

use super::scene::SceneArguments;
use super::{Outcome, output};

/// A known mistake with which a picture is rendered or explained.
#[derive(Args)]
pub struct MistakeArgument {
    /// As a program with this known mistake does it (`mistakes` lists them)
    #[arg(long, value_name = "NAME", value_parser = named)]
    mistake: Option<&'static Mistake>,
}

impl MistakeArgument {
    /// The name of the mistake, if there is one.
    pub fn name(&self) -> Option<&'static str> {
        self.mistake.map(|mistake| mistake.name)
    }

    /// The program with the mistake, if there is one, on the scene that was read by these arguments.
    ///
    /// # Errors
    /// The mistake does not apply to the scene.
    pub fn mistaken(
        &self,
        arguments: &SceneArguments,
        scene: &Scene,
    ) -> Result<Option<Mistaken>, Box<dyn Error>> {
        let Some(mistake) = self.mistake else { return Ok(None) };
        let folder = arguments.files_folder();
        let mistaken = Mistaken::new(mistake, scene, folder, arguments.seed)?;
        let KnownMistake { name, words, .. } = mistake.known();
        if mistaken.is_none() {
            let hint = format!("`groundtruth mistakes {name}` lists scenes that show it");
            let problem = format!("the scene has nothing that {name} changes ({words}); {hint}");
            return Err(problem.into());
        }
        Ok(mistaken)
    }
}

/// Says so if a scene does not show the mistake of a program, in the size of the table.
pub fn note_if_not_shown(
    mistaken: &Mistaken,
    arguments: &SceneArguments,
    scene: &Scene,
) -> Result<(), Box<dyn Error>> {
    let KnownMistake { name, .. } = mistaken.mistake().known();
    if table::shown(&[mistaken.mistake()], scene, arguments.files_folder())?.is_empty() {
        let hint = format!("`groundtruth mistakes {name}` lists scenes that do");
        eprintln!("note: this scene does not show {name}: it changes hardly a pixel; {hint}");
    }
    Ok(())
}

/// The mistake of this name.
fn named(name: &str) -> Result<&'static Mistake, String> {
    mistakes::find(name).ok_or_else(|| {
        let names: Vec<&str> = mistakes::all().iter().map(|mistake| mistake.name).collect();
        let similar = similar::did_you_mean(name, &names);
        format!("no known mistake has this name (`groundtruth mistakes` lists them){similar}")
    })
}
/// The width of the pictures of a mistake.
const WIDTH: u32 = 152;
/// So many scenes that show it are named.
const NAMED: usize = 3;

/// Prints what is done wrong, where the book has it right, and how it looks; and writes the picture of it.
pub fn told(mistake: &'static Mistake, file: Option<&Path>) -> Outcome {
    let format = file.map(|file| output::format(file, None)).transpose()?;
    file.map_or(Ok(()), output::writable)?;
    let KnownMistake { name, chapter, words, place, .. } = mistake.known();
    let mut text = format!("{name} (ch. {chapter}): {words}\n  right        {place}\n");
    for form in mistakes::forms().into_iter().filter(|it| it.name == *name) {
        let _ = form.form.map(|form| writeln!(text, "  also         …, {form}"));
    }
    let scenes = mistakes::scenes_that_show(mistake);
    let Some(best) = scenes.first() else {
        return Err(format!("{text}no scene of the gallery shows it").into());
    };
    // `ch28/glass-sphere (62 %)`
    let seen_in = |it: &&MistakeInScene| format!("{} ({:.0} %)", it.scene, 100.0 * it.effect.share);
    let named: Vec<String> = scenes.iter().take(NAMED).map(seen_in).collect();
    let _ = writeln!(text, "  seen best in {} (of {} scenes)", named.join(", "), scenes.len());
    let entry = gallery::find(best.scene).expect("the table is of the gallery");
    let scene = sized((entry.build)(), WIDTH, SAMPLES);
    let beside = Beside::of(mistake, &scene, Path::new(""), DEFAULT_SEED)?;
    let beside = beside.expect("the table says that it is seen");
    let ([x, y], effect) = (beside.most_changed(), beside.effect());
    let size = format!("{}x{}", scene.image.width, scene.image.height);
    let at_this_size = format!("--size {size} --samples {}", scene.image.samples);
    let _ = writeln!(
        text,
        "\nIn {} at {size}, {:.0} % of the pixels change by more than {:.0} %, most that at {x},{y}:\n",
        best.scene,
        100.0 * effect.share,
        100.0 * CHANGE,
    );
    let (joined, tone) = (beside.joined(), scene.image.tone());
    let (scene_name, with) = (best.scene, format!("--mistake {name}"));
    let _ = writeln!(text, "  groundtruth render {scene_name} {with} -o wrong.png");
    let _ = writeln!(text, "  groundtruth explain {scene_name} {x},{y} {at_this_size} {with}");
    if let (Some(file), Some(format)) = (file, format) {
        let world = World::build(&scene)?;
        let mut made =
            pictures::provenance((Some(entry), &scene), (&scene, &world), Path::new(""))?;
        let part = "the right picture, and beside it the wrong one";
        made.part = Some(part.to_owned());
        made.mistake = Some((*name).to_owned());
        output::write(file, &film::encode(&joined, &tone, format, &made)?)?;
        let _ = writeln!(text, "\n{}: {part}", output::name(file));
    }
    output::say(&text, file)
}
