//! The report as files: `index.html`, which is self-contained, and `report.json`.

use std::io;
use std::path::{Path, PathBuf};

use super::{Findings, Page, Provenance, Report};
use groundtruth::film::{TEMPORARY, folder_of, replace_all};
use pictures::html::{escaped, page};

const STYLE: &str = include_str!("style.css");

/// The whole page.
pub(super) fn html(report: &Report) -> String {
    let mut html = "<h1>Choose by evidence</h1>\n".to_owned();
    html += &measured(&report.provenance, report.settings.seed);
    html.push_str("<ul>\n");
    for (Page { name, title, question, .. }, _) in &report.chapters {
        let question = escaped(question);
        html += &format!("<li><a href=\"#{name}\">{title}</a>: {question}</li>\n");
    }
    html.push_str("</ul>\n");
    for (Page { name, title, question, .. }, Findings { section, .. }) in &report.chapters {
        let question = escaped(question);
        html += &format!(
            "<section id=\"{name}\">\n<h2>{title}</h2>\n<p class=\"question\">{question}</p>\n\
             {section}</section>\n"
        );
    }
    page("Groundtruth: report", &[STYLE], &html)
}

fn measured(provenance: &Provenance, seed: u64) -> String {
    let Provenance { version, commit, debug, processor, platform, threads } = provenance;
    let warning = match debug {
        true => " It was built with debug assertions, so times are too long.",
        false => "",
    };
    format!(
        include_str!("measured.html"),
        version = version,
        commit = escaped(commit),
        processor = escaped(processor),
        platform = platform,
        threads = threads,
        seed = seed,
        warning = warning
    )
}

/// Writes both files into the folder, which is created if it does not exist. An error leaves no
/// partial file.
///
/// # Errors
/// If a file or folder cannot be written.
pub fn write(report: &Report, folder: &Path) -> io::Result<[PathBuf; 2]> {
    let (html, json) = (report.html(), report.json());
    std::fs::create_dir_all(folder).map_err(|e| unwritable(folder, &e))?;
    let files = ["index.html", "report.json"].map(|name| folder.join(name));
    let [page, data] = &files;
    // the data first, so that nobody sees a new page beside old data
    let texts: [(&Path, &[u8]); 2] = [(data, json.as_bytes()), (page, html.as_bytes())];
    replace_all(&texts).map_err(|(index, e)| unwritable(texts[index].0, &e))?;
    Ok(files)
}

/// Checks, before the measurement, that the report can be written to the folder; leaves no file.
///
/// # Errors
/// If a file or folder cannot be written.
pub fn check_folder(folder: &Path) -> io::Result<()> {
    // the nearest existing ancestor: missing folders below it will be created
    let mut known = folder;
    while !known.exists() {
        known = folder_of(known);
    }
    if !known.is_dir() {
        let problem = io::Error::other(format!("{} is a file", known.display()));
        return Err(unwritable(folder, &problem));
    }
    for name in ["index.html", "report.json"] {
        if folder.join(name).is_dir() {
            return Err(unwritable(&folder.join(name), &io::Error::other("it is a folder")));
        }
    }
    let probe = tempfile::Builder::new().prefix(TEMPORARY).tempfile_in(known);
    probe.map(drop).map_err(|e| unwritable(folder, &io::Error::from(e.kind())))
}

fn unwritable(path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{}: cannot be written: {error}", path.display()))
}
