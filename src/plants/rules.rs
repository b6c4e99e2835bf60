//! The version of the rules that a plant lives by.

use serde::{Deserialize, Serialize};

/// The rules of a plant; a link's `v` names them. No version ever changes: what would give other cells is another
/// version.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "u32", into = "u32")]
pub enum Rules {
    /// As in the thesis: control images are the same for all individuals.
    #[default]
    First = 1,
    /// What is irregular in control images is another in each individual.
    Second = 2,
}

impl From<Rules> for u32 {
    fn from(rules: Rules) -> u32 {
        rules as u32
    }
}

impl TryFrom<u32> for Rules {
    type Error = String;

    fn try_from(version: u32) -> Result<Rules, String> {
        let known =
            [Rules::First, Rules::Second].into_iter().find(|&rules| rules as u32 == version);
        known.ok_or_else(|| format!("there are no rules of version {version}: there are 1 and 2"))
    }
}
