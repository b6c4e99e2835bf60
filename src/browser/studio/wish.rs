//! What the studio wishes of its workshop and its darkroom: an array of a word, a link, the packed mesh of its plant, and what
//! else the word needs. The word of a kind of file (`export::Kind`) needs the name of the file without its end.
//!
//! It is answered by numbers, how many days have grown; a text, why it cannot be; or an array, what was wanted:
//! of a file what it is in a few words, and its bytes.

/// The plant as JSON: a file.
pub const DOCUMENT: &str = "document";

/// Pixels, an `ImageData`, as a PNG: a file.
pub const PICTURE: &str = "picture";

/// The colours of a photograph, an `ImageData`: an array of the first cells that its patches need, and of each
/// colour its three parts in sRGB and its share.
pub const PHOTO: &str = "photo";

/// A plant of a file of the visitor's own, an array of its name and its bytes: its key, its text, and what was done
/// to it. In place of the mesh stands that which a document names, if one does.
pub const OWN: &str = "own";

/// Numbers that make what is wanted, as `mosaic fit --want` takes it: the tries so far as numbers, for each that is
/// better than all before an array of what came of it and its link, and at last an empty one.
pub const FIT: &str = "fit";
/// Tries of a search at most.
pub const MOST_TRIES: usize = 100;

/// The bytes of a file as the link that it holds.
pub const OPEN: &str = "open";

/// Days in numbers, all or the last so many, up to the day of the link: of each an array of its numbers
/// (`DayNumbers::to_row`), its fingerprint and how many leaves the plant has, and at last an empty one.
pub const NUMBERS: &str = "numbers";

/// One number of some individuals, how many and what: `12 share F`. An array with the number of each, and at last
/// an empty one.
pub const MEASURE: &str = "measure";

/// Of the darkroom: a film, an array of its words (`export::Film::written`) and of what it is staged on (`darkroom`).
/// The steps so far as numbers, days that have grown and then frames that were drawn: a file.
pub const FILM: &str = "film";

/// Of the darkroom: a large picture, an array of the word of its size (`export::SheetSize`), of what it is staged
/// on, and of what stands under it (`darkroom`). Steps are days and then tiles: a file.
pub const SHEET: &str = "sheet";

/// A body by rule, its words (`import::Made`) in the place of a link; needs the width and height of a picture, degrees
/// around and above, and the share of the days of a body that moves: what it is in a few words, and the pixels.
pub const SHAPE: &str = "shape";

/// The numbers of such a body: a file.
pub const SHAPE_NUMBERS: &str = "shape-numbers";

/// The plant of the words that stand behind the `~` of its link, in the place of that: of a body by rule, or of strokes
/// on the plant whose mesh is given. Its key, its text, and what is told of it.
pub const ANEW: &str = "anew";

/// To hold a plant ready to be painted on, its words without strokes in the place of a link (`import::Painted`): the
/// length that suits it, in centimetres.
pub const SKIN: &str = "skin";

/// Takes a stroke on the plant that is held ready on, as a link shows it. Needs the words of the stroke as far as it is
/// drawn, and pairs of numbers: width and height of the stage, and points on it, both in pixels (`import::Skin`). The
/// words of the longer one, the lines in which it is seen as elements of an SVG in pixels of the stage, and their width.
pub const STROKE: &str = "stroke";
