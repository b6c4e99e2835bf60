//! For each triangle the short list of sites whose Voronoi polygons may reach into it: what a
//! fragment shader needs to find the nearest one.

use crate::surface::Mesh;
use glam::Vec2;

/// One candidate site of one triangle, two words as the shader reads them:
///
/// | bits | of the first word | of the second word |
/// |---|---|---|
/// | 0 to 11 | x now | y now |
/// | 12 to 23 | x the day before | y the day before |
/// | 24 to 31 | tag, low bits | tag, high bits |
///
/// Coordinates are `(value - 2048) * scale_cm` centimetres from the triangle's centroid, in its
/// plane. A cell born since the day before was where its parent was; motion between the days is the
/// straight line. The tag's bits, from the lowest: two for the index of the `CellType`, one that says
/// newborn, six that tell the cell from its neighbours in the list, three for its tint, and four for its
/// lightness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Site {
    pub words: [u32; 2],
}

/// What a site says of its cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tag {
    pub kind: u32,
    pub is_newborn: bool,
    /// Equal, but for chance, only for two images of one cell; below 64.
    pub number: u32,
    /// From 0, the own colour of its type, to `MOST_TINT`, the tinted one.
    pub tint: u32,
    /// Below 16.
    pub lightness: u32,
}

/// The list of one triangle, four words as the shader reads them.
#[derive(Clone, Copy, Debug, PartialEq, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Head {
    /// Index of the first site of the list, an even number, and how many there are.
    pub first: u32,
    pub count: u32,
    /// Centimetres of one step of the packed coordinates.
    pub scale_cm: f32,
    pub unused: u32,
}

/// The lists of all triangles for one day, exact for every moment between the day before and this
/// one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SiteLists {
    pub heads: Vec<Head>,
    /// An even number.
    pub sites: Vec<Site>,
}

pub const MOST_TINT: u32 = 7;

const MIDDLE: f32 = 2048.0;
/// In the second word.
const LIGHTNESS_SHIFT: u32 = 28;
const COORDINATE: u32 = (1 << 12) - 1;

/// Steps from the centroid to the farthest coordinate that fits.
pub(super) const FARTHEST_STEPS: f32 = 2047.0;

impl SiteLists {
    /// The sites of a triangle.
    pub fn of(&self, triangle: usize) -> &[Site] {
        let head = &self.heads[triangle];
        &self.sites[head.first as usize..(head.first + head.count) as usize]
    }

    /// The number among all sites of the one that is nearest to a place of a triangle's plane, given from its
    /// centroid, at a moment between the day before (0) and the day of the lists (1).
    pub fn nearest(&self, triangle: usize, place_cm: Vec2, moment: f32) -> Option<usize> {
        let head = &self.heads[triangle];
        let own = head.first as usize..(head.first + head.count) as usize;
        let distance = |&k: &usize| {
            let site = &self.sites[k];
            site.before(head).lerp(site.now(head), moment).distance_squared(place_cm)
        };
        own.min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// How much of the surface is in the polygons of each `CellType`, in ten-thousandths of all of it:
    /// told from four points of each triangle, which for our plants is right to half a percent. A part
    /// without cells belongs to none. `mesh`: as it stands on the day of the lists.
    pub fn areas(&self, mesh: &Mesh) -> [u32; 3] {
        let mut areas = [0.0; 3];
        for (triangle, &area) in mesh.areas.iter().enumerate() {
            for kind in self.kinds(triangle, mesh.frames[triangle].corners()).into_iter().flatten()
            {
                areas[kind as usize] += area / 4.0;
            }
        }
        areas.map(|area: f32| (area / mesh.area * 10_000.0).round() as u32)
    }

    /// The types at the centres of the four triangles into which the sides' middles part one.
    fn kinds(&self, triangle: usize, corners: [Vec2; 3]) -> [Option<u32>; 4] {
        let head = &self.heads[triangle];
        // From the centroid, which is the centre of the middle one; the others are half as far out as
        // the corners.
        let centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
        let outer = corners.map(|corner| (corner - centroid) * 0.5);
        let mut nearest = [(f32::INFINITY, None); 4];
        for site in self.of(triangle) {
            let (at, kind) = (site.now(head), site.tag().kind);
            for (point, best) in [Vec2::ZERO].into_iter().chain(outer).zip(&mut nearest) {
                let distance = at.distance_squared(point);
                if distance < best.0 {
                    *best = (distance, Some(kind));
                }
            }
        }
        nearest.map(|(_, kind)| kind)
    }
}

impl Site {
    /// `now` and `before` in steps from the triangle's centroid, at most `FARTHEST_STEPS`.
    pub(super) fn new(now: Vec2, before: Vec2, tag: Tag) -> Site {
        let step = |v: f32| (v + MIDDLE + 0.5) as u32 & COORDINATE;
        let tag = tag.kind
            | u32::from(tag.is_newborn) << 2
            | (tag.number & 63) << 3
            | (tag.tint & MOST_TINT) << 9
            | (tag.lightness & 15) << 12;
        let word =
            |now: f32, before: f32, tag: u32| step(now) | step(before) << 12 | (tag & 255) << 24;
        Site { words: [word(now.x, before.x, tag), word(now.y, before.y, tag >> 8)] }
    }

    /// Place on the day of the list, in centimetres from the triangle's centroid.
    pub fn now(&self, head: &Head) -> Vec2 {
        self.place(head, 0)
    }

    /// Place on the day before.
    pub fn before(&self, head: &Head) -> Vec2 {
        self.place(head, 12)
    }

    pub fn tag(&self) -> Tag {
        let bits = self.words[0] >> 24 | self.words[1] >> 24 << 8;
        Tag {
            kind: bits & 3,
            is_newborn: bits & 4 != 0,
            number: bits >> 3 & 63,
            tint: bits >> 9 & MOST_TINT,
            lightness: bits >> 12,
        }
    }

    /// The same site with four other bits in the place of its lightness.
    pub fn marked(self, bits: u32) -> Site {
        let [x, y] = self.words;
        Site { words: [x, y & !(15 << LIGHTNESS_SHIFT) | (bits & 15) << LIGHTNESS_SHIFT] }
    }

    fn place(&self, head: &Head, shift: u32) -> Vec2 {
        let [x, y] =
            self.words.map(|word| ((word >> shift & COORDINATE) as f32 - MIDDLE) * head.scale_cm);
        Vec2::new(x, y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sites_come_back() {
        let head = Head { scale_cm: 0.25, ..Head::default() };
        for (kind, is_newborn, number, tint, lightness) in
            [(0, true, 0, MOST_TINT, 15), (2, false, 63, 0, 0), (1, true, 7, 3, 8)]
        {
            let tag = Tag { kind, is_newborn, number, tint, lightness };
            let (now, before) = (Vec2::new(-2047.0, 17.0), Vec2::new(2047.0, -3.0));
            let site = Site::new(now, before, tag);
            assert_eq!((site.now(&head), site.before(&head)), (now * 0.25, before * 0.25));
            assert_eq!(site.tag(), tag);
            let marked = site.marked(9);
            assert_eq!(marked.tag(), Tag { lightness: 9, ..tag });
            assert_eq!((marked.now(&head), marked.before(&head)), (now * 0.25, before * 0.25));
        }
    }
}
