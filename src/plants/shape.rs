//! Where a plant's body comes from: a control mesh, how far each of its groups is refined, and what
//! grows on it at load.

use super::{BodyError, List, MeshFile, Text, kept_list, kept_text, spikes};
use crate::surface::{Body, Group, PolygonMesh};
use serde::{Deserialize, Serialize};

/// A body by its control mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shape {
    pub mesh: MeshFile,
    /// How often each triangle or quad is cut into four, 0 to 5.
    pub levels: u32,
    /// Groups of another number of levels, by the name of their part or of their material.
    #[serde(deserialize_with = "kept_list")]
    pub but: List<Levels>,
    /// What grows on it.
    pub growths: Growths,
}

/// How often a group is cut.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Levels {
    #[serde(deserialize_with = "kept_text")]
    pub group: Text,
    pub levels: u32,
}

/// Thin things that would outweigh all the rest in a mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Growths {
    Nothing,
    /// Spines on each face of the material `bare:areole`.
    Spines,
    /// Shoots on the faces of the material `bare:moss`.
    Moss,
}

impl Shape {
    /// The body, grown from the text of its mesh file.
    pub fn grow(&self, obj: &str) -> Result<Body, BodyError> {
        let mut mesh = self.refined(obj)?;
        match self.growths {
            Growths::Nothing => {}
            Growths::Spines => spikes::raise_spines(&mut mesh),
            Growths::Moss => spikes::grow_moss(&mut mesh),
        }
        Ok(Body::new(&mesh)?)
    }

    /// The mesh of its file as fine as it is to be, before anything grows on it.
    pub fn refined(&self, obj: &str) -> Result<PolygonMesh, BodyError> {
        Ok(PolygonMesh::parse(obj)?.refined_by(&|group| self.levels_of(group)))
    }

    fn levels_of(&self, group: &Group) -> u32 {
        let is_named = |but: &&Levels| but.group == group.part || but.group == group.material;
        self.but.iter().find(is_named).map_or(self.levels, |but| but.levels)
    }

    /// Whether its numbers are in their ranges; else why not.
    pub fn check(&self) -> Result<(), String> {
        let mut all = self.but.iter().map(|but| but.levels).chain([self.levels]);
        match all.find(|&levels| levels > 5) {
            Some(levels) => Err(format!("levels is {levels}: it must be from 0 to 5")),
            None => Ok(()),
        }
    }
}
