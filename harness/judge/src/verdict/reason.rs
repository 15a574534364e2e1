//! Why a picture differs: a harmless change or a known mistake.

use pictures::compare::Picture;

use super::attempt::Judge;
use super::causes::Inquiry;
use super::plausible::readings;
use super::{Case, Causes, Evaluation, Explanation, Replicas, Stored};

/// Why a picture differs.
#[derive(Default)]
pub(super) struct Reason {
    pub explained: Option<Explanation>,
    pub causes: Causes,
    /// How the picture's values are stored, if what explains it says so.
    pub way: Option<Stored>,
    /// Whether nothing else says how they encode radiance.
    pub is_guessed: bool,
}

impl Reason {
    /// A complete explanation replaces a partial one.
    fn settled(mut self) -> Self {
        let agrees = self.explained.as_ref().is_some_and(|it| it.agrees);
        if agrees {
            (self.causes.nearest, self.causes.place) = (None, None);
        } else if !self.causes.explained_by.is_empty() {
            self.explained = None;
        }
        self.is_guessed &= !agrees && self.causes.explained_by.is_empty();
        self
    }
}

impl Judge<'_> {
    /// Why a picture differs from our replicas, as it was judged.
    pub fn reason(
        &self,
        theirs: &Picture,
        replicas: &mut Replicas<'_, '_>,
        judged: &Evaluation,
    ) -> Reason {
        let stored = judged.pool.stored;
        let candidates = self.candidates(theirs);
        let mut ways = readings(&candidates, theirs, &replicas.films, self.areas);
        let mut reason = Reason { is_guessed: ways.len() > 1, ..Reason::default() };
        // the likeliest first
        ways.sort_by_key(|way| way.transfer() != stored.transfer());
        let alike = self.alike_in_all_pixels(theirs, replicas, stored);
        let explained =
            alike.map(|it| (it, stored)).or_else(|| self.explained(theirs, replicas, &ways));
        if (self.is_over)() {
            reason.causes.is_unfinished = true;
            return reason;
        }
        if let Some((explanation, way)) = explained {
            let is_harmless = explanation.agrees && !explanation.is_gain;
            reason.way = explanation.agrees.then_some(way);
            reason.explained = Some(explanation);
            if is_harmless {
                return reason.settled();
            }
        }
        let mut scene = self.scene.clone();
        scene.image.sampler = replicas.world.image.sampler.clone();
        let judge = Judge { case: Case { scene: &scene, ..self.case }, ..*self };
        let (causes, way) = Inquiry { judge, theirs, replicas, judged }.causes(&ways);
        reason.way = if causes.explained_by.is_empty() { reason.way.or(way) } else { way };
        reason.causes = causes;
        reason.settled()
    }
}
