//! A program that answers questions: started, asked, watched, started again.
//!
//! A window of questions is written at once, each with an `id`, and the next window only when all are answered.
//! If a window fails, the process group is killed, the program is started again, and the questions of the window
//! are asked one by one, so that the guilty one is known.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use pictures::running::{kill_group, put_into_group};
use serde_json::Value;

use super::lines::{line, read};
use super::subject::{Fault, Reply, Stop, Subject};

/// How many questions are under way at once.
pub const WINDOW: usize = 64;
/// Faults after which the rest of what is asked together is left out.
pub const MOST_FAULTS: usize = 3;
/// Bytes of a reply.
const LONGEST_REPLY: usize = 1 << 20;
/// How much of the standard error is kept.
const LOG: usize = 1 << 16;
/// How often an interruption is looked for.
const TICK: Duration = Duration::from_millis(50);
/// How long a program may take to end when its input ends.
const FAREWELL: Duration = Duration::from_millis(500);

/// How a program is started, and how long it may take.
#[derive(Clone, Debug)]
pub struct Limits {
    /// For an answer.
    pub answer: Duration,
    /// For the first answer after a start. Spent once only while nothing at all was answered: a program that has used
    /// it up in vain then gets as long as for an answer.
    pub start: Duration,
}

/// A program under questions.
pub struct Program {
    command: Vec<String>,
    limits: Limits,
    interrupted: Arc<AtomicBool>,
    running: Option<Running>,
    next_id: u64,
    /// A question that it has answered: the first after a restart, so that the time of the start is told from that
    /// of an answer.
    answered: Option<Value>,
    /// Whether the time of a start has passed without an answer.
    has_waited: bool,
    log: Arc<Mutex<Vec<u8>>>,
}

/// A process, and the threads that read and write its pipes: one that did both could block on either.
struct Running {
    child: Child,
    lines: Receiver<io::Result<Vec<u8>>>,
    questions: Option<Sender<String>>,
    /// Whether it has answered since it was started.
    has_answered: bool,
}

impl Program {
    /// The program with its arguments; it is started at the first question.
    pub fn new(command: Vec<String>, limits: Limits, interrupted: Arc<AtomicBool>) -> Self {
        let (answered, log) = (None, Arc::default());
        Self {
            command,
            limits,
            interrupted,
            running: None,
            next_id: 1,
            answered,
            has_waited: false,
            log,
        }
    }

    /// The beginning of what it wrote to its standard error.
    pub fn log(&self) -> String {
        let log = self.log.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        String::from_utf8_lossy(&log).into_owned()
    }

    fn start(&mut self) -> Result<(), Fault> {
        let (name, arguments) = self.command.split_first().expect("the command line needs one");
        let mut command = Command::new(name);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        put_into_group(&mut command);
        let mut child =
            command.spawn().map_err(|e| Fault::Died(format!("cannot start {name}: {e}")))?;
        let output = child.stdout.take().expect("it is piped");
        let input = child.stdin.take().expect("it is piped");
        let errors = child.stderr.take().expect("it is piped");
        // bounded: a program that floods waits
        let (line, lines) = sync_channel(2 * WINDOW);
        let (questions, question) = channel();
        thread::spawn(move || read_lines(output, &line));
        thread::spawn(move || write_lines(input, &question));
        let log = Arc::clone(&self.log);
        thread::spawn(move || keep_log(errors, &log));
        self.running =
            Some(Running { child, lines, questions: Some(questions), has_answered: false });
        Ok(())
    }

    /// Ends the process and all of its children.
    fn stop(&mut self) {
        let Some(mut running) = self.running.take() else { return };
        kill_group(&mut running.child);
        let _ = running.child.wait();
    }

    /// The replies to questions that are under way together, or what went wrong with the replies until then. Starts
    /// the program if it does not run.
    fn window(&mut self, questions: &[Value]) -> Result<Vec<Reply>, Failed> {
        let none = || vec![None; questions.len()];
        if self.running.is_none() {
            self.start().map_err(|fault| (fault, none()))?;
            if let Some(easy) = self.answered.clone() {
                self.exchange(&[easy]).map_err(|(fault, _)| (fault, none()))?;
            }
        }
        let replies = self.exchange(questions)?;
        if self.answered.is_none() {
            self.answered = questions.first().cloned();
        }
        Ok(replies)
    }

    /// Writes questions and reads their replies.
    fn exchange(&mut self, questions: &[Value]) -> Result<Vec<Reply>, Failed> {
        let mut replies: Vec<Option<Reply>> = vec![None; questions.len()];
        let running = self.running.as_mut().expect("it runs");
        let first = self.next_id;
        self.next_id += questions.len() as u64;
        let numbered = questions.iter().zip(first..);
        let text: String = numbered.map(|(question, id)| line(question, id)).collect();
        // if it has ended, its output tells
        let _ = running.questions.as_ref().expect("open while it runs").send(text);
        let mut open = questions.len();
        while open > 0 {
            let is_in_vain = self.has_waited && self.answered.is_none();
            let limit = match running.has_answered || is_in_vain {
                true => self.limits.answer,
                false => self.limits.start,
            };
            let got = match running.next_line(limit, &self.interrupted) {
                Ok(Some(line)) => read(&line),
                Ok(None) => return Ok(replies.into_iter().map(or_not_asked).collect()),
                Err(fault) => {
                    self.has_waited |= matches!(fault, Fault::Hung(_)) && !running.has_answered;
                    return Err((fault, replies));
                }
            };
            let (id, reply) = got.map_err(|fault| (fault, replies.clone()))?;
            let slot = id.checked_sub(first).and_then(|at| replies.get_mut(at as usize));
            match slot {
                Some(slot @ None) => *slot = Some(reply),
                slot => {
                    let what = match (1..self.next_id).contains(&id) {
                        true => "was answered twice",
                        false => "was never asked",
                    };
                    let fault = Fault::Garbled(format!("the question with id {id} {what}"));
                    if let Some(guilty) = slot {
                        *guilty = Some(Err(Stop::Fault(fault.clone())));
                    }
                    return Err((fault, replies));
                }
            }
            running.has_answered = true;
            open -= 1;
        }
        Ok(replies.into_iter().map(or_not_asked).collect())
    }
}

/// A fault, and the replies before it.
type Failed = (Fault, Vec<Option<Reply>>);

fn or_not_asked(reply: Option<Reply>) -> Reply {
    reply.unwrap_or(Err(Stop::NotAsked))
}

fn faults(replies: &[Reply]) -> usize {
    replies.iter().filter(|reply| matches!(reply, Err(Stop::Fault(_)))).count()
}

impl Subject for Program {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let mut all = Vec::with_capacity(questions.len());
        for window in questions.chunks(WINDOW) {
            if faults(&all) >= MOST_FAULTS {
                all.extend(window.iter().map(|_| Err(Stop::NotAsked)));
                continue;
            }
            match self.window(window) {
                Ok(replies) => all.extend(replies),
                Err((fault, replies)) => {
                    self.stop();
                    all.extend(self.one_by_one(window, fault, replies));
                }
            }
        }
        all
    }
}

impl Program {
    /// Asks again what a failed window left open, until three are guilty. If every question is answered alone, nobody is guilty, and the
    /// fault goes to the first that was open.
    fn one_by_one(
        &mut self,
        window: &[Value],
        fault: Fault,
        replies: Vec<Option<Reply>>,
    ) -> Vec<Reply> {
        let is_known = replies.iter().any(|reply| matches!(reply, Some(Err(Stop::Fault(_)))));
        let mut fault = if is_known { None } else { Some(fault) };
        let first_open = replies.iter().position(Option::is_none).unwrap_or(0);
        let alone = window.len() == 1;
        let mut again: Vec<Reply> = Vec::with_capacity(window.len());
        for (question, reply) in window.iter().zip(replies) {
            let reply = match reply {
                Some(reply) => reply,
                None if faults(&again) >= MOST_FAULTS => Err(Stop::NotAsked),
                None if alone => {
                    fault.take().map_or(Err(Stop::NotAsked), |fault| Err(Stop::Fault(fault)))
                }
                None => match self.window(std::slice::from_ref(question)) {
                    Ok(mut replies) => replies.remove(0),
                    Err((guilty, _)) => {
                        self.stop();
                        fault = None;
                        Err(Stop::Fault(guilty))
                    }
                },
            };
            again.push(reply);
        }
        if let Some(fault) = fault
            && !again.contains(&Err(Stop::NotAsked))
        {
            again[first_open] = Err(Stop::Fault(fault));
        }
        again
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        if let Some(running) = &mut self.running {
            // the end of its input is how a program learns that it can end
            running.questions = None;
            let begun = Instant::now();
            while begun.elapsed() < FAREWELL && matches!(running.child.try_wait(), Ok(None)) {
                thread::sleep(Duration::from_millis(5));
            }
        }
        self.stop();
    }
}

impl Running {
    /// The next line of output; `None` if the run is interrupted.
    fn next_line(
        &mut self,
        limit: Duration,
        interrupted: &AtomicBool,
    ) -> Result<Option<Vec<u8>>, Fault> {
        let begun = Instant::now();
        loop {
            if interrupted.load(Ordering::Relaxed) {
                return Ok(None);
            }
            match self.lines.recv_timeout(TICK) {
                Ok(Ok(line)) => return Ok(Some(line)),
                Ok(Err(error)) => return Err(Fault::Garbled(error.to_string())),
                Err(RecvTimeoutError::Disconnected) => return Err(self.ended()),
                Err(RecvTimeoutError::Timeout) if begun.elapsed() > limit => {
                    let seconds = limit.as_secs_f64();
                    return Err(Fault::Hung(format!("no answer within {seconds} s")));
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    fn ended(&mut self) -> Fault {
        // the exit status may come a little later than the end of the output
        let begun = Instant::now();
        while begun.elapsed() < FAREWELL {
            if let Ok(Some(status)) = self.child.try_wait() {
                return Fault::Died(format!("the program ended with {status}"));
            }
            thread::sleep(Duration::from_millis(5));
        }
        Fault::Died("the program closed its output".to_owned())
    }
}

/// Sends each line until the output ends; blank lines are skipped.
fn read_lines(output: impl Read, lines: &SyncSender<io::Result<Vec<u8>>>) {
    let mut output = BufReader::new(output);
    loop {
        let mut line = Vec::new();
        // its end is a byte, too
        let most = LONGEST_REPLY as u64 + 1;
        match output.by_ref().take(most).read_until(b'\n', &mut line) {
            Ok(0) | Err(_) => return,
            Ok(_) => {}
        }
        let is_whole = line.last() == Some(&b'\n');
        let result = if is_whole {
            line.pop();
            if line.iter().all(u8::is_ascii_whitespace) {
                continue;
            }
            Ok(line)
        } else if line.len() as u64 == most {
            Err(io::Error::other(format!("a line longer than {LONGEST_REPLY} bytes")))
        } else {
            // the output ended inside a line
            Ok(line)
        };
        if lines.send(result).is_err() {
            return;
        }
    }
}

/// Writes until there are no more questions, or the program reads no more.
fn write_lines(mut input: ChildStdin, questions: &Receiver<String>) {
    while let Ok(text) = questions.recv() {
        if input.write_all(text.as_bytes()).and_then(|()| input.flush()).is_err() {
            return;
        }
    }
}

/// Keeps the beginning, and reads the rest so that the program never waits.
fn keep_log(mut errors: impl Read, log: &Mutex<Vec<u8>>) {
    let mut buffer = [0; 1 << 14];
    while let Ok(n @ 1..) = errors.read(&mut buffer) {
        let mut log = log.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let room = LOG.saturating_sub(log.len());
        log.extend_from_slice(&buffer[..n.min(room)]);
    }
}
