//! Student's t tests of means: is a mean what it should be, and do two means agree?
//!
//! For estimates, such as a pixel's value: take each from a replica of its own, seeded apart. The
//! samples of one stratified set are not independent, and their variance is no estimate of anything.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// The probability of a mean at least as far from `expected`, on either side, if the values are
/// independent and their mean is that: Student's t of `n − 1` degrees (Student 1908).
///
/// Exact for normal values. At level 1e-3, 16 uniform ones raise 1.7 times as many false alarms as they
/// should, 16 exponential ones 13 times, 256 of these 2.2 times, and lower levels more: if values are
/// skewed, take means of many as values. If all values are the same, only that value itself is
/// possible: 1 or 0. A value that is not finite gives 0; fewer than two give 1: nothing can be told.
///
/// Power: at level 1e-6, 98 times in 100 or more, a mean that is off by 3.3 standard deviations of
/// one value is found with 16 values, and by `7.2/√n` with `n` above 500.
pub fn one_sample(values: &[f64], expected: f64) -> f64 {
    if values.iter().any(|x| !x.is_finite()) || !expected.is_finite() {
        return 0.0;
    }
    if values.len() < 2 {
        return 1.0;
    }
    let (mean, square) = mean_and_its_variance(values);
    two_sided(mean - expected, square, values.len() as f64 - 1.0)
}

/// The probability of means at least as far apart, if the values are independent and both means the
/// same, whatever the variances (Welch, "The Generalization of 'Student's' Problem when Several
/// Different Population Variances are Involved", 1947).
///
/// The degrees of freedom are estimated: `(v + w)² / (v²/(m − 1) + w²/(n − 1))` of the variances of
/// both means. As for the rest see [`one_sample`].
///
/// Power: at level 1e-6, 98 times in 100 or more, means are told apart that are `7.2 √(v + w)` apart,
/// with 500 values each or more.
pub fn two_samples(a: &[f64], b: &[f64]) -> f64 {
    if a.iter().chain(b).any(|x| !x.is_finite()) {
        return 0.0;
    }
    if a.len() < 2 || b.len() < 2 {
        return 1.0;
    }
    let ((mean_a, v), (mean_b, w)) = (mean_and_its_variance(a), mean_and_its_variance(b));
    two_sided(mean_a - mean_b, v + w, freedom((v, a.len()), (w, b.len())))
}

/// The difference `mean(a) − mean(b)`, and an interval that contains the true one with this probability
/// (such as 0.95), whatever the variances (Welch 1947, as for [`two_samples`]). `None` with fewer than
/// two values on a side, or a value that is not finite.
pub fn difference(a: &[f64], b: &[f64], confidence: f64) -> Option<[f64; 3]> {
    if a.iter().chain(b).any(|x| !x.is_finite()) || a.len() < 2 || b.len() < 2 {
        return None;
    }
    let ((mean_a, v), (mean_b, w)) = (mean_and_its_variance(a), mean_and_its_variance(b));
    let apart = mean_a - mean_b;
    let half = match StudentsT::new(0.0, 1.0, freedom((v, a.len()), (w, b.len()))) {
        Ok(student) => student.inverse_cdf(0.5 + 0.5 * confidence) * (v + w).sqrt(),
        Err(_) => 0.0, // no variance
    };
    Some([apart, apart - half, apart + half])
}

/// The mean, and an interval that contains the true one with this probability (such as 0.95): Student's
/// t of `n − 1` degrees, as for [`one_sample`]. `None` for fewer than two values, or one that is not
/// finite.
pub fn interval(values: &[f64], confidence: f64) -> Option<[f64; 3]> {
    if values.iter().any(|x| !x.is_finite()) || values.len() < 2 {
        return None;
    }
    let (mean, square) = mean_and_its_variance(values);
    let student = StudentsT::new(0.0, 1.0, values.len() as f64 - 1.0).ok()?;
    let half = student.inverse_cdf(0.5 + 0.5 * confidence) * square.sqrt();
    Some([mean, mean - half, mean + half])
}

/// Welch's degrees of freedom for two means of these variances, from so many values each.
fn freedom((v, m): (f64, usize), (w, n): (f64, usize)) -> f64 {
    let share = |square: f64, values: usize| square * square / (values as f64 - 1.0);
    (v + w) * (v + w) / (share(v, m) + share(w, n))
}

/// The mean, and the variance of one as estimated by its values; exactly none if they are the same.
fn mean_and_its_variance(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    if values.iter().all(|x| *x == values[0]) {
        return (values[0], 0.0);
    }
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
    (mean, squares / (n - 1.0) / n)
}

/// The probability of a difference at least as large.
fn two_sided(difference: f64, variance: f64, freedom: f64) -> f64 {
    let t = difference.abs() / variance.sqrt();
    match StudentsT::new(0.0, 1.0, freedom) {
        Ok(student) if t.is_finite() => (2.0 * student.sf(t)).min(1.0),
        // no variance: only what is the same agrees
        _ => f64::from(u8::from(difference == 0.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::biased_samples::normals;
    use crate::verify::judge::{near, passes, rejects};
    use groundtruth::math::{Pcg32, atan2};
    use std::f64::consts::PI;

    /// Oracle: by hand. 1 … 4 have the mean 2.5 and the variance 5/3, so that 1 is t = 1.5/√(5/12) off;
    /// three degrees have a closed form, and so have two: `½ + t/(2√(2 + t²))`.
    #[test]
    fn they_have_the_values_found_by_hand() {
        let p = one_sample(&[1.0, 2.0, 3.0, 4.0], 1.0);
        let s = 1.5 / (5.0_f64 / 12.0).sqrt() / 3.0_f64.sqrt(); // t/√3
        let below = 0.5 + (atan2(s, 1.0) + s / (1.0 + s * s)) / PI;
        near(p, 2.0 * (1.0 - below), 1e-12);
        // equal counts and variances: 2 (n − 1) degrees, here two; both means have the variance ½/2
        let p = two_samples(&[0.0, 1.0], &[2.0, 3.0]);
        let t = 2.0 / 0.5_f64.sqrt();
        near(p, 1.0 - t / (2.0 + t * t).sqrt(), 1e-12);
        // one side without variance: the degrees are those of the other
        let p = two_samples(&[1.0, 1.0, 1.0], &[1.0, 2.0, 3.0, 4.0]);
        near(p, one_sample(&[1.0, 2.0, 3.0, 4.0], 1.0), 1e-12);
    }

    #[test]
    fn they_pass_the_truth_and_find_an_error_just_above_their_power() {
        for seed in 0..8 {
            let random = &mut Pcg32::new(seed, 6);
            for (n, smallest) in [(16, 3.3), (2500, 7.2 / 50.0)] {
                let values = normals(n, 5.0, 2.0, random);
                passes(one_sample(&values, 5.0));
                rejects(one_sample(&values, 5.0 + 1.1 * 2.0 * smallest));
            }
            let (a, b) = (normals(500, 1.0, 3.0, random), normals(2000, 1.0, 1.0, random));
            passes(two_samples(&a, &b));
            let apart = 7.2 * (9.0 / 500.0 + 1.0 / 2000.0_f64).sqrt();
            let moved: Vec<f64> = b.iter().map(|x| x + 1.1 * apart).collect();
            rejects(two_samples(&a, &moved));
        }
    }

    /// Law: the interval of a difference ends where the test of equal means has the probability
    /// 1 − confidence. Oracle: by hand, as above: two degrees, variance ½, `t = √2 c/√(1 − c²)` is the
    /// quantile whose two sides leave 1 − c; and the test of means moved by the interval's end.
    #[test]
    fn the_interval_of_a_difference_is_that_found_by_hand() {
        let c: f64 = 0.9;
        let [apart, low, high] = difference(&[0.0, 1.0], &[2.0, 3.0], c).expect("two and two");
        let half = (2.0 * c * c / (1.0 - c * c)).sqrt() * 0.5_f64.sqrt();
        near(apart, -2.0, 1e-15);
        near(low, apart - half, 1e-9);
        near(high, apart + half, 1e-9);
        let random = &mut Pcg32::new(4, 6);
        let (a, b) = (normals(5, 1.0, 3.0, random), normals(9, 1.5, 1.0, random));
        let [_, low, high] = difference(&a, &b, c).expect("values");
        for end in [low, high] {
            let moved: Vec<f64> = b.iter().map(|x| x + end).collect();
            near(two_samples(&a, &moved), 1.0 - c, 1e-9);
        }
        let [mean, low, high] = interval(&[1.0, 2.0, 3.0], c).expect("three values");
        let half = (2.0 * c * c / (1.0 - c * c)).sqrt() / 3.0_f64.sqrt();
        assert_eq!(mean, 2.0);
        near(low, 2.0 - half, 1e-9);
        near(high, 2.0 + half, 1e-9);
        assert_eq!(interval(&[1.0], c), None);
        assert_eq!(difference(&[1.0, 1.0], &[3.0, 3.0], c), Some([-2.0; 3]));
        assert_eq!(difference(&[1.0], &[3.0, 3.0], c), None);
    }

    #[test]
    fn constants_and_what_is_no_number_are_judged_exactly() {
        assert_eq!(one_sample(&[0.1; 7], 0.1), 1.0);
        assert_eq!(one_sample(&[0.1; 7], 0.1 + 1e-16), 0.0);
        assert_eq!(two_samples(&[0.1; 7], &[0.1; 3]), 1.0);
        assert_eq!(two_samples(&[0.1; 7], &[0.2; 3]), 0.0);
        assert_eq!(one_sample(&[1.0, f64::NAN, 2.0], 1.5), 0.0);
        assert_eq!(one_sample(&[1.0], 100.0), 1.0);
    }
}
