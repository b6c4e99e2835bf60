//! How the parts of a plant are read and written: texts and lists that stay, rows by type, meshes by
//! name.

use super::super::{MeshFile, all};
use super::{List, Text};
use crate::surface::quoted;
use crate::tissue::CellType;
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Reads a text that stays until the program ends.
pub(in crate::plants) fn kept_text<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Text, D::Error> {
    String::deserialize(deserializer).map(|text| &*text.leak())
}

/// Reads a list that stays until the program ends.
pub(in crate::plants) fn kept_list<'de, D, T>(deserializer: D) -> Result<List<T>, D::Error>
where
    D: Deserializer<'de>,
    T: DeserializeOwned,
{
    Vec::deserialize(deserializer).map(|list: Vec<T>| &*list.leak())
}

/// Reads texts that stay until the program ends.
pub(in crate::plants) fn kept_texts<'de, D: Deserializer<'de>>(
    d: D,
) -> Result<List<Text>, D::Error> {
    let texts = Vec::<String>::deserialize(d)?;
    Ok(texts.into_iter().map(|text| &*text.leak()).collect::<Vec<Text>>().leak())
}

/// A mesh of the catalogue, by its name.
impl Serialize for MeshFile {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        self.name.serialize(s)
    }
}

impl<'de> Deserialize<'de> for MeshFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<MeshFile, D::Error> {
        let name = String::deserialize(deserializer)?;
        let mut meshes: Vec<MeshFile> = all().iter().map(|plant| plant.body.mesh).collect();
        meshes.sort_by_key(|mesh| mesh.name);
        meshes.dedup();
        meshes.iter().find(|mesh| mesh.name == name).copied().ok_or_else(|| {
            let names: Vec<Text> = meshes.iter().map(|mesh| mesh.name).collect();
            let name = quoted(&name);
            D::Error::custom(format!("there is no mesh {name}: there are {}", names.join(", ")))
        })
    }
}

/// A value for each type of cell, by its letter.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE", deny_unknown_fields)]
pub(super) struct ByType<T> {
    f: T,
    b: T,
    m: T,
}

impl<T> ByType<T> {
    pub fn of([f, b, m]: [T; 3]) -> ByType<T> {
        ByType { f, b, m }
    }

    pub fn row(self) -> [T; 3] {
        [self.f, self.b, self.m]
    }
}

/// Rows with a value for each type.
pub(in crate::plants) mod by_type {
    use super::*;

    pub fn serialize<S: Serializer, T: Serialize>(row: &[T; 3], s: S) -> Result<S::Ok, S::Error> {
        ByType::of(row.each_ref()).serialize(s)
    }

    pub fn deserialize<'de, D, T>(deserializer: D) -> Result<[T; 3], D::Error>
    where
        D: Deserializer<'de>,
        T: Deserialize<'de>,
    {
        ByType::deserialize(deserializer).map(ByType::row)
    }
}

/// The tinted colour of a type.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::plants) struct Tint {
    of: CellType,
    colour: [f32; 3],
}

/// Colour and gloss of a bare material.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::plants) struct Bare {
    #[serde(deserialize_with = "kept_text")]
    material: Text,
    colour: [f32; 3],
    gloss: f32,
}

impl From<(CellType, [f32; 3])> for Tint {
    fn from((of, colour): (CellType, [f32; 3])) -> Tint {
        Tint { of, colour }
    }
}

impl From<Tint> for (CellType, [f32; 3]) {
    fn from(tint: Tint) -> (CellType, [f32; 3]) {
        (tint.of, tint.colour)
    }
}

impl From<(Text, [f32; 3], f32)> for Bare {
    fn from((material, colour, gloss): (Text, [f32; 3], f32)) -> Bare {
        Bare { material, colour, gloss }
    }
}

impl From<Bare> for (Text, [f32; 3], f32) {
    fn from(bare: Bare) -> (Text, [f32; 3], f32) {
        (bare.material, bare.colour, bare.gloss)
    }
}

/// Lists of what are plain tuples in the program, each written as an `N` with names.
pub(in crate::plants) struct Listed<N>(std::marker::PhantomData<N>);

impl<N> Listed<N> {
    pub fn serialize<T, S>(list: &List<T>, serializer: S) -> Result<S::Ok, S::Error>
    where
        T: Copy,
        N: From<T> + Serialize,
        S: Serializer,
    {
        serializer.collect_seq(list.iter().map(|&item| N::from(item)))
    }

    pub fn deserialize<'de, T, D>(deserializer: D) -> Result<List<T>, D::Error>
    where
        N: Into<T> + Deserialize<'de>,
        D: Deserializer<'de>,
    {
        let named = Vec::<N>::deserialize(deserializer)?;
        Ok(named.into_iter().map(N::into).collect::<Vec<T>>().leak())
    }
}
