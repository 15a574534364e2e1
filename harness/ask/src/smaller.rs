//! Smaller cases.

/// The smallest case that can be reached: of the simpler ones, the simplest first, that which is `kept` takes the place of the
/// best, until none is; or until `kept` has nothing more to say.
pub fn smallest<Best, Case>(
    mut best: Best,
    simpler: impl Fn(&Best) -> Vec<Case>,
    mut kept: impl FnMut(&Best, Case) -> Option<Option<Best>>,
) -> Best {
    'again: loop {
        for case in simpler(&best) {
            match kept(&best, case) {
                None => return best,
                Some(None) => {}
                Some(Some(smaller)) => {
                    best = smaller;
                    continue 'again;
                }
            }
        }
        return best;
    }
}

/// Numbers that are simpler than this one: 0, 1, −1, whole ones near to it, and itself with fewer decimals.
pub fn simpler(x: f64) -> impl Iterator<Item = f64> {
    let simple = [0.0, 1.0, -1.0, x.trunc(), x.round()].into_iter();
    let decimals = [10.0, 100.0, 1000.0].into_iter().map(move |scale| (x * scale).round() / scale);
    simple.chain(decimals).filter(move |y| weight(*y) < weight(x))
}

/// How much of a number there is to read: nothing of 0, then ±1, then its digits.
pub fn weight(x: f64) -> u32 {
    match x {
        0.0 => 0,
        1.0 => 1,
        -1.0 => 2,
        x => 2 + format!("{x}").len() as u32,
    }
}
