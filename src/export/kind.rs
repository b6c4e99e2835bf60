//! The kinds of files that a plant can be taken away as.

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Glb,
    Ply,
    Obj,
    ThreeMf,
    Usdz,
    Svg,
    Leaves,
    Tile,
    Days,
    Clones,
    Cells,
}

impl Kind {
    pub const ALL: [Kind; 11] = [
        Kind::Glb,
        Kind::Ply,
        Kind::Obj,
        Kind::ThreeMf,
        Kind::Usdz,
        Kind::Svg,
        Kind::Leaves,
        Kind::Tile,
        Kind::Days,
        Kind::Clones,
        Kind::Cells,
    ];

    /// Its word, on the command line and in the page.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Glb => "glb",
            Kind::Ply => "ply",
            Kind::Obj => "obj",
            Kind::ThreeMf => "3mf",
            Kind::Usdz => "usdz",
            Kind::Svg => "svg",
            Kind::Leaves => "leaves",
            Kind::Tile => "tile",
            Kind::Days => "days",
            Kind::Clones => "clones",
            Kind::Cells => "cells",
        }
    }

    pub fn of_word(word: &str) -> Option<Kind> {
        Kind::ALL.into_iter().find(|kind| kind.word() == word)
    }

    /// How the name of its file ends, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Kind::Leaves => "zip",
            Kind::Tile => "png",
            Kind::Days | Kind::Clones | Kind::Cells => "csv",
            kind => kind.word(),
        }
    }
}
