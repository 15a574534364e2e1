//! Whether a page is well-formed XML: included by the tests of packages that write pages with drawings.

/// The first thing wrong with a text as XML: a tag that is not closed, or closed out of order, an
/// attribute without quotes, a stray `<` or `&`.
pub fn fault(html: &str) -> Option<String> {
    let Some(body) = html.strip_prefix("<!DOCTYPE html>") else {
        return Some("no DOCTYPE".to_owned());
    };
    let mut open: Vec<&str> = Vec::new();
    let mut rest = body;
    while let Some((text, tagged)) = rest.split_once('<') {
        let entity = |after: &str| after.split_once(';').is_some_and(|(name, _)| name.len() < 8);
        if text.split('&').skip(1).any(|after| !entity(after)) {
            return Some(format!("a stray & in {text:?}"));
        }
        let Some((tag, after)) = tagged.split_once('>') else {
            return Some(format!("a stray < in {:?}", &tagged[..tagged.len().min(40)]));
        };
        rest = after;
        let name = tag.split([' ', '\n']).next().unwrap_or_default();
        if let Some(closed) = tag.strip_prefix('/') {
            let last = open.pop();
            if last != Some(closed) {
                return Some(format!("</{closed}> closes {last:?}"));
            }
        } else {
            if !tag.matches('"').count().is_multiple_of(2)
                || tag.matches('=').count() != quoted(tag)
            {
                return Some(format!("attributes of <{tag}>"));
            }
            if !tag.ends_with('/') {
                open.push(name);
            }
        }
    }
    open.pop().map(|name| format!("<{name}> is not closed"))
}

/// The number of attributes with a quoted value, plus the number of `=` inside such values.
fn quoted(tag: &str) -> usize {
    let inside: usize = tag.split('"').skip(1).step_by(2).map(|v| v.matches('=').count()).sum();
    tag.matches('"').count() / 2 + inside
}
