//! Which scenes of the gallery show which mistakes, as `groundtruth mistakes --table` measured it.

use std::sync::LazyLock;

use super::table::Effect;
use super::{Mistake, all, find};

/// A scene that shows a mistake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MistakeInScene {
    /// The scene.
    pub scene: &'static str,
    /// The mistake.
    pub mistake: &'static Mistake,
    /// How much it changes the picture.
    pub effect: Effect,
}

/// The first line of the table.
pub const HEADING: &str = "scene,mistake,share,largest\n";

/// The table.
pub const TABLE: &str = include_str!("shown.csv");

static PAIRS: LazyLock<Vec<MistakeInScene>> = LazyLock::new(|| {
    let parsed = |line: &'static str| {
        let [scene, mistake, share, largest] =
            line.split(',').collect::<Vec<_>>().try_into().ok()?;
        let effect = Effect { share: share.parse().ok()?, largest: largest.parse().ok()? };
        Some(MistakeInScene { scene, mistake: find(mistake)?, effect })
    };
    let lines = TABLE.lines().skip(1);
    lines.map(|line| parsed(line).unwrap_or_else(|| panic!("shown.csv: {line}"))).collect()
});

/// All pairs of a scene and a mistake that it shows.
pub fn pairs() -> &'static [MistakeInScene] {
    &PAIRS
}

/// The scenes that show a mistake, those in which it changes most pixels first.
pub fn scenes_that_show(mistake: &Mistake) -> Vec<&'static MistakeInScene> {
    let mut scenes: Vec<&MistakeInScene> =
        pairs().iter().filter(|pair| pair.mistake == mistake).collect();
    scenes.sort_by(|a, b| b.effect.share.total_cmp(&a.effect.share));
    scenes
}

/// The mistakes that a scene of the gallery shows.
pub fn shown_by(scene: &str) -> Vec<&'static MistakeInScene> {
    pairs().iter().filter(|pair| pair.scene == scene).collect()
}

/// The mistakes that a scene of the gallery does not show, as [`others`]. `None` for other scenes, which were not
/// measured.
pub fn not_shown_by(scene: &str) -> Option<Vec<(&'static Mistake, Option<&'static str>)>> {
    gallery::find(scene)?;
    let shown: Vec<&Mistake> = shown_by(scene).iter().map(|pair| pair.mistake).collect();
    Some(others(&shown))
}

/// The mistakes that are none of these, each with the scene that shows it best, if one does.
pub fn others(shown: &[&Mistake]) -> Vec<(&'static Mistake, Option<&'static str>)> {
    let hidden = all().into_iter().filter(|mistake| !shown.contains(mistake));
    hidden.map(|it| (it, scenes_that_show(it).first().map(|best| best.scene))).collect()
}

/// A few scenes that together show all mistakes of a chapter that any scene shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cover {
    /// The scenes, each with the mistakes that those before it do not show.
    pub scenes: Vec<(&'static str, Vec<&'static Mistake>)>,
    /// The mistakes that no scene shows.
    pub never_shown: Vec<&'static Mistake>,
}

/// The fewest scenes of the gallery that show all mistakes of a chapter: about so few, because each next scene is the
/// one that shows most of the mistakes that are left. Of equals it is one of that chapter, and then the one in which
/// these mistakes change most pixels. Scenes that are wrong on purpose come last.
pub fn fewest_scenes(chapter: u32) -> Cover {
    let mistakes = all().into_iter().filter(|mistake| mistake.chapter == chapter);
    let is_shown = |mistake: &&Mistake| pairs().iter().any(|pair| pair.mistake == *mistake);
    let (mut left, never_shown): (Vec<&Mistake>, Vec<&Mistake>) = mistakes.partition(is_shown);
    let mut cover = Cover { scenes: Vec::new(), never_shown };
    while let Some((scene, shown)) = best_scene(chapter, &left) {
        left.retain(|mistake| !shown.contains(mistake));
        cover.scenes.push((scene, shown));
    }
    cover
}

/// Whether a scene is a figure of the book of what goes wrong.
pub fn is_wrong_on_purpose(scene: &str) -> bool {
    scene.ends_with("-wrong")
}

/// The scene that shows most of these mistakes, and which of them.
fn best_scene(
    chapter: u32,
    mistakes: &[&'static Mistake],
) -> Option<(&'static str, Vec<&'static Mistake>)> {
    let folder = format!("ch{chapter:02}/");
    let candidates = gallery::scenes().filter_map(|entry| {
        let shown = shown_by(entry.name);
        let shown: Vec<&MistakeInScene> =
            shown.into_iter().filter(|pair| mistakes.contains(&pair.mistake)).collect();
        let pixels: f64 = shown.iter().map(|pair| pair.effect.share).sum();
        let (is_right, is_own) =
            (!is_wrong_on_purpose(entry.name), entry.name.starts_with(&folder));
        let rank = (is_right, shown.len(), is_own);
        (!shown.is_empty()).then_some((rank, pixels, entry.name, shown))
    });
    let best = candidates.max_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let (_, _, scene, shown) = best?;
    Some((scene, shown.into_iter().map(|pair| pair.mistake).collect()))
}
