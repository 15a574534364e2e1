//! Lines in, lines out.

use std::io::{self, BufRead, Read, Write};

use super::{LONGEST_LINE, Refusal, json, reply, too_long};

/// Answers each line of `input` with one line of `output`, written at once; blank lines are
/// skipped. Returns whether every line got an answer and none an error.
///
/// # Errors
/// As reading and writing.
pub fn serve(mut input: impl BufRead, mut output: impl Write) -> io::Result<bool> {
    let mut all_answered = true;
    let mut number = 0;
    while let Some(line) = next_line(&mut input)? {
        number += 1;
        if line.iter().all(u8::is_ascii_whitespace) {
            continue;
        }
        let refuse = |error: String| json(&Refusal { id: None, error: &error });
        let reply = match std::str::from_utf8(&line) {
            _ if line.len() > LONGEST_LINE => Err(refuse(too_long())),
            Ok(text) => reply(text),
            Err(e) => {
                let at = e.valid_up_to();
                Err(refuse(format!(
                    "line {number}, byte {}: 0x{:02x} is not UTF-8; JSON is UTF-8 text",
                    at + 1,
                    line[at]
                )))
            }
        };
        all_answered &= reply.is_ok();
        let mut text = reply.unwrap_or_else(|refusal| refusal);
        text.push('\n');
        output.write_all(text.as_bytes())?;
        output.flush()?;
    }
    Ok(all_answered)
}

/// The next line without its end; of one that is too long, a little more than fits: the rest is
/// read and forgotten.
fn next_line(input: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut line = Vec::new();
    let most = LONGEST_LINE as u64 + 2;
    if input.by_ref().take(most).read_until(b'\n', &mut line)? == 0 {
        return Ok(None);
    }
    if line.last() == Some(&b'\n') {
        line.pop();
    } else if line.len() as u64 == most {
        input.skip_until(b'\n')?;
    }
    Ok(Some(line))
}
