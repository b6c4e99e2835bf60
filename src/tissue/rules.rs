//! The version of the rules that cells live by.

use crate::surface::{Mesh, Place, Step, walk, walk_between_mirrors};
use glam::Vec2;
use serde::{Deserialize, Serialize};

/// The rules of a run; a link's `v` names them. No version ever changes: what would give other cells is another
/// version.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "u32", into = "u32")]
pub enum Rules {
    /// As in the thesis and the original program: cells slide along open rims, the repulsive radius is
    /// that of all cells on the whole body, and control images are the same for all individuals.
    #[default]
    First = 1,
    /// Open rims push back as mirrors, each part of the body has the repulsive radius of its own cells, and
    /// what is irregular in control images is another in each individual.
    Second = 2,
}

impl Rules {
    pub const NEWEST: Rules = Rules::Second;

    /// Walks over the surface as rims let it.
    #[inline]
    pub(super) fn walk(self, mesh: &Mesh, from: Place, step: Vec2) -> Step {
        match self {
            Rules::First => walk(mesh, from, step),
            Rules::Second => walk_between_mirrors(mesh, from, step),
        }
    }
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
