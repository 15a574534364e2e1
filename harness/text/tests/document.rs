//! Documents in their three prints.

use text::document::*;

use testkit::markup::fault;

/// A document with every block that packages build, and words that each print has to escape or leave.
fn document() -> Element {
    let rows = [("sphere", 12.5, true), ("a < b", 3.0, false)];
    let table = table(rows)
        .caption("Times")
        .group("")
        .column("shape", |(name, ..)| (*name).to_owned())
        .group("ours")
        .column("ns", |(_, time, _)| time.to_string())
        .column("good", |(.., good)| if *good { code("yes") } else { code("no") })
        .classes(|(.., good)| if *good { "" } else { "failed" });
    several()
        .with(heading(2, "1 < 2"))
        .with(prose("Use `a && b` for *this*.\n\nThen that."))
        .with(list(["one", "two"]))
        .with(table.element())
        .with(folded("more", lines("a\n  b\n")))
        .with(figure(Node::Drawing("<svg/>".to_owned()), "a drawing"))
        .with(element("a").attribute("href", "#\"x\"").with("there"))
}

/// Law: markup is what the elements say: names, attributes and words escaped, drawings as they are. Oracle: by hand.
#[test]
fn a_page_has_all_blocks_escaped() {
    let expected = "<h2>1 &lt; 2</h2>\n<p>Use <code>a &amp;&amp; b</code> for <em>this</em>.</p>\n<p>Then that.</p>\n\
        <ul><li>one</li>\n<li>two</li>\n</ul>\n<div class=\"wide\"><table><caption>Times</caption>\n<thead>\
        <tr><th class=\"group\" colspan=\"1\"></th><th class=\"group\" colspan=\"2\">ours</th></tr>\n\
        <tr><th>shape</th><th class=\"start\">ns</th><th>good</th></tr>\n</thead>\n<tbody>\
        <tr><th>sphere</th><td class=\"start\">12.5</td><td><code>yes</code></td></tr>\n\
        <tr class=\"failed\"><th>a &lt; b</th><td class=\"start\">3</td><td><code>no</code></td></tr>\n</tbody>\n\
        </table>\n</div>\n<details><summary>more</summary>\n<pre>a\n  b\n</pre>\n</details>\n\
        <figure><svg/><figcaption>a drawing</figcaption>\n</figure>\n<a href=\"#&quot;x&quot;\">there</a>";
    assert_eq!(document().html(), expected);
    assert_eq!(fault(&format!("<!DOCTYPE html>{expected}")), None);
}

/// Law: a terminal has a line for each block, and columns of numbers end below one another. Oracle: by hand.
#[test]
fn a_terminal_has_lines_and_columns() {
    let expected = "1 < 2\nUse a && b for this.\nThen that.\n  one\n  two\nTimes\n\
        shape     ns  good\nsphere  12.5  yes\na < b      3  no\nmore\na\n  b\na drawing\nthere";
    assert_eq!(document().plain(), expected);
}

/// Law: Markdown has the marks of each block, and no drawing. Oracle: by hand.
#[test]
fn markdown_has_its_marks() {
    let page = several()
        .with(heading(1, "Title"))
        .with(prose("Use `a && b` for *this*."))
        .with(list(["one", "two"]))
        .with(
            table([(1, 2)])
                .column("a", |row| row.0.to_string())
                .column("b", |row| code(row.1.to_string()))
                .element(),
        );
    let expected = "# Title\n\nUse `a && b` for *this*.\n\n- one\n- two\n\n| a | b |\n| --- | --- |\n| 1 | `2` |\n\n";
    assert_eq!(page.markdown(), expected);
}
