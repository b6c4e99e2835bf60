//! The clans of a growth, which clans touch, and colours for them that neighbours do not share.

use super::SiteLists;
use crate::surface::Mesh;
use glam::Vec2;

/// Colours that clans may have.
pub const CLAN_COLOURS: u32 = 8;

/// Pairs of clans whose cells share a border somewhere on a day, the lower number first, each pair once
/// and in order: those of all pairs that are wanted. `lists`: the day's; `clan_of`: of each of their sites.
pub fn touching(
    mesh: &Mesh,
    lists: &SiteLists,
    clan_of: impl Fn(usize) -> u32,
    is_wanted: impl Fn(u32, u32) -> bool,
) -> Vec<[u32; 2]> {
    // A pair in one number: these are sorted elsewhere, too, and a second sort would be bytes to download.
    let mut pairs: Vec<u64> = Vec::new();
    let mut sites: Vec<(Vec2, u32)> = Vec::new();
    for (head, frame) in lists.heads.iter().zip(&mesh.frames) {
        let first = head.first as usize;
        let own = first..first + head.count as usize;
        sites.clear();
        sites.extend(own.map(|k| (lists.sites[k].now(head), clan_of(k))));
        let centroid = (frame.apex + Vec2::new(frame.length, 0.0)) / 3.0;
        let corners = frame.corners().map(|corner| corner - centroid);
        for (k, &(one, clan)) in sites.iter().enumerate() {
            for &(other, beside) in &sites[k + 1..] {
                if clan != beside
                    && is_wanted(clan, beside)
                    && share_border(&corners, &sites, one, other)
                {
                    pairs.push(u64::from(clan.min(beside)) << 32 | u64::from(clan.max(beside)));
                }
            }
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs.into_iter().map(|pair| [(pair >> 32) as u32, pair as u32]).collect()
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

/// Rounds in which clans that clash are given other colours: more than it ever takes.
const MOST_ROUNDS: usize = 20;

/// From this round on, a clan that clashes has neighbours of all colours: they are given others, too.
const WIDER_ROUND: usize = 8;

/// No colour yet.
const NONE: u8 = u8::MAX;

impl ClanColours {
    /// How many days have colours.
    pub fn days(&self) -> usize {
        self.days.len()
    }

    /// The colours of a day that has some, by the number of the clan.
    pub fn of(&self, day: usize) -> &[u8] {
        &self.days[day]
    }

    /// Colours the next day of so many clans. `touching` finds, of the pairs of clans that are wanted, those
    /// that touch on that day; few are asked for after the first day.
    pub fn add(
        &mut self,
        clans: u32,
        touching: impl Fn(&dyn Fn(u32, u32) -> bool) -> Vec<[u32; 2]>,
    ) {
        let uncoloured = || vec![NONE; clans as usize];
        let mut colours = self.days.last().cloned().unwrap_or_else(uncoloured);
        colours.resize(clans as usize, NONE);
        for round in 0..MOST_ROUNDS {
            let mut clashes: Vec<bool> = colours.iter().map(|&colour| colour == NONE).collect();
            if !clashes.contains(&true) {
                let of = |clan: u32| colours[clan as usize];
                let alike = touching(&|a, b| of(a) == of(b));
                // In turns, so that no two push each other to and fro.
                alike.iter().for_each(|pair| clashes[pair[(round + 1) % 2] as usize] = true);
                if alike.is_empty() {
                    break;
                }
            }
            let mut pairs = touching(&|a, b| clashes[a as usize] || clashes[b as usize]);
            if round >= WIDER_ROUND {
                pairs.iter().flatten().for_each(|&clan| clashes[clan as usize] = true);
                pairs = touching(&|a, b| clashes[a as usize] || clashes[b as usize]);
            }
            recolour(&mut colours, &clashes, &Neighbours::new(clans, &pairs));
        }
        self.days.push(colours);
    }
}

/// Gives each clan that clashes the colour that fewest of its neighbours have, and of those the one that is
/// rarest of all. Those with most neighbours choose first (Welsh and Powell 1967).
fn recolour(colours: &mut [u8], clashes: &[bool], neighbours: &Neighbours) {
    let mut used = [0u32; CLAN_COLOURS as usize];
    for &colour in colours.iter().filter(|&&colour| colour != NONE) {
        used[colour as usize] += 1;
    }
    let order = |(clan, _): (u32, &bool)| {
        let count = neighbours.of(clan).len() as u32;
        u64::from(u32::MAX - count) << 32 | u64::from(clan)
    };
    let mut waiting: Vec<u64> = (0..).zip(clashes).filter(|(_, is)| **is).map(order).collect();
    waiting.sort_unstable();
    for clan in waiting.into_iter().map(|key| key as u32) {
        let mut beside = [0u32; CLAN_COLOURS as usize];
        for &other in neighbours.of(clan) {
            if let Some(count) = beside.get_mut(colours[other as usize] as usize) {
                *count += 1;
            }
        }
        let own = &mut colours[clan as usize];
        if let Some(count) = used.get_mut(*own as usize) {
            *count -= 1;
        }
        *own = (0..CLAN_COLOURS as u8)
            .min_by_key(|&colour| (beside[colour as usize], used[colour as usize]))
            .unwrap_or_default();
        used[*own as usize] += 1;
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

    fn wanted_of(pairs: &[[u32; 2]]) -> impl Fn(&dyn Fn(u32, u32) -> bool) -> Vec<[u32; 2]> {
        |is_wanted| pairs.iter().copied().filter(|&[a, b]| is_wanted(a, b)).collect()
    }

    /// Whether no pair shares a colour.
    fn are_apart(colours: &[u8], pairs: &[[u32; 2]]) -> bool {
        pairs.iter().all(|&[a, b]| colours[a as usize] != colours[b as usize])
    }

    #[test]
    fn all_colours_are_found_where_all_are_needed() {
        let pairs: Vec<_> = (0..CLAN_COLOURS).flat_map(|b| (0..b).map(move |a| [a, b])).collect();
        let mut map = ClanColours::default();
        map.add(CLAN_COLOURS, wanted_of(&pairs));
        assert!(are_apart(map.of(0), &pairs));
        // One more cannot be told apart, but gets a colour.
        let pairs: Vec<_> = (0..=CLAN_COLOURS).flat_map(|b| (0..b).map(move |a| [a, b])).collect();
        map.add(CLAN_COLOURS + 1, wanted_of(&pairs));
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
            map.add(clans, wanted_of(&pairs));
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
