//! The report as files: `index.html`, which is self-contained, and `report.json`.

use std::io;
use std::path::{Path, PathBuf};

use super::{Findings, Page, Provenance, Report};
use groundtruth::film::{TEMPORARY, folder_of, replace_all};
use text::document::*;
use text::html::page;

const STYLE: &str = include_str!("style.css");

impl Report {
    /// The HTML page; it is self-contained.
    pub fn html(&self) -> String {
        let pages = || self.chapters.iter();
        let link = |(page, _): &(Page, Findings)| {
            let link = element("a").attribute("href", format!("#{}", page.name)).with(page.title);
            several().with(link).with(format!(": {}", page.question))
        };
        let section = |(page, findings): &(Page, Findings)| {
            element("section")
                .attribute("id", page.name)
                .with(heading(2, page.title))
                .with(paragraph(page.question).class("question"))
                .with(findings.section.clone())
        };
        let body = several()
            .with(heading(1, "Choose by evidence"))
            .with(group("about").with(measured(&self.provenance, self.seed)))
            .with(list(pages().map(link)))
            .with_all(pages().map(section));
        page("Groundtruth: report", &[STYLE], &body.html())
    }
}

fn measured(made: &Provenance, seed: u64) -> Element {
    let warning = match made.debug {
        true => " It was built with debug assertions, so times are too long.",
        false => "",
    };
    prose(&format!(
        include_str!("measured.txt"),
        version = made.version,
        commit = made.commit,
        processor = made.processor,
        platform = made.platform,
        threads = made.threads,
        seed = seed,
        warning = warning
    ))
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
