//! A page in a browser: one thread, on which work goes on in slices between frames; files in memory, which the user
//! dropped or chose; saved ones are downloaded.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, VecDeque};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError};
use std::time::Duration;

use eframe::egui::Context;
use groundtruth::scene::Scene;
use js_sys::Promise;
use pictures::compare::{Picture, Transfer};
use rays::{Log, LogError};
use rfd::AsyncFileDialog;
use scenefile::SceneError;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

use super::{FORMATS, LOGS, Purpose, Slice};

/// What is said when no file is chosen.
pub const NO_FILE: &str = "no file chosen; files can be dropped on the page, too";

/// The longest time for which the page does nothing but work.
const LONGEST_SLICE: Duration = Duration::from_millis(15);

type Work = Box<dyn FnMut(&Slice) -> bool>;

thread_local! {
    /// The work under way, the newest last, and where it says that it has ended.
    static WORK: RefCell<Vec<(Work, Arc<AtomicBool>)>> = const { RefCell::new(Vec::new()) };
    /// Whether slices of it follow each other.
    static IS_WORKING: Cell<bool> = const { Cell::new(false) };
    /// The files that the user dropped or chose, by their names.
    static FILES: RefCell<BTreeMap<PathBuf, Vec<u8>>> = const { RefCell::new(BTreeMap::new()) };
    /// Those that were dropped and are read.
    static DROPPED: RefCell<VecDeque<PathBuf>> = const { RefCell::new(VecDeque::new()) };
}

/// Work beside the window.
#[derive(Debug)]
pub struct Task(Arc<AtomicBool>);

impl Task {
    /// Starts it: `work` is called until it is whole, which it says by `true`.
    pub fn start(ctx: &Context, mut work: impl FnMut(&Slice) -> bool + Send + 'static) -> Self {
        let (is_ended, ctx) = (Arc::new(AtomicBool::new(false)), ctx.clone());
        let work = move |slice: &Slice| {
            let is_whole = work(slice);
            if is_whole {
                ctx.request_repaint();
            }
            is_whole
        };
        WORK.with_borrow_mut(|all| all.push((Box::new(work), Arc::clone(&is_ended))));
        if !IS_WORKING.replace(true) {
            spawn_local(work_in_slices());
        }
        Self(is_ended)
    }

    /// Whether it has ended.
    pub fn is_ended(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Works for this time, on what was asked for last first.
fn work_for(time: Duration) {
    let slice = Slice::of(time);
    while let Some((mut work, is_ended)) = WORK.with_borrow_mut(Vec::pop) {
        if work(&slice) {
            is_ended.store(true, Ordering::Relaxed);
        } else {
            WORK.with_borrow_mut(|all| all.push((work, is_ended)));
        }
        if slice.is_over() {
            return;
        }
    }
}

/// Works until there is nothing left, and lets the browser draw and listen between two slices.
async fn work_in_slices() {
    while WORK.with_borrow(|all| !all.is_empty()) {
        work_for(LONGEST_SLICE);
        let pause = Promise::new(&mut |go_on, _| {
            // without a window nobody waits
            let timer = web_sys::window().map(|it| it.set_timeout_with_callback(&go_on));
            debug_assert!(timer.is_some_and(|timer| timer.is_ok()), "a page has timers");
        });
        let _ = JsFuture::from(pause).await;
    }
    IS_WORKING.set(false);
}

/// Work that cannot be looked at while it is done: `look` before it.
pub fn watched<T>(work: impl FnOnce() -> T, mut look: impl FnMut()) -> T {
    look();
    work()
}

/// What work sends within this time.
///
/// # Errors
/// As [`Receiver::recv_timeout`].
pub fn wait<T>(receiver: &Receiver<T>, timeout: Duration) -> Result<T, RecvTimeoutError> {
    if !timeout.is_zero() {
        work_for(timeout);
    }
    receiver.try_recv().map_err(|error| match error {
        TryRecvError::Empty => RecvTimeoutError::Timeout,
        TryRecvError::Disconnected => RecvTimeoutError::Disconnected,
    })
}

fn file(path: &Path) -> io::Result<Vec<u8>> {
    let missing = || io::Error::other("the page has no such file; drop it on the page");
    FILES.with_borrow(|files| files.get(path).cloned()).ok_or_else(missing)
}

/// Reads a scene file.
///
/// # Errors
/// As [`scenefile::open`].
pub fn open_scene(path: &Path) -> Result<(Scene, scenefile::Source), SceneError> {
    let unreadable = |source| SceneError::Unreadable { path: path.to_owned(), source };
    scenefile::from_bytes(file(path).map_err(unreadable)?, path)
}

/// Reads a picture.
///
/// # Errors
/// As [`Picture::read`].
pub fn read_picture(path: &Path, said: Option<Transfer>) -> Result<Picture, String> {
    let bytes = file(path).map_err(|error| format!("{}: {error}", path.display()))?;
    Picture::from_bytes(&bytes, path, said).map_err(|error| error.to_string())
}

/// Work at once.
pub fn at_once<T>(work: impl FnOnce() -> T) -> T {
    work()
}

/// Reads a log of rays.
///
/// # Errors
/// As [`rays::read`].
pub fn read_log(path: &Path) -> Result<Log, LogError> {
    rays::read(&*file(path)?)
}

/// Downloads a file.
///
/// # Errors
/// What the browser says.
pub fn save(path: &Path, bytes: &[u8]) -> io::Result<PathBuf> {
    download(path, bytes).map_err(|error| io::Error::other(format!("{error:?}")))?;
    Ok(path.to_owned())
}

fn download(path: &Path, bytes: &[u8]) -> Result<(), JsValue> {
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(bytes));
    let blob = web_sys::Blob::new_with_u8_array_sequence(&parts)?;
    let address = web_sys::Url::create_object_url_with_blob(&blob)?;
    let document = web_sys::window().and_then(|window| window.document());
    let link = document.ok_or("no document")?.create_element("a")?;
    let link: web_sys::HtmlAnchorElement = link.dyn_into()?;
    link.set_href(&address);
    link.set_download(&path.file_name().unwrap_or_default().to_string_lossy());
    link.click();
    web_sys::Url::revoke_object_url(&address)
}

/// Whether a file would be replaced; the browser gives another name to a second download.
pub fn exists(_: &Path) -> bool {
    false
}

/// The files that were dropped on the page, once they are read.
pub fn dropped(ctx: &Context) -> Vec<PathBuf> {
    for file in ctx.input(|input| input.raw.dropped_files.clone()) {
        let ctx = ctx.clone();
        spawn_local(async move {
            // one that cannot be read is missing when it is opened
            if let Ok(bytes) = file.bytes_async().await {
                FILES.with_borrow_mut(|files| files.insert(file.path().to_owned(), bytes));
            }
            DROPPED.with_borrow_mut(|dropped| dropped.push_back(file.path().to_owned()));
            ctx.request_repaint();
        });
    }
    DROPPED.with_borrow_mut(|dropped| dropped.drain(..).collect())
}

/// The address of the page, without what a link adds.
pub fn address() -> Option<String> {
    let address = web_sys::window()?.location().href().ok()?;
    Some(address.split('#').next().unwrap_or_default().to_owned())
}

/// Shows the browser's chooser, and gives its answer to `chosen`: no file if the user closed it. What is saved is
/// downloaded to where the browser says.
pub fn choose(purpose: Purpose, chosen: impl FnOnce(Option<PathBuf>) + Send + 'static) {
    let dialog = AsyncFileDialog::new();
    let dialog = match purpose {
        Purpose::Scene | Purpose::OtherScene => dialog.add_filter("scenes", &["toml", LOGS]),
        Purpose::Theirs => dialog.add_filter("pictures", &FORMATS),
        Purpose::Picture => return chosen(Some("picture.png".into())),
    };
    spawn_local(async move {
        let Some(file) = dialog.pick_file().await else { return chosen(None) };
        let (path, bytes) = (PathBuf::from(file.file_name()), file.read().await);
        FILES.with_borrow_mut(|files| files.insert(path.clone(), bytes));
        chosen(Some(path));
    });
}
