use super::{LawReport, RayLaw};
use crate::traced::Traced;
use text::digits::short;

pub const LAW: RayLaw = RayLaw {
    name: "mis-weights",
    says: "the MIS weights of the two ways to draw a direction are 1 together: pdf / (pdf + other_pdf), or the same of their squares",
    needs: &["mis", "pdf", "other_pdf"],
    causes: &[
        "the weights of the two ways are exchanged",
        "a direction that only one way can draw is weighted all the same",
        "the weight is 1/2, whatever the densities",
    ],
    check,
};

fn check(traced: &Traced, asked: &mut LawReport) {
    let tolerance = 4.0 * traced.tolerance();
    let told = || {
        traced.log.rays.iter().enumerate().filter_map(|(index, ray)| {
            let factors = &ray.factors;
            let (mis, own, other) = (factors.mis?, factors.pdf?, factors.other_pdf?);
            (mis.is_finite() && own.is_finite() && other.is_finite() && own > 0.0)
                .then_some((index, mis, own, other))
        })
    };
    let balance = |own: f64, other: f64| own / (own + other);
    let power = |own: f64, other: f64| balance(own * own, other * other);
    let near = |a: f64, b: f64| (a - b).abs() <= tolerance;
    let fits = |heuristic: &dyn Fn(f64, f64) -> f64| {
        told().filter(|(_, mis, own, other)| near(*mis, heuristic(*own, *other))).count()
    };
    let is_power = fits(&power) > fits(&balance);
    let heuristic = |own, other| if is_power { power(own, other) } else { balance(own, other) };
    for (index, mis, own, other) in told() {
        let expected = heuristic(own, other);
        asked.count(index, near(mis, expected), || {
            let causes = [near(mis, 1.0 - expected), other == 0.0, near(mis, 0.5)];
            let name = if is_power { "power" } else { "balance" };
            (
                format!(
                    "has the MIS weight {}, where its densities give {} ({name} heuristic)",
                    short(mis),
                    short(expected)
                ),
                causes,
            )
        });
    }
}
