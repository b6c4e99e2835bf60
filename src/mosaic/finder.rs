//! Finds the sites of each triangle's list, day by day.

use super::lookout::Lookout;
use super::near::{Near, SortedCells};
use super::picked::{Home, Picked};
use super::shades::{lightness, tints};
use super::sites::{FARTHEST_STEPS, Head, Site, SiteLists, Tag};
use crate::surface::{Charts, Frame, Mesh};
use crate::tissue::{Control, Diary, Rim};
use glam::Vec2;

/// Makes the site lists of the days of one mesh. It keeps its memory from day to day, and what it
/// learnt of distances.
#[derive(Debug)]
pub struct SiteFinder {
    charts: Charts,
    controls: Vec<Control>,
    cells: SortedCells,
    /// For each part whether it has cells: on one without, none can be found however far one looks.
    has_cells: Vec<bool>,
    lookout: Lookout,
    near: Near,
    picked: Picked,
    /// How far from each triangle sites had to be looked for the last time, in mean spacings.
    reach: Vec<f32>,
    /// Whether the day that was found last was day 0.
    is_of_day_0: bool,
    /// For each cell the list that it was last put in, and its number there.
    number_of: Vec<(u32, u32)>,
    /// Of each cell.
    tints: Vec<u32>,
    /// The cell of each site of the lists found last.
    pub cell_of: Vec<u32>,
}

/// Sites are kept this much farther out than the nearest one asks for, in mean spacings: room for the
/// drawn border between two cells.
const BORDER_ROOM: f32 = 0.15;

/// First guess of the distance in which a triangle finds all its sites, in mean spacings.
const FIRST_REACH: f32 = 1.5;

/// From day 1 on, when cells have moved, charts reach at least so far, in mean spacings: then those of
/// day 1 serve all days. Day 0, for whose picture everybody waits, needs smaller ones.
const SMALLEST_CHART: f32 = 1.9;

/// Where there are so many triangles to a cell, the cells look out for them: on day 0, and on later days,
/// when the charts of all triangles would serve for the days that follow, too.
const SPARSE_ON_DAY_0: usize = 7;
const SPARSE_LATER: usize = 14;

impl SiteFinder {
    pub fn new(mesh: &Mesh) -> SiteFinder {
        SiteFinder {
            charts: Charts::new(mesh),
            controls: Vec::new(),
            cells: SortedCells::default(),
            has_cells: Vec::new(),
            lookout: Lookout::default(),
            near: Near::default(),
            picked: Picked::default(),
            reach: vec![FIRST_REACH; mesh.triangles.len()],
            is_of_day_0: false,
            number_of: Vec::new(),
            tints: Vec::new(),
            cell_of: Vec::new(),
        }
    }

    /// Begins another growth on the same mesh, coloured by its own control images: its lists are those of a new
    /// finder. Charts that were made for wider spacings would show the images of a triangle in another order.
    pub fn begin(&mut self, controls: Vec<Control>) {
        self.controls = controls;
        self.forget();
    }

    /// Forgets what days before have brought: the lists of the next one are those of a new finder.
    pub fn forget(&mut self) {
        self.charts.clear();
        self.reach.fill(FIRST_REACH);
    }

    /// Cells have the colours of these control images, by the place where they are on each day.
    pub fn coloured(mut self, controls: Vec<Control>) -> SiteFinder {
        self.controls = controls;
        self
    }

    /// The lists of a day of the mesh that the finder was made for. If it moves, they are for the frames of its
    /// triangles on that day.
    pub fn find(&mut self, mesh: &Mesh, diary: &Diary, day: usize) -> SiteLists {
        let (rest, mesh) = (mesh, &*mesh.on(day as u32));
        if !rest.motion.is_still() {
            self.charts = Charts::new(mesh);
        }
        let spacing = (mesh.area / diary.days[day].places.len() as f32).sqrt();
        let room = BORDER_ROOM * spacing;
        let born_before = diary.days[day.saturating_sub(1)].places.len() as u32;
        if std::mem::replace(&mut self.is_of_day_0, day == 0) && day > 0 {
            // Those of day 0 are too small for any later one.
            self.charts.clear();
        }
        self.cells.gather(mesh, &mut self.charts, diary, day, spacing);
        self.has_cells.clear();
        self.has_cells.resize(mesh.part_count(), false);
        for place in &diary.days[day].places {
            self.has_cells[mesh.parts[place.triangle as usize] as usize] = true;
        }
        self.cell_of.clear();
        self.number_of.clear();
        self.number_of.resize(diary.days[day].places.len(), (u32::MAX, 0));
        self.tints.clear();
        self.tints.extend(tints(rest, &self.controls, diary, day));
        let mut lists =
            SiteLists { heads: Vec::with_capacity(mesh.triangles.len()), sites: Vec::new() };
        let sparse = if day == 0 { SPARSE_ON_DAY_0 } else { SPARSE_LATER };
        let is_sparse = sparse * diary.days[day].places.len() < mesh.triangles.len();
        if is_sparse {
            self.look_out(mesh, spacing, room);
        }
        for (triangle, frame) in mesh.frames.iter().enumerate() {
            let home = Home { frame, rim: Rim::new(frame), size: self.cells.size(triangle) };
            let bound = if !self.has_cells[mesh.parts[triangle] as usize] {
                self.near.take(&[]);
                f32::INFINITY
            } else if is_sparse {
                self.seen_bound(triangle, frame, spacing) + room
            } else {
                let smallest_chart = if day == 0 { 0.0 } else { SMALLEST_CHART * spacing };
                self.search(mesh, triangle, &home, smallest_chart, spacing, room)
            };
            self.picked.pick(&self.near, &home, bound, room, spacing);
            self.write(&home, born_before, spacing, &mut lists);
        }
        lists
    }

    /// Gathers the sites around a triangle; within how far of it those of its list lie.
    fn search(
        &mut self,
        mesh: &Mesh,
        triangle: usize,
        home: &Home,
        smallest_chart: f32,
        spacing: f32,
        room: f32,
    ) -> f32 {
        let mut reach = self.reach[triangle] * spacing;
        let bound = loop {
            let radius = reach + self.cells.longest_motion;
            let images = self.charts.around(mesh, triangle as u32, radius.max(smallest_chart));
            self.near.gather(&self.cells, images, &home.rim, radius);
            let bound = self.near.bound(&self.cells, triangle, home.frame, spacing) + room;
            if bound <= reach {
                break bound;
            }
            reach = if bound.is_finite() { bound } else { reach * 2.0 };
        };
        self.reach[triangle] = (bound * 1.05 / spacing).min(8.0);
        bound
    }

    /// Lets the cells look out as far as it takes to be seen from all triangles whose lists they are in.
    fn look_out(&mut self, mesh: &Mesh, spacing: f32, room: f32) {
        let mut reach = FIRST_REACH * spacing;
        loop {
            let radius = reach + self.cells.longest_motion;
            self.lookout.look(mesh, &mut self.charts, &self.cells, radius);
            let mut farthest = 0.0f32;
            for (triangle, frame) in mesh.frames.iter().enumerate() {
                if self.has_cells[mesh.parts[triangle] as usize] {
                    farthest = farthest.max(self.seen_bound(triangle, frame, spacing) + room);
                }
            }
            if farthest <= reach {
                return;
            }
            reach = if farthest.is_finite() { farthest } else { reach * 2.0 };
        }
    }

    /// Takes up the sites that a triangle has been seen from; within how far of it its nearest ones lie.
    fn seen_bound(&mut self, triangle: usize, frame: &Frame, spacing: f32) -> f32 {
        self.near.take(self.lookout.of(triangle));
        self.near.bound(&self.cells, triangle, frame, spacing)
    }

    /// Appends the list of a triangle.
    fn write(&mut self, home: &Home, born_before: u32, spacing: f32, lists: &mut SiteLists) {
        let centroid = (home.frame.apex + Vec2::new(home.frame.length, 0.0)) / 3.0;
        let farthest = self.picked.sites().fold(Vec2::ZERO, |most, site| {
            most.max((site.now - centroid).abs()).max((site.before - centroid).abs())
        });
        let scale_cm = farthest.max_element() / FARTHEST_STEPS + f32::MIN_POSITIVE;
        self.picked.merge_clumps(scale_cm, spacing);
        let first = lists.sites.len();
        for site in self.picked.sites() {
            let here = lists.heads.len() as u32;
            let next = (self.cell_of.len() - first) as u32;
            let number = &mut self.number_of[site.cell as usize];
            if number.0 != here {
                *number = (here, next);
            }
            let tag = Tag {
                kind: site.kind,
                is_newborn: site.cell >= born_before,
                number: number.1,
                tint: self.tints[site.cell as usize],
                lightness: lightness(site.cell),
            };
            let steps = |place: Vec2| (place - centroid) / scale_cm;
            lists.sites.push(Site::new(steps(site.now), steps(site.before), tag));
            self.cell_of.push(site.cell);
        }
        let count = (lists.sites.len() - first) as u32;
        if count % 2 == 1 {
            lists.sites.push(Site::default());
            self.cell_of.push(u32::MAX);
        }
        lists.heads.push(Head { first: first as u32, count, scale_cm, unused: 0 });
    }
}
