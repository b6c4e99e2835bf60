//! What `mosaic fit` is asked for.

use super::{FIRST_PLANT, Source, from_one_to, presets, whole};
use clap::Args;

#[derive(Args)]
pub struct FitOptions {
    #[command(flatten)]
    source: FitSource,
    /// The day to grow to; without it the link's day, or all days of the plant
    #[arg(long, value_name = "D", value_parser = whole, allow_negative_numbers = true)]
    pub day: Option<u32>,
    /// What is wanted of that day: measures as in lessons, of F where no type is named; shares from 0 to 1
    #[arg(long, value_name = "share=0.4,patches-B=200")]
    pub want: String,
    /// The numbers that may change, by their words in links; without it those that decide most
    #[arg(long, value_name = "pf,n,fb")]
    pub vary: Option<String>,
    /// Each try is the mean of so many individuals
    #[arg(
        long, value_name = "N", default_value = "2",
        value_parser = from_one_to::<1000>, allow_negative_numbers = true
    )]
    pub individuals: u32,
    /// Tries at most
    #[arg(
        long, value_name = "N", default_value = "100",
        value_parser = from_one_to::<100_000>, allow_negative_numbers = true
    )]
    pub tries: u32,
}

/// Which plant: one of them, or the croton.
#[derive(Args)]
#[group(multiple = false)]
struct FitSource {
    /// The plant and the numbers of a playground link, or of the part after its #
    #[arg(long, value_name = "TEXT")]
    link: Option<String>,
    #[arg(long, value_name = "NAME", help = presets())]
    preset: Option<String>,
}

impl FitOptions {
    pub fn source(&self) -> Source<'_> {
        match &self.source {
            FitSource { link: Some(text), .. } => Source::Link(text),
            FitSource { preset, .. } => Source::Preset(preset.as_deref().unwrap_or(FIRST_PLANT)),
        }
    }
}
