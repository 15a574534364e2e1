//! Markup of tables, figures and sentences, without a report: each part has what it was given, in its order.

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use report::html::*;

/// The cells of each row of a table, with their tags, without those of headings of groups.
fn rows(html: &str) -> Vec<Vec<(String, String)>> {
    let of_row = |row: &str| {
        let cells = row.split("<t").skip(1).map(|cell| {
            let (tag, rest) = cell.split_once('>').expect("a tag ends");
            let (text, _) = rest.split_once("</t").expect("a cell ends");
            (format!("t{tag}"), text.to_owned())
        });
        cells.collect()
    };
    html.lines().filter_map(|line| line.strip_prefix("<tr>")).map(of_row).collect()
}

/// Law: a table has its caption, a heading for each column, and a row for each value with a cell for each column, the first of which
/// is a heading; groups span their columns, and the first column of each later group begins it. Oracle: the columns.
#[test]
fn a_table_has_a_cell_for_each_column_and_value() {
    for groups in [vec![], vec![3], vec![1, 2], vec![2, 1, 3], vec![1, 1, 1]] {
        let columns: usize = if groups.is_empty() { 2 } else { groups.iter().sum() };
        let mut table: Table<'_, usize> = Table::new("the <em>caption</em>");
        let mut starts = Vec::new();
        let mut index = 0;
        let sizes = if groups.is_empty() { vec![columns] } else { groups.clone() };
        for (group, size) in sizes.into_iter().enumerate() {
            if !groups.is_empty() {
                table = table.group(format!("group {group}"));
            }
            starts.extend((group > 0).then_some(index));
            for _ in 0..size {
                let column = index;
                table =
                    table.column(format!("column {column}"), move |row| format!("{row}/{column}"));
                index += 1;
            }
        }
        for values in [vec![], vec![7], vec![4, 5, 6]] {
            let html = table.html(&values);
            assert!(
                html.contains("<caption>the <em>caption</em></caption>"),
                "the caption: {html}"
            );
            let mut all = rows(&html);
            if !groups.is_empty() {
                let found = all.remove(0);
                let expected: Vec<(String, String)> = groups
                    .iter()
                    .enumerate()
                    .map(|(k, size)| {
                        (format!("th class=\"group\" colspan=\"{size}\""), format!("group {k}"))
                    })
                    .collect();
                assert_eq!(found, expected, "headings of groups");
            }
            let class =
                |column: usize| if starts.contains(&column) { " class=\"start\"" } else { "" };
            let row = |first: &str,
                       other: &str,
                       text: &dyn Fn(usize) -> String|
             -> Vec<(String, String)> {
                let tag =
                    |column: usize| if column == 0 { first.to_owned() } else { other.to_owned() };
                (0..columns).map(|column| (tag(column) + class(column), text(column))).collect()
            };
            let mut expected = vec![row("th", "th", &|column| format!("column {column}"))];
            expected.extend(
                values.iter().map(|value| row("th", "td", &|column| format!("{value}/{column}"))),
            );
            assert_eq!(all, expected, "rows of groups {groups:?}");
            let (head, body) = html.split_once("</thead>").expect("a head");
            assert_eq!(body.matches("<tr>").count(), values.len(), "rows of the body");
            assert_eq!(
                head.matches("<tr>").count(),
                1 + usize::from(!groups.is_empty()),
                "rows of the head"
            );
        }
    }
}

/// Law: sentences and figures hold what they were given, texts of people escaped; words are listed with commas and one `and`; what is
/// as good is said in brackets, if there is any; a disturbed time has a mark. Oracle: written by hand.
#[test]
fn parts_hold_what_they_were_given() {
    assert_eq!(heading("grid of <x>", "a < b"), "<h3>Grid of <x></h3>\n<p>a &lt; b</p>\n");
    assert_eq!(pick("Pick.", "it"), "<p class=\"pick\"><strong>Pick.</strong> it</p>\n");
    assert_eq!(
        folded("more", "<p>x</p>"),
        "<details>\n<summary>more</summary>\n<p>x</p></details>\n"
    );
    let one = figure("<svg/>", "words");
    assert_eq!(one, "<figure>\n<svg/>\n<figcaption>words</figcaption>\n</figure>\n");
    assert_eq!(
        row("crops", &[one.clone(), one.clone()]),
        format!("<div class=\"crops\">\n{one}{one}</div>\n")
    );
    assert_eq!(row("crops", &[]), "<div class=\"crops\">\n</div>\n");
    let words: Vec<String> = ["a", "b", "c", "d"].map(str::to_owned).to_vec();
    let expected = ["none", "a", "a and b", "a, b and c", "a, b, c and d"];
    for (count, expected) in expected.into_iter().enumerate() {
        assert_eq!(listed(&words[..count]), expected, "{count} words");
        let as_good =
            if count > 0 { format!(" (or {expected}, about as good)") } else { String::new() };
        assert_eq!(or_as_good(&words[..count]), as_good, "{count} words as good");
    }
    assert_eq!(flagged("3 s".to_owned(), false), "3 s");
    let marked = flagged("3 s".to_owned(), true);
    assert!(marked.starts_with("3 s ") && marked.contains('‡'), "a mark: {marked}");
    for (word, expected) in
        [("", ""), ("a", "A"), ("ärger im Wald", "Ärger im Wald"), ("X y", "X y")]
    {
        assert_eq!(capital(word), expected, "`{word}` with a capital");
    }
    assert_eq!(short_or_dash(None), DASH, "no number");
    assert_eq!(short_or_dash(Some(0.25)), short(0.25), "a number");
    assert_eq!(with_minus("-1-2"), "−1−2", "minus signs");
    assert_eq!(superscript("-1234567890"), "⁻¹²³⁴⁵⁶⁷⁸⁹⁰", "superscript");
}

/// Law: counts of five digits and more have a narrow space before each three, shorter ones none. Oracle: the digits without spaces, and
/// the places of spaces from the right.
#[test]
fn counts_are_divided_in_threes() {
    for n in [0, 7, 999, 1000, 9999, 10_000, 31_623, 999_999, 1_000_000, 1_234_567_890] {
        let text = count(n);
        let digits: String = text.chars().filter(char::is_ascii_digit).collect();
        assert_eq!(digits, n.to_string(), "the digits of {n}");
        let backwards: Vec<char> = text.chars().rev().collect();
        let spaces = backwards.iter().filter(|c| !c.is_ascii_digit()).count();
        let expected = if digits.len() > 4 { (digits.len() - 1) / 3 } else { 0 };
        assert_eq!(spaces, expected, "spaces of {text}");
        let is_in_place = (0..spaces).all(|k| backwards[4 * k + 3] == '\u{202f}');
        assert!(is_in_place, "spaces of {text} stand before threes");
    }
}

/// Law: a picture is a figure with its words escaped and the film as it is displayed: twice the exposure is another picture, and that of
/// half the light the same. Oracle: two films.
#[test]
fn a_film_is_shown_with_its_exposure() {
    let of = |value: f64| {
        let mut it = Film::new(2, 1);
        it.set([0, 0], Rgb::grey(value));
        it
    };
    let shown = |value: f64, exposure: f64| film(&of(value), exposure, "<it>", "below");
    let one = shown(0.25, 1.0);
    assert!(
        one.contains("alt=\"&lt;it&gt;\"") && one.contains("<figcaption>below</figcaption>"),
        "{one}"
    );
    assert!(
        one.starts_with("<figure>\n<img ") && one.contains("src=\"data:image/png;base64,"),
        "{one}"
    );
    assert_eq!(shown(0.125, 2.0), one, "half the light at twice the exposure");
    assert_ne!(shown(0.25, 2.0), one, "twice the exposure");
}
