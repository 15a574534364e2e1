//! Limits on the number of rays: glass at depth 100 may be a line of rays, or a tree of 2¹⁰⁰.

use std::sync::atomic::{AtomicBool, Ordering};

/// Decides whether a ray may be cast.
pub trait Budget {
    /// Counts a ray, also one that is too deep to be cast; `false` if it is one too many.
    fn spend(&mut self) -> bool;
}

/// No limit; costs nothing.
#[derive(Clone, Copy, Debug)]
pub struct Unlimited;

impl Budget for Unlimited {
    #[inline(always)]
    fn spend(&mut self) -> bool {
        true
    }
}

/// No limit until the flag is set; what is found then is incomplete.
#[derive(Clone, Copy, Debug)]
pub struct UntilStopped<'a>(pub &'a AtomicBool);

impl Budget for UntilStopped<'_> {
    #[inline(always)]
    fn spend(&mut self) -> bool {
        !self.0.load(Ordering::Relaxed)
    }
}

/// At most a number of rays. Shadow rays count, but are cast beyond it, too: they end by
/// themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RayBudget {
    most: u64,
    spent: u64,
}

/// Something takes more rays than fit.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{asked}: more than {most} rays; lower max_depth or the number of samples")]
pub struct TooManyRays {
    /// What was asked for.
    pub asked: String,
    /// The number of rays that fit.
    pub most: u64,
}

impl RayBudget {
    /// At most this many rays.
    pub fn up_to(most: u64) -> Self {
        Self { most, spent: 0 }
    }

    /// The number of rays so far.
    pub fn spent(&self) -> u64 {
        self.spent
    }

    /// Whether more rays were asked for, so that results are incomplete.
    pub fn is_exceeded(&self) -> bool {
        self.spent > self.most
    }

    /// Whether all rays fitted.
    ///
    /// # Errors
    /// If the budget is exceeded; `asked` names what it was for.
    pub fn check(&self, asked: impl FnOnce() -> String) -> Result<(), TooManyRays> {
        if self.is_exceeded() {
            return Err(TooManyRays { asked: asked(), most: self.most });
        }
        Ok(())
    }
}

impl Budget for RayBudget {
    fn spend(&mut self) -> bool {
        self.spent += 1;
        self.spent <= self.most
    }
}
