//! Languages that prose is written in.

#[cfg(feature = "documents")]
use crate::planner::Wording;

/// Language of a note or message.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Chinese, simplified.
    Chinese,
}

impl Language {
    /// The words in this language.
    #[cfg(feature = "documents")]
    pub(in crate::render) fn of(self, wording: Wording) -> &'static str {
        match self {
            Language::English => wording.english,
            Language::Chinese => wording.chinese,
        }
    }

    /// Language tag.
    pub fn tag(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Chinese => "zh",
        }
    }
}
