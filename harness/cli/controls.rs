//! `groundtruth goldens check --controls`.

use std::fmt::Write;
use std::sync::atomic::Ordering;

use golden::controls::{Controls, Program, REASONS, reason, vocabulary};
use golden::{Golden, Goldens};

use super::{Exit, Outcome, interrupt, print, progress};

/// So many goldens that say a field are named.
const NAMED: usize = 3;

/// Lists what these goldens do not see; of all goldens, also what they do not say.
pub fn run(goldens: &Goldens, names: &[String], is_whole: bool) -> Outcome {
    let known: Vec<Golden> = names.iter().filter_map(|name| goldens.find(name).cloned()).collect();
    let interrupted = interrupt::flag()?;
    let bar =
        progress::bar(known.len() as u64, "{bar:40} {pos} of {len} goldens  {elapsed} elapsed");
    let (done, is_interrupted) = (|| bar.inc(1), || interrupted.load(Ordering::Relaxed));
    let found = Program::OURS.controls(&known, goldens.folder(), (&done, &is_interrupted))?;
    bar.finish_and_clear();
    if is_interrupted() {
        return progress::nothing_written();
    }
    print(&text(&found, known.len(), is_whole))?;
    Ok(Exit::Yes)
}

/// What is printed.
fn text(found: &Controls, goldens: usize, is_whole: bool) -> String {
    let Controls { seen, unseen, pictures } = found;
    let all = seen.len() + unseen.len();
    let mut text = format!(
        "{goldens} goldens say {all} fields and kinds other than by default; they see {} of them ({pictures} pictures)\n",
        seen.len()
    );
    let mut unexplained = 0;
    for (field, names) in unseen {
        let _ = match reason(field) {
            Some(reason) => writeln!(text, "unseen  {field}: {reason}"),
            None => {
                unexplained += 1;
                let more = names.len().saturating_sub(NAMED);
                let more = if more == 0 { String::new() } else { format!(" and {more} more") };
                let names = names[..names.len().min(NAMED)].join(", ");
                writeln!(text, "unseen  {field}: no reason is known; said by {names}{more}")
            }
        };
    }
    if !is_whole {
        // so that parts can be put together: what one of them sees is seen
        seen.iter().for_each(|field| text += &format!("seen    {field}\n"));
        return text;
    }
    let is_said = |field: &str| seen.contains(field) || unseen.contains_key(field);
    for field in vocabulary().iter().filter(|field| !is_said(field)) {
        let _ = match reason(field) {
            Some(reason) => writeln!(text, "unsaid  {field}: {reason}"),
            None => {
                unexplained += 1;
                writeln!(text, "unsaid  {field}: no reason is known")
            }
        };
    }
    for (field, _) in REASONS.iter().filter(|(field, _)| seen.contains(*field)) {
        let _ = writeln!(text, "seen    {field}: has a reason why it is not seen, which is wrong");
    }
    text += &format!("{unexplained} without a reason\n");
    text
}
