//! What is seen: the Voronoi tessellation of the cells on the surface, and its pattern in numbers.

mod clans;
mod finder;
mod lookout;
mod near;
mod pattern;
mod picked;
mod polygons;
mod shades;
mod sites;

pub use clans::{CLAN_COLOURS, ClanColours, touching};
pub use finder::SiteFinder;
pub use pattern::{Pattern, neighbours};
pub use polygons::{Across, Piece, polygons};
pub use shades::{lightness, tints};
pub use sites::{Head, MOST_TINT, Site, SiteLists, Tag};
