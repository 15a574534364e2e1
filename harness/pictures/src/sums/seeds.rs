//! Sets of seeds, as ranges.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Seeds: ascending ranges `[first, last]` with a gap between each two.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(into = "Vec<[u64; 2]>", try_from = "Vec<[u64; 2]>")]
pub struct Seeds(Vec<[u64; 2]>);

/// As first seed and number of seeds.
impl From<Seeds> for Vec<[u64; 2]> {
    fn from(seeds: Seeds) -> Self {
        seeds.ranges().collect()
    }
}

impl TryFrom<Vec<[u64; 2]>> for Seeds {
    type Error = &'static str;

    fn try_from(ranges: Vec<[u64; 2]>) -> Result<Self, Self::Error> {
        let ranges: Option<Vec<Self>> =
            ranges.into_iter().map(|[first, count]| Self::range(first, count)).collect();
        let all = ranges.ok_or("seeds do not fit in 64 bits")?;
        Ok(all.iter().fold(Self::default(), |all, range| all.union(range)))
    }
}

impl Seeds {
    /// `count` seeds from `first` on; `None` if one of them would be `u64::MAX` or more.
    pub fn range(first: u64, count: u64) -> Option<Self> {
        let end = first.checked_add(count)?;
        Some(Self(if count == 0 { Vec::new() } else { vec![[first, end - 1]] }))
    }

    /// How many there are.
    pub fn count(&self) -> u64 {
        self.0.iter().map(|[first, last]| last - first + 1).sum()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The ranges, as first seed and number of seeds.
    pub fn ranges(&self) -> impl Iterator<Item = [u64; 2]> {
        self.0.iter().map(|[first, last]| [*first, last - first + 1])
    }

    /// All seeds, ascending.
    pub fn iter(&self) -> impl Iterator<Item = u64> {
        self.0.iter().flat_map(|[first, last]| *first..=*last)
    }

    /// The seeds of either.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let mut all = [self.0.as_slice(), &other.0].concat();
        all.sort_unstable();
        let mut joined: Vec<[u64; 2]> = Vec::new();
        for [first, last] in all {
            match joined.last_mut() {
                Some(before) if first <= before[1].saturating_add(1) => {
                    before[1] = before[1].max(last);
                }
                _ => joined.push([first, last]),
            }
        }
        Self(joined)
    }

    /// The seeds of both.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        let pairs = self.0.iter().flat_map(|a| other.0.iter().map(move |b| (a, b)));
        let common = pairs.map(|(a, b)| [a[0].max(b[0]), a[1].min(b[1])]);
        Self(common.filter(|[first, last]| first <= last).collect())
    }

    /// The seeds of this set that `other` has not.
    #[must_use]
    pub fn without(&self, other: &Self) -> Self {
        let mut left = Vec::new();
        for &[mut first, last] in &self.0 {
            let mut is_whole = false;
            for &[start, end] in &other.0 {
                if end < first || start > last {
                    continue;
                }
                if start > first {
                    left.push([first, start - 1]);
                }
                is_whole = end >= last;
                if is_whole {
                    break;
                }
                first = end + 1;
            }
            if !is_whole {
                left.push([first, last]);
            }
        }
        Self(left)
    }

    /// `1 to 10, 12`.
    pub fn list(&self) -> String {
        let text = |&[first, last]: &[u64; 2]| match first == last {
            true => first.to_string(),
            false => format!("{first} to {last}"),
        };
        self.0.iter().map(text).collect::<Vec<_>>().join(", ")
    }
}

/// `seeds 1 to 10, 12`.
impl fmt::Display for Seeds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", if self.count() == 1 { "seed" } else { "seeds" }, self.list())
    }
}
