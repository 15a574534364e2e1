//! The data of the scene that lights need to be built.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::background::Sky;
use crate::invalid::Invalid;
use crate::materials::Emission;
use crate::shapes::Shape;
use formats::printable::{self, listed};

/// The objects that area lights may name, and the sky.
#[derive(Debug, Default)]
pub struct Context {
    /// The objects that are on, by name.
    pub objects: BTreeMap<String, LampObject>,
    /// The names of the objects that are switched off.
    pub hidden: BTreeSet<String>,
    /// The background.
    pub background: Sky,
}

/// The data of an object that an area light needs.
#[derive(Clone, Debug)]
pub struct LampObject {
    /// Its shape.
    pub shape: Arc<dyn Shape>,
    /// The emission of its material, if it has one.
    pub emission: Option<Emission>,
    /// Whether its back shines as its front.
    pub two_sided: bool,
}

impl Context {
    /// The object of this name.
    pub(super) fn object(&self, name: &str) -> Result<&LampObject, Invalid> {
        let shown = printable::name(name);
        if self.hidden.contains(name) {
            return Err(Invalid::new(format!("`{shown}` is not there: it has `enabled = false`")));
        }
        self.objects.get(name).ok_or_else(|| {
            if self.objects.is_empty() {
                return Invalid::new(format!("no object `{shown}`: the scene has none"));
            }
            let known = listed(self.objects.keys());
            Invalid::new(format!("no object `{shown}`; there are: {known}"))
        })
    }
}
