//! The page docs/mistakes.md.

use text::document::*;

use super::local::of_one_material;
use super::table::{CHANGE, SAMPLES, SHARE, WIDTH};
use super::{Cover, Mistake, all, fewest_scenes, forms, scenes_that_show};

/// The page, as Markdown.
pub fn page() -> String {
    let all = all();
    let mut chapters: Vec<u32> = all.iter().map(|mistake| mistake.chapter).collect();
    chapters.dedup();
    let forms = forms().into_iter().filter_map(|it| Some((it.name, it.form?)));
    let forms = table(forms)
        .column("mistake", |(name, _)| code(*name))
        .column("the same, …", |(_, form)| format!("…, {form}"));
    format!(
        include_str!("page.txt"),
        count = all.len(),
        share = 100.0 * SHARE,
        change = 100.0 * CHANGE,
        width = WIDTH,
        samples = SAMPLES,
        mistakes = markdown(mistakes(&all)),
        forms = markdown(forms),
        local = list(of_one_material().map(|known| known.words)).markdown().trim_end(),
        chapters = markdown(covers(&chapters)),
    )
}

fn markdown<R>(table: Table<R>) -> String {
    table.element().markdown().trim_end().to_owned()
}

fn mistakes<'a>(all: &'a [&'static Mistake]) -> Table<&'a &'static Mistake> {
    let how = |mistake: &Mistake| if mistake.is_reweighed() { "terms" } else { "scene" };
    let best = |mistake: &Mistake| {
        let best = scenes_that_show(mistake).into_iter().take(3);
        let words = best.map(|it| format!("{} ({:.0} %)", it.scene, 100.0 * it.effect.share));
        words.collect::<Vec<_>>().join(", ")
    };
    table(all)
        .column("mistake", |it| code(it.name))
        .column("the picture agrees with ours if …", |it| it.words)
        .column("in the book", |it| it.place)
        .column("made by", move |it| how(it))
        .column("scenes", |it| scenes_that_show(it).len().to_string())
        .column("best three", move |it| best(it))
}

fn covers(chapters: &[u32]) -> Table<(&u32, Cover)> {
    let never = |cover: &Cover| {
        let names: Vec<_> = cover.never_shown.iter().map(|it| format!("`{}`", it.name)).collect();
        names.join(", ")
    };
    let scenes =
        |cover: &Cover| cover.scenes.iter().map(|(scene, _)| *scene).collect::<Vec<_>>().join(", ");
    table(chapters.iter().map(|chapter| (chapter, fewest_scenes(*chapter))))
        .column("chapter", |(chapter, _)| chapter.to_string())
        .column("scenes", move |(_, cover)| scenes(cover))
        .column("mistakes that no scene shows", move |(_, cover)| never(cover))
}
