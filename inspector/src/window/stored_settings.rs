//! Settings that are stored between runs, besides the window's size and position.

use eframe::Storage;
use serde::{Deserialize, Serialize};

use crate::splits::Splits;
use crate::window::style::Ground;

const NAME: &str = "inspector";

/// Settings of the window. Those missing in the file have their defaults.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StoredSettings {
    /// The division of the window.
    pub splits: Splits,
    /// Dark or light.
    pub ground: Ground,
}

impl StoredSettings {
    /// The settings of the last run; the defaults if they cannot be read.
    pub fn read(storage: Option<&dyn Storage>) -> Self {
        let stored: Self =
            storage.and_then(|storage| eframe::get_value(storage, NAME)).unwrap_or_default();
        Self { splits: stored.splits.fitting(), ..stored }
    }

    /// Stores the settings for the next run.
    pub fn write(&self, storage: &mut dyn Storage) {
        eframe::set_value(storage, NAME, self);
    }
}
