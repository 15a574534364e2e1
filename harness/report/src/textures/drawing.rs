//! Page 5 as tables and plots, from its data alone.

use super::{ChoiceData, Data, Level, SceneData};
use crate::html::{Table, capital, escaped, figure, flagged, listed, short, short_or_dash, time};
use crate::plot::{Plot, Series};
use groundtruth::film::{Film, OutOfGamut, Tone, data_uri};
use groundtruth::textures::Filtering;

pub fn page(data: &Data) -> String {
    let mut html = explanation();
    html += &format!("<p class=\"pick\"><strong>What to pick.</strong> {}</p>\n", pick(data));
    data.scenes.iter().for_each(|scene| html += &section(scene));
    html
}

fn explanation() -> String {
    "<p>The colour at a point of an image is that of the <em>nearest</em> texel, as in the book, or the \
     <em>bilinear</em> interpolation of the four texels around it. Neither filters over the pixel: \
     samples do this. Each picture is compared with a reference of the same look-up and very many \
     samples, so that the error (root mean square over pixels and channels, of radiance from 0 to 1) is \
     caused only by too few samples: jagged edges, and moiré patterns where a pixel has many texels. \
     Samples are multi-jittered. The difference of the two references is the effect of the look-up \
     itself: bilinear look-up blurs details smaller than two texels.</p>\n"
        .to_owned()
}

fn name(choice: &ChoiceData) -> &'static str {
    match choice.filtering {
        Filtering::Nearest => "nearest",
        Filtering::Bilinear => "bilinear",
    }
}

/// The error of bilinear look-up with the largest number of samples, and its time, relative to
/// those of nearest look-up.
fn ratios(scene: &SceneData) -> Option<[f64; 2]> {
    let [nearest, bilinear] = &scene.choices[..] else { return None };
    let error = bilinear.levels.last()?.rmse / nearest.levels.last()?.rmse;
    Some([error, bilinear.sample_seconds() / nearest.sample_seconds()])
}

fn pick(data: &Data) -> String {
    let found = data.scenes.iter().filter_map(|scene| Some((scene, ratios(scene)?)));
    let words = found.map(|(scene, [error, time])| {
        format!(
            "{} times the error of the nearest texel in {} times its time ({})",
            short(error),
            short(time),
            scene.scene
        )
    });
    let slopes = data.scenes.iter().flat_map(|scene| &scene.choices).filter_map(|c| c.slope);
    let steepest = slopes.clone().map(|[slope, ..]| slope).fold(f64::INFINITY, f64::min);
    let flattest = slopes.map(|[slope, ..]| slope).fold(f64::NEG_INFINITY, f64::max);
    let words = listed(&words.collect::<Vec<String>>());
    format!(
        "Choose the look-up by the appearance of texels in close-up, squares or a blur, and reduce moiré \
         patterns by more samples. With the same number of samples, bilinear look-up has {words}; the \
         errors of both fall with N to the power of {} to {}.",
        short(flattest).replace('-', "−"),
        short(steepest).replace('-', "−"),
    )
}

fn section(scene: &SceneData) -> String {
    let mut html = format!(
        "<h3>{}</h3>\n<p>{} {} × {} pixels{}; references of {} samples, which differ by {} between the \
         look-ups.</p>\n",
        capital(&scene.scene),
        escaped(&scene.about),
        scene.width,
        scene.height,
        if scene.moments == 1 { String::new() } else { format!(", {} frames", scene.moments) },
        scene.reference_samples,
        short(scene.difference),
    );
    html.push_str("<div class=\"pictures\">\n");
    let samples = |level: &Level| f64::from(level.samples);
    html += &figure(&plot(scene, "samples per pixel", samples).svg(), "Error against samples.");
    let seconds = |level: &Level| level.picture_seconds;
    html += &figure(
        &plot(scene, "seconds for the picture, on one thread", seconds).svg(),
        "The same against time.",
    );
    html.push_str("</div>\n");
    html += &pictures(scene);
    html + &table(scene).html()
}

fn plot(scene: &SceneData, x: &str, along: impl Fn(&Level) -> f64) -> Plot {
    let series = |choice: &ChoiceData| Series {
        name: name(choice).to_owned(),
        points: choice.levels.iter().map(|level| (along(level), level.rmse)).collect(),
        joined: true,
        ..Series::default()
    };
    Plot {
        x: x.to_owned(),
        y: "error".to_owned(),
        series: scene.choices.iter().map(series).collect(),
        limit: None,
    }
}

fn pictures(scene: &SceneData) -> String {
    let tone = Tone { exposure: 1.0, gamma: 2.2, out_of_gamut: OutOfGamut::MaxToOne };
    let image = |film: &Film, words: &str| {
        let img = format!("<img alt=\"{}\" src=\"{}\"/>", escaped(words), data_uri(film, &tone));
        figure(&img, words)
    };
    let mut html = "<div class=\"crops\">\n".to_owned();
    for choice in &scene.choices {
        let [one, reference] = &choice.pictures;
        html += &image(one, &format!("{}, 1 sample", name(choice)));
        let words = format!("{}, {} samples", name(choice), scene.reference_samples);
        html += &image(reference, &words);
    }
    html + "</div>\n"
}

fn table(scene: &SceneData) -> Table {
    let counts: Vec<u32> =
        scene.choices.first().map_or(&[][..], |c| &c.levels).iter().map(|l| l.samples).collect();
    let row = |choice: &ChoiceData| {
        let mut cells = vec![name(choice).to_owned()];
        cells.extend(choice.levels.iter().map(|level| short(level.rmse)));
        let disturbed = choice.levels.iter().any(|level| level.disturbed);
        cells.push(flagged(time(choice.sample_seconds()), disturbed));
        cells.push(short_or_dash(choice.slope.map(|[slope, ..]| slope)).replace('-', "−"));
        cells
    };
    let mut headings = vec!["look-up".to_owned()];
    headings.extend(counts.iter().map(u32::to_string));
    headings.extend(["time per sample of all pixels", "slope"].map(str::to_owned));
    Table {
        caption: format!("{}: error and time", capital(&scene.scene)),
        groups: vec![
            (String::new(), 1),
            ("error, by samples".to_owned(), counts.len()),
            (String::new(), 2),
        ],
        headings,
        rows: scene.choices.iter().map(row).collect(),
    }
}
