//! The inspector in a page: opens what the page's address names after `#` ([`Arguments::of_link`]), again when that
//! changes. With `?embed` it has no bars.

use std::any::Any;
use std::cell::RefCell;

use eframe::egui::{Context, Ui};
use eframe::{App, CreationContext, Frame, Storage, WebOptions, WebRunner};
use inspector::app::Inspector;
use inspector::start::Start;
use inspector::window::arguments::Arguments;
use wasm_bindgen::prelude::*;
use web_sys::{HtmlCanvasElement, window};

thread_local! {
    /// The window that is open.
    static RUNNER: RefCell<Option<WebRunner>> = const { RefCell::new(None) };
}

/// What the open window says; nothing if none is open.
fn said(of: impl FnOnce(&Inspector) -> Option<String>) -> String {
    let said = RUNNER.with_borrow(|runner| of(&runner.as_ref()?.app_mut::<Page>()?.inspector));
    said.unwrap_or_default()
}

/// What `groundtruth explain` prints of the sample that is selected; nothing if none is explained.
#[wasm_bindgen]
pub fn explained() -> String {
    said(|inspector| {
        let selection = &inspector.selection;
        let mut explanation = selection.explanation()?.clone();
        explanation.samples.retain(|sample| sample.index == selection.sample);
        Some(explanation.text(0.01, false))
    })
}

/// The message in the window.
#[wasm_bindgen]
pub fn message() -> String {
    said(|inspector| Some(inspector.message.as_ref()?.0.clone()))
}

/// Whether anything is still being computed.
#[wasm_bindgen]
pub fn busy() -> String {
    said(|inspector| inspector.is_busy().then(|| "busy".to_owned()))
}

/// Opens the window on a canvas of the page.
#[wasm_bindgen]
pub async fn open(canvas: HtmlCanvasElement) -> Result<(), JsValue> {
    let create = |context: &CreationContext<'_>| {
        let page = Page::new(&context.egui_ctx, context.storage);
        Ok(Box::new(page) as Box<dyn App>)
    };
    let runner = WebRunner::new();
    RUNNER.set(Some(runner.clone()));
    runner.start(canvas, WebOptions::default(), Box::new(create)).await
}

/// What the address names after `#`.
fn link() -> String {
    let hash = window().and_then(|window| window.location().hash().ok()).unwrap_or_default();
    let link = hash.trim_start_matches('#');
    let decoded = js_sys::decode_uri_component(link);
    decoded.map_or_else(|_| link.to_owned(), String::from)
}

struct Page {
    inspector: Inspector,
    link: String,
}

impl Page {
    fn new(ctx: &Context, storage: Option<&dyn Storage>) -> Self {
        let link = link();
        let started = Arguments::of_link(&link)
            .and_then(|arguments| Ok((Start::read(&arguments)?, arguments)));
        let mut inspector = match started {
            Ok((start, arguments)) => start.inspector(ctx, storage, &arguments),
            Err(problem) => {
                let arguments = Arguments::of_link("").expect("all arguments have defaults");
                let start = Start::read(&arguments).expect("the gallery has the default scene");
                let mut inspector = start.inspector(ctx, storage, &arguments);
                inspector.message = Some((problem, true));
                inspector
            }
        };
        let search = window().and_then(|window| window.location().search().ok());
        inspector.is_embedded = search.is_some_and(|search| search.contains("embed"));
        Self { inspector, link }
    }
}

impl App for Page {
    fn ui(&mut self, ui: &mut Ui, frame: &mut Frame) {
        if self.link != link() {
            *self = Self::new(ui.ctx(), frame.storage());
        }
        self.inspector.ui(ui, frame);
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn Any> {
        Some(self)
    }

    fn save(&mut self, storage: &mut dyn Storage) {
        self.inspector.save(storage);
    }
}
