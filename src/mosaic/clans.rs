//! The clans of a growth, which clans touch, and colours for them that neighbours do not share.

use super::SiteLists;
use crate::surface::Mesh;
use glam::Vec2;

/// Colours that clans may have.
pub const CLAN_COLOURS: u32 = 8;

/// Pairs of clans whose cells share a border somewhere on a day, the lower number first, each pair once
/// and in order. `lists`: the day's; `clan_of`: of each of their sites.
pub fn touching(mesh: &Mesh, lists: &SiteLists, clan_of: impl Fn(usize) -> u32) -> Vec<[u32; 2]> {
    let mut pairs = Vec::new();
    let mut sites: Vec<(Vec2, u32)> = Vec::new();
    for (head, frame) in lists.heads.iter().zip(&mesh.frames) {
        let first = head.first as usize;
        let own = first..first + head.count as usize;
        sites.clear();
        sites.extend(own.map(|k| (lists.sites[k].now(head), clan_of(k))));
        let is_mixed = sites.iter().any(|site| site.1 != sites[0].1);
        if !is_mixed {
            continue;
        }
        let centroid = (frame.apex + Vec2::new(frame.length, 0.0)) / 3.0;
        let corners = frame.corners().map(|corner| corner - centroid);
        for (k, &one) in sites.iter().enumerate() {
            for &other in sites[k + 1..].iter().filter(|other| other.1 != one.1) {
                let pair = [one.1.min(other.1), one.1.max(other.1)];
                if share_border(&corners, &sites, one.0, other.0) {
                    pairs.push(pair);
                }
            }
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// Whether the polygons of two sites share a border within a triangle: whether of the line that is as
/// far from both there is a piece within all sides to which no site is nearer.
fn share_border(corners: &[Vec2; 3], sites: &[(Vec2, u32)], one: Vec2, other: Vec2) -> bool {
    let middle = 0.5 * (one + other);
    let along = (other - one).perp();
    let (mut from, mut to) = (f32::NEG_INFINITY, f32::INFINITY);
    // Keeps what of the line has `offset + slope * t >= 0`.
    let mut keep = |offset: f32, slope: f32| {
        if slope > 0.0 {
            from = from.max(-offset / slope);
        } else if slope < 0.0 {
            to = to.min(-offset / slope);
        } else if offset < 0.0 {
            to = f32::NEG_INFINITY;
        }
        from < to
    };
    let [a, b, c] = *corners;
    [(a, b), (b, c), (c, a)].iter().all(|&(start, end)| {
        let side = end - start;
        keep(side.perp_dot(middle - start), side.perp_dot(along))
    }) && sites.iter().all(|&(site, _)| {
        // Twice the way by which the site is farther than `one`, on the line.
        let way = one - site;
        let offset = 2.0 * way.dot(middle) + site.length_squared() - one.length_squared();
        way == Vec2::ZERO || site == other || keep(offset, 2.0 * way.dot(along))
    })
}

/// Colours for the clans of a growth, day by day: no two that touch share one. From day to day a clan keeps
/// its colour, unless it comes to touch another of the same.
#[derive(Clone, Debug, Default)]
pub struct ClanColours {
    days: Vec<Vec<u8>>,
}

/// Clans are given other colours so often for one day at most, in rounds of all: more than it ever takes.
const MOST_CHANGES: usize = 20;

impl ClanColours {
    /// How many days have colours.
    pub fn days(&self) -> usize {
        self.days.len()
    }

    /// The colours of a day that has some, by the number of the clan.
    pub fn of(&self, day: usize) -> &[u8] {
        &self.days[day]
    }

    /// Colours the next day of so many clans, of which these pairs touch.
    pub fn add(&mut self, clans: u32, pairs: &[[u32; 2]]) {
        let neighbours = Neighbours::new(clans, pairs);
        let uncoloured = || vec![u8::MAX; clans as usize];
        let mut colours = self.days.last().cloned().unwrap_or_else(uncoloured);
        colours.resize(clans as usize, u8::MAX);
        let mut used = [0; CLAN_COLOURS as usize];
        for &colour in colours.iter().filter(|&&colour| colour != u8::MAX) {
            used[colour as usize] += 1;
        }
        // Those with most neighbours choose first (Welsh and Powell 1967).
        let mut waiting: Vec<u32> = (0..clans).collect();
        waiting.retain(|&clan| {
            let own = colours[clan as usize];
            own == u8::MAX
                || neighbours
                    .of(clan)
                    .iter()
                    .any(|&other| colours[other as usize] == own && other < clan)
        });
        waiting.sort_by_key(|&clan| (neighbours.of(clan).len(), clan));
        let mut changes = MOST_CHANGES * clans as usize;
        while let Some(clan) = waiting.pop().filter(|_| changes > 0) {
            changes -= 1;
            let mut beside = [0; CLAN_COLOURS as usize];
            for &other in neighbours.of(clan) {
                if colours[other as usize] != u8::MAX {
                    beside[colours[other as usize] as usize] += 1;
                }
            }
            let before = std::mem::replace(&mut colours[clan as usize], u8::MAX);
            // Of those that fewest neighbours have, the one that is rarest; and another than before, so that
            // two clans do not push each other to and fro.
            let colour = (0..CLAN_COLOURS as usize)
                .min_by_key(|&colour| (beside[colour], colour == before as usize, used[colour]))
                .unwrap_or_default();
            for &other in neighbours.of(clan) {
                if colours[other as usize] == colour as u8 {
                    waiting.push(other);
                }
            }
            if before != u8::MAX {
                used[before as usize] -= 1;
            }
            used[colour] += 1;
            colours[clan as usize] = colour as u8;
        }
        self.days.push(colours);
    }
}

/// The neighbours of each clan.
struct Neighbours {
    first: Vec<u32>,
    all: Vec<u32>,
}

impl Neighbours {
    fn new(clans: u32, pairs: &[[u32; 2]]) -> Neighbours {
        let both = || pairs.iter().flat_map(|&[a, b]| [[a, b], [b, a]]);
        let mut first = vec![0; clans as usize + 2];
        both().for_each(|[clan, _]| first[clan as usize + 2] += 1);
        for k in 2..first.len() {
            first[k] += first[k - 1];
        }
        let mut all = vec![0; 2 * pairs.len()];
        for [clan, other] in both() {
            let slot = &mut first[clan as usize + 1];
            all[*slot as usize] = other;
            *slot += 1;
        }
        Neighbours { first, all }
    }

    fn of(&self, clan: u32) -> &[u32] {
        let clan = clan as usize;
        &self.all[self.first[clan] as usize..self.first[clan + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether no pair shares a colour.
    fn are_apart(colours: &[u8], pairs: &[[u32; 2]]) -> bool {
        pairs.iter().all(|&[a, b]| colours[a as usize] != colours[b as usize])
    }

    #[test]
    fn all_colours_are_found_where_all_are_needed() {
        let pairs: Vec<_> = (0..CLAN_COLOURS).flat_map(|b| (0..b).map(move |a| [a, b])).collect();
        let mut map = ClanColours::default();
        map.add(CLAN_COLOURS, &pairs);
        assert!(are_apart(map.of(0), &pairs));
        // One more cannot be told apart, but gets a colour.
        let pairs: Vec<_> = (0..=CLAN_COLOURS).flat_map(|b| (0..b).map(move |a| [a, b])).collect();
        map.add(CLAN_COLOURS + 1, &pairs);
        assert!(map.of(1).iter().all(|&colour| u32::from(colour) < CLAN_COLOURS));
    }

    #[test]
    fn from_day_to_day_only_those_change_that_must() {
        // A ring whose clans drift: on each day each touches two others.
        let clans = 100;
        let mut map = ClanColours::default();
        for day in 0..10 {
            let pair = |k: u32| [k, (k + 1 + day) % clans];
            let pairs: Vec<_> = (0..clans).map(pair).map(|[a, b]| [a.min(b), a.max(b)]).collect();
            map.add(clans, &pairs);
            let colours = map.of(day as usize);
            assert!(are_apart(colours, &pairs), "day {day}");
            if day > 0 {
                let before = map.of(day as usize - 1);
                let clashed =
                    pairs.iter().filter(|[a, b]| before[*a as usize] == before[*b as usize]);
                let changed = (0..clans as usize).filter(|&k| colours[k] != before[k]);
                assert!(changed.count() <= clashed.count());
            }
        }
    }
}
