//! `groundtruth verify`: its document.

use crate::kit::{Folder, root, text_of};
use testkit::same_text::{Printed, hold};

/// Law: docs/verify.md shows what its commands print. Oracle: the program.
#[test]
fn the_document_shows_what_is_printed() {
    let folder = Folder::new();
    let document = text_of("docs/verify.md");
    let (mut true_text, mut count) = (document.clone(), 0);
    for block in document.split("```console\n$ ").skip(1) {
        let (block, _) = block.split_once("```").expect("it ends");
        let (command, shown) = block.split_once('\n').expect("a command");
        let printed = folder.run(command).stdout;
        let [old, new] = [shown, &printed].map(|text| format!("$ {command}\n{text}```"));
        true_text = true_text.replacen(&old, &new, 1);
        count += 1;
    }
    assert_eq!(count, 4, "two pictures, each rendered and judged");
    hold(&root().join("docs/verify.md"), &true_text, Printed::Rounded);
}
