//! Page 1 as tables and a plot, from its data alone.

use super::{Data, FamilyData, KindData, Routine};
use crate::html::{Table, count, figure, flagged, folded, listed, short, short_or_dash};
use crate::plot::{Plot, Series};
use exact::backward_error::ALLOWED;
use statistics::quantile;

/// Smaller errors are drawn at this value: a logarithmic axis has no 0.
const MIN_DRAWN: f64 = 0.01;

pub fn page(data: &Data) -> String {
    let mut html = explanation(data);
    html += &format!("<p class=\"pick\"><strong>What to pick.</strong> {}</p>\n", pick(data));
    html += &overview(data).html();
    html += &figure(&picture(data).svg(), CAPTION);
    html.push_str("<h3>Each shape and family</h3>\n<p>Click on a shape to see its table.</p>\n");
    data.kinds.iter().for_each(|kind| html += &folded(&summary(kind), &details(kind).html()));
    html
}

const CAPTION: &str = "Speed against error. Each number is a shape of the table above. The x axis is \
    the time of a hit on ordinary rays, the y axis the 99.9th percentile of the error in the family \
    where it is largest; lower left is better. Errors of 0.01 or less are drawn at 0.01. Lost and \
    wrong hits are not shown.";

fn explanation(data: &Data) -> String {
    let (kinds, cases) = (data.kinds.len(), data.cases);
    format!(
        "<p>For each of {kinds} shapes, this library's routine is compared with the textbook's: the \
         formula as printed in the book, with its constant epsilon (for algebraic surfaces, which are \
         not in the book, a sign change among samples along the ray). Solids and compounds have the \
         same parts for both, and the textbook tests all of them; copies, random spheres and triangles \
         have the same acceleration structure for both. Both get the same rays, {cases} for each shape \
         (a quarter or a sixteenth for surfaces of high degree and shapes of many parts, whose exact \
         answer takes long) in each of twelve families: ordinary rays, and those for which formulas \
         fail (far origins, grazing and tangent rays, tiny, huge and thin shapes, …). The exact \
         answer is computed with 512 bits.</p>\n\
         <p>The unit of errors is u·cond: the change of the distance if the last bit of the input \
         changes. An error of 1 is the best that any routine can guarantee, up to {ALLOWED} is good, \
         and 10⁶ means that six digits are lost. (Inside an instance, the unit is multiplied by the \
         condition number of its matrix.) A hit is <em>lost</em> if the nearest was not found, and \
         <em>wrong</em> if there is none; rays whose answer depends on the rounding of their input (a \
         relative change by 10⁻¹³ would change it) are not judged. For rays that start on the surface, \
         only hits beyond a millionth of the shape's size are judged; the library's routine is called \
         with this span, the textbook's with its epsilon. A constant epsilon loses every nearer \
         hit. Times are medians for one call on one thread that finds the distance of the nearest hit, \
         without its point and normal.</p>\n"
    )
}

/// One routine of one kind, over all families.
fn routines<'a>(kind: &'a KindData, of: impl Fn(&'a FamilyData) -> &'a Routine) -> Option<Summary> {
    let routines: Vec<&Routine> = kind.families.iter().map(&of).collect();
    let largest = |values: Vec<Option<f64>>| values.into_iter().flatten().reduce(f64::max);
    let ordinary = routines.first()?;
    Some(Summary {
        p999: largest(routines.iter().map(|r| r.p999).collect()),
        worst: largest(routines.iter().map(|r| r.worst).collect()),
        lost: routines.iter().map(|r| r.lost).sum(),
        wrong: routines.iter().map(|r| r.wrong).sum(),
        hit_ns: ordinary.hit_ns,
        miss_ns: ordinary.miss_ns,
    })
}

/// One routine over all families; times on ordinary rays.
struct Summary {
    p999: Option<f64>,
    worst: Option<f64>,
    lost: usize,
    wrong: usize,
    hit_ns: Option<f64>,
    miss_ns: Option<f64>,
}

fn ours(kind: &KindData) -> Option<Summary> {
    routines(kind, |family| &family.ours)
}

fn textbook(kind: &KindData) -> Option<Summary> {
    routines(kind, |family| &family.textbook)
}

/// The name in the page: `open cylinder` for `OpenCylinder`.
fn words(name: &str) -> String {
    match name {
        "Cuboid" => "box".to_owned(),
        name => groundtruth::kinds::tag(name).replace('_', " "),
    }
}

/// The recommendation.
fn pick(data: &Data) -> String {
    let judged: usize = data.kinds.iter().flat_map(|k| &k.families).map(|f| f.judged).sum();
    let judged = count(judged);
    let sum = |of: fn(&KindData) -> Option<Summary>, what: fn(&Summary) -> usize| -> usize {
        data.kinds.iter().filter_map(of).map(|summary| what(&summary)).sum()
    };
    let failed = |of| sum(of, |s| s.lost + s.wrong);
    let worst = data.kinds.iter().filter_map(ours).filter_map(|s| s.worst).reduce(f64::max);
    let sound = failed(ours) == 0 && worst.is_some_and(|worst| worst <= ALLOWED);
    let both: Vec<(&KindData, Summary, Summary)> =
        data.kinds.iter().filter_map(|kind| Some((kind, ours(kind)?, textbook(kind)?))).collect();
    let costs: Vec<f64> =
        both.iter().filter_map(|(_, ours, book)| Some(ours.hit_ns? / book.hit_ns?)).collect();
    let mut text = if sound {
        format!(
            "The library's routine, except for ordinary rays: of {judged} rays it had no lost and no \
             wrong hit, and its worst error is {} u·cond. ",
            short_or_dash(worst)
        )
    } else {
        format!(
            "Neither is safe: of {judged} rays the library's routine had {} lost or wrong hits, and \
             its worst error is {} u·cond; please report this bug. ",
            failed(ours),
            short_or_dash(worst)
        )
    };
    if both.is_empty() {
        return text;
    }
    text += &format!("The textbook's had {} lost or wrong hits. ", count(failed(textbook)));
    let [least, middle, most] = [0.0, 0.5, 1.0].map(|share| short_or_dash(quantile(&costs, share)));
    text += &format!(
        "An ordinary hit takes {middle} times the textbook's time in the median, {least} to {most}. "
    );
    let good: Vec<String> = both
        .iter()
        .filter(|(_, _, book)| book.lost + book.wrong == 0)
        .filter(|(_, _, book)| book.worst.is_some_and(|worst| worst <= ALLOWED))
        .map(|(kind, ..)| words(&kind.kind))
        .collect();
    text + &match &good[..] {
        [] => "On no shape is the textbook's formula as safe.".to_owned(),
        good => format!("The textbook's formula is as safe for: {}.", listed(good)),
    }
}

fn overview(data: &Data) -> Table {
    let columns = ["99.9 %", "worst", "lost", "wrong", "hit, ns", "miss, ns"];
    let cells = |summary: Option<Summary>| match summary {
        Some(s) => vec![
            error(s.p999),
            error(s.worst),
            failures(s.lost),
            failures(s.wrong),
            short_or_dash(s.hit_ns),
            short_or_dash(s.miss_ns),
        ],
        None => vec!["–".to_owned(); columns.len()],
    };
    let row = |(index, kind): (usize, &KindData)| {
        let judged: usize = kind.families.iter().map(|family| family.judged).sum();
        let name = format!("{} {}", index + 1, words(&kind.kind));
        // the times of this table are of the first family
        let disturbed = kind.families.first().is_some_and(|ordinary| ordinary.disturbed);
        let mut row = vec![flagged(name, disturbed), count(judged)];
        row.extend(cells(ours(kind)));
        row.extend(cells(textbook(kind)));
        row
    };
    Table {
        caption: "All families: errors in u·cond of the family where they are largest; times on \
                  ordinary rays"
            .to_owned(),
        groups: groups(2, columns.len()),
        headings: headings(&["shape", "rays judged"], &columns),
        rows: data.kinds.iter().enumerate().map(row).collect(),
    }
}

/// One line for a shape: the worst error, the failures and the time of each routine.
fn summary(kind: &KindData) -> String {
    let one = |name: &str, found: Option<Summary>| match found {
        Some(s) => format!(
            "; {name}: worst error {}, {} lost or wrong, {} ns per hit",
            error(s.worst),
            failures(s.lost + s.wrong),
            short_or_dash(s.hit_ns)
        ),
        None => String::new(),
    };
    let mark = flagged(String::new(), kind.families.iter().any(|family| family.disturbed));
    let name = words(&kind.kind);
    format!(
        "<strong>{name}</strong>{}{}{mark}",
        one("ours", ours(kind)),
        one("textbook", textbook(kind))
    )
}

fn details(kind: &KindData) -> Table {
    let columns = ["median", "99.9 %", "worst", "lost", "wrong", "hit, ns", "miss, ns"];
    let cells = |r: &Routine| {
        vec![
            error(r.median),
            error(r.p999),
            error(r.worst),
            failures(r.lost),
            failures(r.wrong),
            short_or_dash(r.hit_ns),
            short_or_dash(r.miss_ns),
        ]
    };
    let row = |family: &FamilyData| {
        let misses = family.judged - family.hits;
        let name = flagged(words(&family.family), family.disturbed);
        let mut row = vec![name, family.hits.to_string(), misses.to_string()];
        row.extend(cells(&family.ours));
        row.extend(cells(&family.textbook));
        row
    };
    Table {
        caption: words(&kind.kind),
        groups: groups(3, columns.len()),
        headings: headings(&["family", "hits", "misses"], &columns),
        rows: kind.families.iter().map(row).collect(),
    }
}

fn groups(before: usize, columns: usize) -> Vec<(String, usize)> {
    vec![(String::new(), before), ("ours".to_owned(), columns), ("textbook".to_owned(), columns)]
}

fn headings(before: &[&str], columns: &[&str]) -> Vec<String> {
    [before, columns, columns].concat().into_iter().map(str::to_owned).collect()
}

/// An error; bold if it is larger than [`ALLOWED`].
fn error(x: Option<f64>) -> String {
    match x {
        Some(x) if x > ALLOWED => format!("<span class=\"bad\">{}</span>", short(x)),
        x => short_or_dash(x),
    }
}

/// A count of failures; bold unless it is 0.
fn failures(n: usize) -> String {
    if n == 0 { "0".to_owned() } else { format!("<span class=\"bad\">{n}</span>") }
}

fn picture(data: &Data) -> Plot {
    let series = |name: &str, of: fn(&KindData) -> Option<Summary>| {
        let numbered = data.kinds.iter().enumerate();
        let (points, labels) = numbered
            .filter_map(|(index, kind)| {
                let summary = of(kind)?;
                let error = summary.p999?.max(MIN_DRAWN);
                Some(((summary.hit_ns?, error), (index + 1).to_string()))
            })
            .unzip();
        Series { name: name.to_owned(), points, labels, ..Series::default() }
    };
    Plot {
        x: "nanoseconds for an ordinary hit".to_owned(),
        y: "error in u·cond".to_owned(),
        series: vec![series("ours", ours), series("textbook", textbook)],
        limit: Some((ALLOWED, "good below this line".to_owned())),
    }
}
