//! What page and worker say to each other, and how it is written in 32-bit words. The worker speaks
//! first, with its version; then the page asks for growths, and the worker answers day by day.

use super::run::DayFacts;
use crate::mosaic::{Head, Site, SiteLists};
use crate::tissue::DayCount;

/// The build that page and worker must share: a hash of all sources.
pub const BUILD: &str = env!("MOSAIC_BUILD");

/// From the page to the worker.
#[derive(Clone, Debug, PartialEq)]
pub enum ToWorker {
    /// What stands in a mesh file: comes before the first wish that needs it.
    Mesh { name: String, text: String },
    /// Grow the scene of a link; whatever grew before stops. Every answer carries the number. One day is told first,
    /// the others after it in their order.
    Grow { generation: u32, first: u32, link: String },
    /// Tell this day of what grows before the others.
    First { day: u32 },
    /// Grow no further.
    Stop,
}

/// From the worker to the page.
#[derive(Clone, Debug, PartialEq)]
pub enum ToPage {
    /// The worker listens; `build` is its own `BUILD`.
    Hello {
        build: String,
    },
    /// Another day has grown, and so many were born: see `Pedigree::news`. It is told later what is to be drawn of it.
    Born {
        generation: u32,
        born: Vec<u32>,
    },
    Day(DayNews),
    /// The population reached its cap: no further day comes.
    Full {
        generation: u32,
    },
    /// All days have grown.
    Done {
        generation: u32,
    },
    /// The growth cannot go on; the text is for the visitor.
    Failed {
        generation: u32,
        text: String,
    },
}

/// A day that has grown.
#[derive(Clone, Debug, PartialEq)]
pub struct DayNews {
    pub generation: u32,
    pub day: u32,
    pub facts: DayFacts,
    /// What is drawn of the day.
    pub lists: SiteLists,
    /// The cell of each site of the lists.
    pub cell_of: Vec<u32>,
}

/// Why words are no message.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a message between page and worker is not readable")]
pub struct ProtocolError;

const GROW: u32 = 1;
const HELLO: u32 = 2;
const DAY: u32 = 3;
const FULL: u32 = 4;
const DONE: u32 = 5;
const FAILED: u32 = 6;
const MESH: u32 = 7;
const STOP: u32 = 8;
const FIRST: u32 = 9;
const BORN: u32 = 10;

impl ToWorker {
    pub fn to_words(&self) -> Vec<u32> {
        let mut words;
        match self {
            ToWorker::Mesh { name, text } => {
                words = vec![MESH];
                push_text(&mut words, name);
                push_text(&mut words, text);
            }
            ToWorker::Grow { generation, first, link } => {
                words = vec![GROW, *generation, *first];
                push_text(&mut words, link);
            }
            ToWorker::First { day } => words = vec![FIRST, *day],
            ToWorker::Stop => words = vec![STOP],
        }
        words
    }

    pub fn from_words(words: &[u32]) -> Result<ToWorker, ProtocolError> {
        let mut reader = Reader(words);
        let message = match reader.word()? {
            MESH => ToWorker::Mesh { name: reader.text()?, text: reader.text()? },
            GROW => ToWorker::Grow {
                generation: reader.word()?,
                first: reader.word()?,
                link: reader.text()?,
            },
            FIRST => ToWorker::First { day: reader.word()? },
            STOP => ToWorker::Stop,
            _ => return Err(ProtocolError),
        };
        reader.end(message)
    }
}

impl ToPage {
    pub fn to_words(&self) -> Vec<u32> {
        match self {
            ToPage::Hello { build } => {
                let mut words = vec![HELLO];
                push_text(&mut words, build);
                words
            }
            ToPage::Born { generation, born } => {
                [&[BORN, *generation, born.len() as u32], &born[..]].concat()
            }
            ToPage::Day(DayNews { generation, day, facts, lists, cell_of }) => {
                let (heads, sites) = (words_of(&lists.heads), words_of(&lists.sites));
                let parts = [heads, sites, cell_of];
                let whole: usize = parts.iter().map(|part| part.len()).sum();
                let mut words = Vec::with_capacity(18 + whole);
                words.extend([DAY, *generation, *day, facts.count.cells]);
                words.extend(facts.count.by_type);
                words.extend(facts.areas);
                push_text(&mut words, &facts.fingerprint);
                for part in parts {
                    words.push(part.len() as u32);
                    words.extend_from_slice(part);
                }
                words
            }
            ToPage::Full { generation } => vec![FULL, *generation],
            ToPage::Done { generation } => vec![DONE, *generation],
            ToPage::Failed { generation, text } => {
                let mut words = vec![FAILED, *generation];
                push_text(&mut words, text);
                words
            }
        }
    }

    pub fn from_words(words: &[u32]) -> Result<ToPage, ProtocolError> {
        let mut reader = Reader(words);
        let message = match reader.word()? {
            HELLO => ToPage::Hello { build: reader.text()? },
            BORN => ToPage::Born { generation: reader.word()?, born: reader.records()? },
            DAY => ToPage::Day(reader.day()?),
            FULL => ToPage::Full { generation: reader.word()? },
            DONE => ToPage::Done { generation: reader.word()? },
            FAILED => ToPage::Failed { generation: reader.word()?, text: reader.text()? },
            _ => return Err(ProtocolError),
        };
        reader.end(message)
    }
}

/// A text is its length in bytes and its bytes, four to a word.
fn push_text(words: &mut Vec<u32>, text: &str) {
    words.push(text.len() as u32);
    words.extend(text.as_bytes().chunks(4).map(|four| {
        let mut bytes = [0; 4];
        bytes[..four.len()].copy_from_slice(four);
        u32::from_le_bytes(bytes)
    }));
}

fn words_of<T: bytemuck::Pod>(records: &[T]) -> &[u32] {
    bytemuck::cast_slice(records)
}

struct Reader<'a>(&'a [u32]);

impl<'a> Reader<'a> {
    fn word(&mut self) -> Result<u32, ProtocolError> {
        Ok(self.words(1)?[0])
    }

    fn words(&mut self, count: usize) -> Result<&'a [u32], ProtocolError> {
        let (head, rest) = self.0.split_at_checked(count).ok_or(ProtocolError)?;
        self.0 = rest;
        Ok(head)
    }

    fn three(&mut self) -> Result<[u32; 3], ProtocolError> {
        Ok([self.word()?, self.word()?, self.word()?])
    }

    fn text(&mut self) -> Result<String, ProtocolError> {
        let length = self.word()? as usize;
        let words = self.words(length.div_ceil(4))?;
        let mut bytes: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).collect();
        bytes.truncate(length);
        String::from_utf8(bytes).map_err(|_| ProtocolError)
    }

    fn day(&mut self) -> Result<DayNews, ProtocolError> {
        let (generation, day) = (self.word()?, self.word()?);
        let cells = self.word()?;
        let by_type = self.three()?;
        let areas = self.three()?;
        let fingerprint = self.text()?;
        let heads: Vec<Head> = self.records()?;
        let sites: Vec<Site> = self.records()?;
        let facts = DayFacts { count: DayCount { cells, by_type }, areas, fingerprint };
        let lists = SiteLists { heads, sites };
        Ok(DayNews { generation, day, facts, lists, cell_of: self.records()? })
    }

    fn records<T: bytemuck::Pod>(&mut self) -> Result<Vec<T>, ProtocolError> {
        let length = self.word()? as usize;
        let words = self.words(length)?;
        bytemuck::try_cast_slice(words).map(<[T]>::to_vec).map_err(|_| ProtocolError)
    }

    fn end<T>(&self, message: T) -> Result<T, ProtocolError> {
        if self.0.is_empty() { Ok(message) } else { Err(ProtocolError) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answers() -> Vec<ToPage> {
        let count = DayCount { cells: 2, by_type: [0, 2, 0] };
        let head = Head { first: 0, count: 2, scale_cm: 0.125, unused: 0 };
        let site = |word| Site { words: [word, word + 1] };
        vec![
            ToPage::Hello { build: "ünïcode 123".to_string() },
            ToPage::Day(DayNews {
                generation: 7,
                day: 3,
                facts: DayFacts {
                    count,
                    areas: [0, 9_000, 1_000],
                    fingerprint: "k3v9qa".to_string(),
                },
                lists: SiteLists { heads: vec![head], sites: vec![site(5), site(u32::MAX - 1)] },
                cell_of: vec![0, 1],
            }),
            ToPage::Born { generation: 7, born: vec![1, 1 << 30] },
            ToPage::Full { generation: 1 },
            ToPage::Done { generation: 2 },
            ToPage::Failed { generation: 3, text: String::new() },
        ]
    }

    #[test]
    fn messages_come_back() {
        for message in answers() {
            assert_eq!(ToPage::from_words(&message.to_words()), Ok(message));
        }
        for wish in [
            ToWorker::Mesh { name: "leaf.obj".to_string(), text: "f 1 2 3".to_string() },
            ToWorker::Grow { generation: 4, first: 3, link: "leaf?v=1&s=2&d=3".to_string() },
            ToWorker::First { day: 5 },
            ToWorker::Stop,
        ] {
            assert_eq!(ToWorker::from_words(&wish.to_words()), Ok(wish));
        }
    }

    #[test]
    fn anything_else_is_refused() {
        for message in answers() {
            let words = message.to_words();
            for cut in 0..words.len() {
                assert_eq!(ToPage::from_words(&words[..cut]), Err(ProtocolError));
            }
            assert_eq!(ToPage::from_words(&[&words[..], &[0]].concat()), Err(ProtocolError));
        }
        assert_eq!(ToPage::from_words(&[99]), Err(ProtocolError));
        assert_eq!(ToPage::from_words(&[HELLO, u32::MAX]), Err(ProtocolError));
        let endless = [DAY, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, u32::MAX];
        assert_eq!(ToPage::from_words(&endless), Err(ProtocolError));
        let half_a_site = [DAY, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 5];
        assert_eq!(ToPage::from_words(&half_a_site), Err(ProtocolError));
    }
}
