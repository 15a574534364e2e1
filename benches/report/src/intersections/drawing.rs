//! Page 1 as tables and a plot, from its data alone.

use super::{Data, FamilyData, KindData, Routine};
use crate::plot::{Plot, Series};
use crate::words::*;
use exact::backward_error::ALLOWED;
use statistics::quantile;
use text::digits::rough;
use text::document::*;

/// Smaller errors are drawn at this value: a logarithmic axis has no 0.
const MIN_DRAWN: f64 = 0.01;

pub fn page(data: &Data) -> Element {
    let all: Vec<Summary<'_>> = (1..).zip(&data.kinds).map(Summary::new).collect();
    let explanation = format!(
        include_str!("explanation.txt"),
        kinds = data.kinds.len(),
        cases = data.cases,
        allowed = ALLOWED
    );
    several()
        .with(prose(&explanation))
        .with(pick("What to pick.", advice(&all)))
        .with(overview(&all))
        .with(plot(&all).figure(CAPTION))
        .with(beginning("Each shape and family", "Click on a shape to see its table."))
        .with_all(all.iter().map(details))
}

const CAPTION: &str = "Speed against error. Each number is a shape of the table above. The x axis is \
    the time of a hit on ordinary rays, the y axis the 99.9th percentile of the error in the family \
    where it is largest; lower left is better. Errors of 0.01 or less are drawn at 0.01. Lost and \
    wrong hits are not shown.";

/// A kind with both routines over all families: the largest errors, and the times on ordinary rays.
struct Summary<'a> {
    /// Its number in table and diagram.
    number: usize,
    kind: &'a KindData,
    ours: Routine,
    textbook: Routine,
}

impl<'a> Summary<'a> {
    fn new((number, kind): (usize, &'a KindData)) -> Self {
        let ours = over_all(kind, |family| &family.ours);
        let textbook = over_all(kind, |family| &family.textbook);
        Self { number, kind, ours, textbook }
    }
}

fn over_all(kind: &KindData, of: fn(&FamilyData) -> &Routine) -> Routine {
    let all = || kind.families.iter().map(of);
    let largest = |error: fn(&Routine) -> Option<f64>| all().filter_map(error).reduce(f64::max);
    let ordinary = of(&kind.families[0]);
    Routine {
        median: None,
        p999: largest(|r| r.p999),
        worst: largest(|r| r.worst),
        lost: all().map(|r| r.lost).sum(),
        wrong: all().map(|r| r.wrong).sum(),
        ..*ordinary
    }
}

/// The name in the page: `open cylinder` for `OpenCylinder`.
fn words(name: &str) -> String {
    match name {
        "Cuboid" => "box".to_owned(),
        name => groundtruth::kinds::tag(name).replace('_', " "),
    }
}

fn advice(all: &[Summary<'_>]) -> String {
    let judged = count(all.iter().map(|s| s.kind.judged()).sum());
    let failed: usize = all.iter().map(|s| s.ours.failures()).sum();
    let worst = all.iter().filter_map(|s| s.ours.worst).reduce(f64::max);
    let error = rough_or_dash(worst);
    let ours = match is_safe(failed, worst) {
        true => format!(
            "The library's routine, except for ordinary rays: of {judged} rays it had no lost and no \
             wrong hit, and its worst error is {error} u·cond."
        ),
        false => format!(
            "Neither is safe: of {judged} rays the library's routine had {failed} lost or wrong hits, \
             and its worst error is {error} u·cond; please report this bug."
        ),
    };
    let failed = count(all.iter().map(|s| s.textbook.failures()).sum());
    let costs: Vec<f64> =
        all.iter().filter_map(|s| Some(s.ours.hit_ns? / s.textbook.hit_ns?)).collect();
    let [least, middle, most] = [0.0, 0.5, 1.0].map(|share| rough_or_dash(quantile(&costs, share)));
    let safe = all.iter().filter(|s| is_safe(s.textbook.failures(), s.textbook.worst));
    let safe = safe.map(|s| words(&s.kind.kind));
    let safe = listed_in("The textbook's formula is as safe for: ", safe, ".")
        .unwrap_or_else(|| "On no shape is the textbook's formula as safe.".to_owned());
    format!(
        "{ours} The textbook's had {failed} lost or wrong hits. An ordinary hit takes {middle} times \
         the textbook's time in the median, {least} to {most}. {safe}"
    )
}

fn is_safe(failures: usize, worst: Option<f64>) -> bool {
    failures == 0 && worst.is_some_and(|worst| worst <= ALLOWED)
}

/// The table with the columns of a routine.
fn with_routine<R>(table: Table<R>, of: fn(&R) -> &Routine) -> Table<R> {
    table
        .column("99.9 %", |row| error(of(row).p999))
        .column("worst", |row| error(of(row).worst))
        .column("lost", |row| failures(of(row).lost))
        .column("wrong", |row| failures(of(row).wrong))
        .column("hit, ns", |row| rough_or_dash(of(row).hit_ns))
        .column("miss, ns", |row| rough_or_dash(of(row).miss_ns))
}

fn overview(all: &[Summary<'_>]) -> Element {
    let caption = "All families: errors in u·cond of the family where they are largest; times on \
                   ordinary rays";
    let table = table(all)
        .caption(caption)
        .group("")
        .column("shape", |Summary { number, kind, .. }| {
            // the times of this table are of the first family
            flagged(format!("{number} {}", words(&kind.kind)), kind.families[0].disturbed)
        })
        .column("rays judged", |summary| count(summary.kind.judged()));
    let table = with_routine(table.group("ours"), |summary| &summary.ours);
    with_routine(table.group("textbook"), |summary| &summary.textbook).element()
}

/// One kind: a line with the worst error, the failures and the time of each routine, and its table.
fn details(Summary { kind, ours, textbook, .. }: &Summary<'_>) -> Element {
    let one = |routine: &Routine| {
        several()
            .with("worst error ")
            .with(error(routine.worst))
            .with(", ")
            .with(failures(routine.failures()))
            .with(format!(" lost or wrong, {} ns per hit", rough_or_dash(routine.hit_ns)))
    };
    let mark = flagged(String::new(), kind.families.iter().any(|family| family.disturbed));
    let name = words(&kind.kind);
    let line = several()
        .with(element("strong").with(&name))
        .with("; ours: ")
        .with(one(ours))
        .with("; textbook: ")
        .with(one(textbook))
        .with(mark);
    let table = table(&kind.families)
        .caption(name)
        .group("")
        .column("family", |family| flagged(words(&family.family), family.disturbed))
        .column("hits", |family| family.hits.to_string())
        .column("misses", |family| (family.judged - family.hits).to_string())
        .group("ours")
        .column("median", |family| error(family.ours.median));
    let table = with_routine(table, |family| &family.ours)
        .group("textbook")
        .column("median", |family| error(family.textbook.median));
    let table = with_routine(table, |family| &family.textbook);
    folded(line, table.element())
}

/// An error; bold if it is larger than [`ALLOWED`].
fn error(x: Option<f64>) -> Node {
    match x {
        Some(x) if x > ALLOWED => bad(rough(x)).into(),
        x => rough_or_dash(x).into(),
    }
}

/// A count of failures; bold unless it is 0.
fn failures(n: usize) -> Node {
    if n == 0 { "0".into() } else { bad(n).into() }
}

fn plot(all: &[Summary<'_>]) -> Plot<'static> {
    let series = |name: &str, of: for<'s> fn(&'s Summary<'_>) -> &'s Routine| {
        let point = |summary| {
            let error = of(summary).p999?.max(MIN_DRAWN);
            Some(((of(summary).hit_ns?, error), summary.number.to_string()))
        };
        let (points, labels) = all.iter().filter_map(point).unzip();
        Series { name: name.to_owned(), points, labels, ..Series::default() }
    };
    Plot {
        x: "nanoseconds for an ordinary hit",
        y: "error in u·cond",
        series: vec![
            series("ours", |summary| &summary.ours),
            series("textbook", |summary| &summary.textbook),
        ],
        limit: Some((ALLOWED, "good below this line")),
    }
}
