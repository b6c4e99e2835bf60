//! Strokes on their way from the visitor's hand to the plant: which place of the skin lies under a point of the stage,
//! the workshop finds out.

use super::painted;
use super::wish::STROKE;
use super::work::Work;
use crate::browser::dom::find;
use crate::import::{Stroke, Way};
use crate::plants::Plant;
use crate::play::link;
use glam::Vec2;
use js_sys::{Array, Float32Array};
use web_sys::{HtmlElement, PointerEvent};

/// Pixels between the points of a stroke that is drawn by hand, at least.
const APART_PX: f32 = 6.0;

/// A stroke that is being drawn, or was, and is not on the plant yet.
pub struct Drawing {
    /// As far as its places are known.
    pub stroke: Stroke,
    /// Points of the stage that the workshop is still to be asked of; none of them: of the middle.
    waits: Option<Vec<Vec2>>,
    /// Whether a straight line is drawn.
    is_straight: bool,
    hand: Hand,
}

/// What draws.
enum Hand {
    /// A pointer came down, with this event; nobody knows yet whether it did on the plant.
    New(Held, PointerEvent),
    /// A pointer that is down.
    Down(Held),
    /// One that was.
    Lifted,
    /// A key, at the middle of the stage; a straight line goes from one press to the next.
    Key,
}

/// Where a pointer came down, and where it was heard of last.
struct Held {
    from_px: Vec2,
    last_px: Vec2,
}

/// What becomes of a stroke.
pub enum Fate {
    /// The workshop is asked for its places.
    Asked,
    /// It goes on.
    Open,
    /// It is there.
    Done,
    /// Its first end is: the next key says where it goes.
    Begun,
    /// It lies on no plant.
    Nothing,
}

impl Drawing {
    /// A pointer comes down; the stroke has no points yet.
    pub fn press(stroke: Stroke, is_straight: bool, at_px: Vec2, event: PointerEvent) -> Drawing {
        let hand = Hand::New(Held { from_px: at_px, last_px: at_px }, event);
        Drawing { stroke, waits: Some(vec![at_px]), is_straight, hand }
    }

    /// A key is pressed; the stroke goes on from its last point, if it has one.
    pub fn key(stroke: Stroke, is_straight: bool) -> Drawing {
        Drawing { stroke, waits: Some(vec![]), is_straight, hand: Hand::Key }
    }

    /// Whether a pointer draws that is still down.
    pub fn is_in_hand(&self) -> bool {
        matches!(self.hand, Hand::New(..) | Hand::Down(_))
    }

    /// The pointer moves.
    pub fn drag(&mut self, at_px: Vec2) {
        let (Hand::New(held, _) | Hand::Down(held)) = &mut self.hand else { return };
        if at_px.distance(held.last_px) < APART_PX {
            return;
        }
        held.last_px = at_px;
        let from_px = held.from_px;
        if self.is_by_hand() {
            self.waits.get_or_insert_default().push(at_px);
        } else if self.is_straight {
            let steps = (from_px.distance(at_px) / (2.0 * APART_PX)) as u32 + 1;
            let along = (0..=steps).map(|k| from_px.lerp(at_px, k as f32 / steps as f32));
            self.waits = Some(along.collect());
        } else {
            self.waits = Some(vec![at_px]);
        }
    }

    pub fn lift(&mut self) {
        self.hand = Hand::Lifted;
    }

    /// Whether each point is added to those before: all else is where the hand is now.
    fn is_by_hand(&self) -> bool {
        self.stroke.way == Way::Free && !self.is_straight
    }

    /// Has the workshop find the places that it waits for, on a plant.
    fn ask(&self, at_px: &[Vec2], work: &Work, base: &'static Plant) {
        let stage: HtmlElement = find("stage");
        let stage_px = Vec2::new(stage.client_width() as f32, stage.client_height() as f32);
        let px: Vec<f32> = [stage_px].iter().chain(at_px).flat_map(|px| px.to_array()).collect();
        let goes_on = self.is_by_hand() || matches!(self.hand, Hand::Key);
        let points = if goes_on { self.stroke.points.clone() } else { vec![] };
        let words = Stroke { points, ..self.stroke.clone() }.write();
        let link = link::write(&painted::below(base));
        let px = Float32Array::from(&px[..]);
        work.wish([STROKE, &link, ""], Array::of2(&words.into(), &px.into()));
    }

    /// The workshop has said where it lies: as words. Of a pointer that has come down beside the plant, and so draws
    /// nothing, the event with which it came.
    pub fn hear(&mut self, words: &str) -> Option<PointerEvent> {
        if let Some(stroke) = Stroke::read(words) {
            self.stroke = stroke;
        }
        match std::mem::replace(&mut self.hand, Hand::Lifted) {
            Hand::New(_, event) if self.stroke.points.is_empty() => return Some(event),
            Hand::New(held, _) => self.hand = Hand::Down(held),
            hand => self.hand = hand,
        }
        None
    }

    /// What becomes of it now.
    pub fn go_on(&mut self, work: &Work, base: &'static Plant) -> Fate {
        if let Some(at_px) = self.waits.take() {
            self.ask(&at_px, work, base);
            return Fate::Asked;
        }
        match self.hand {
            Hand::New(..) | Hand::Down(_) => Fate::Open,
            _ if self.stroke.points.is_empty() => Fate::Nothing,
            Hand::Key if self.is_straight && self.stroke.points.len() == 1 => Fate::Begun,
            Hand::Key | Hand::Lifted => Fate::Done,
        }
    }
}
