//! Labels and the legend of plots have their places.

use groundtruth::math::{Pcg32, power};
use report::plot::*;

use super::plots::{Drawn, PIXEL, X, Y, number, places, plot, random};

/// Law: series without a line are points alone; a series has as many labels as it is given, in its colour, beside their points, and
/// those of points at one place do not overlap, however many. Oracle: distances of the printed places.
#[test]
fn labels_stand_beside_their_points() {
    let labels: Vec<String> = (0..5).map(|k| format!("label {k}")).collect();
    let one = |points: Vec<(f64, f64)>| Series {
        name: "s".to_owned(),
        points,
        labels: labels.clone(),
        ..Series::default()
    };
    let same = one(vec![(10.0, 10.0); 5]);
    let frame = Series {
        name: "f".to_owned(),
        points: vec![(1.0, 1.0), (100.0, 100.0)],
        ..Series::default()
    };
    let drawn = Drawn::of(&plot(vec![same, frame.clone()], None));
    let beside = |drawn: &Drawn| -> Vec<[f64; 2]> {
        let found = drawn.words.iter().filter(|it| it.text.starts_with("label "));
        found
            .map(|it| {
                assert!(it.size < 10.0 && it.color == "#000000", "size and colour of a label");
                it.at
            })
            .collect()
    };
    let found = beside(&drawn);
    assert_eq!(found.len(), 5, "labels");
    let point = drawn.markers()[0].1;
    for (k, a) in found.iter().enumerate() {
        let way = [(a[0] - point[0]).abs(), (a[1] - point[1]).abs()];
        assert!(way[0] <= 17.0 && way[1] <= 31.0, "a label {way:?} from its point");
        for b in &found[..k] {
            let apart = (a[0] - b[0]).abs() > 12.0 || (a[1] - b[1]).abs() > 10.0;
            assert!(apart, "labels at {a:?} and {b:?}");
        }
    }
    let many: Vec<String> = (0..20).map(|k| format!("label {k}")).collect();
    let many = Series { labels: many, ..one(vec![(10.0, 10.0); 20]) };
    let all = beside(&Drawn::of(&plot(vec![many, frame.clone()], None)));
    assert_eq!((all.len(), &all[..5]), (20, &found[..]), "labels");
    for (k, a) in all.iter().enumerate() {
        for b in &all[..k] {
            let apart = (a[0] - b[0]).abs() > 12.0 || (a[1] - b[1]).abs() > 10.0;
            assert!(apart, "labels at {a:?} and {b:?}");
        }
    }
    let lines = drawn.svg.lines().filter(|it| it.starts_with("<polyline") && places(it).len() > 2);
    assert!(
        lines.clone().all(|it| it.contains("stroke-width=\"2\"")),
        "only outlines have corners"
    );
    // far from each other, all stand above to the right
    let apart =
        one((0..5).map(|k| (power(10.0, f64::from(k)), power(10.0, f64::from(k % 3)))).collect());
    let drawn = Drawn::of(&plot(vec![apart], None));
    for (label, marker) in beside(&drawn).iter().zip(drawn.markers()) {
        let way = [label[0] - marker.1[0], label[1] - marker.1[1]];
        assert_eq!(way, [6.0, -12.0], "the way from a point to its label");
    }
    // of points that are not at one place, labels do not overlap either
    let mut numbers = Pcg32::new(7, 9);
    for _ in 0..200 {
        let point = |_| (10.0 + 1.5 * numbers.uniform(), 10.0 + 2.0 * numbers.uniform());
        let three = Series { labels: labels[..3].to_vec(), ..one([0; 3].map(point).to_vec()) };
        let found = beside(&Drawn::of(&plot(vec![three, frame.clone()], None)));
        for (k, a) in found.iter().enumerate() {
            for b in &found[..k] {
                // a point is rounded to a pixel
                let apart = (a[0] - b[0]).abs() > 12.0 - 2.0 * PIXEL
                    || (a[1] - b[1]).abs() > 10.0 - 2.0 * PIXEL;
                assert!(apart, "labels at {a:?} and {b:?}");
            }
        }
    }
    // near to each other across, or up, but not both, they do not hide each other
    for (dx, dy) in [(1.0, 2.0), (1.5, 1.0)] {
        let (far, near) = ((10.0, 10.0), (10.0 * dx, 10.0 * dy));
        let two = Series { labels: labels[..2].to_vec(), ..one(vec![far, near]) };
        let drawn = Drawn::of(&plot(vec![two, frame.clone()], None));
        let ways: Vec<[f64; 2]> = beside(&drawn)
            .iter()
            .zip(drawn.markers())
            .map(|(label, marker)| [label[0] - marker.1[0], label[1] - marker.1[1]])
            .collect();
        assert_eq!(ways, [[6.0, -12.0]; 2], "the ways to labels of points apart by {dx}, {dy}");
    }
}

/// Law: the legend stands in the corner with the fewest points: in 35 % of the width, and 5 % and 6 % for each line of the height.
/// Oracle: points counted on the picture; a tie is not judged.
#[test]
fn the_legend_stands_where_the_fewest_points_are() {
    let mut numbers = Pcg32::new(4, 9);
    let mut seen = [0; 4];
    for case in 0..400_usize {
        let count = 1 + case % 4;
        let series: Vec<Series> = (0..count)
            .map(|k| {
                let points = (0..12)
                    .map(|_| (random(&mut numbers, [0.0, 3.0]), random(&mut numbers, [0.0, 3.0])));
                let points: Vec<(f64, f64)> = points.collect();
                Series { name: format!("name {k}"), points, ..Series::default() }
            })
            .collect();
        let drawn = Drawn::of(&plot(series, None));
        let high = 0.05 + 0.06 * count as f64;
        let shares: Vec<[f64; 2]> = drawn
            .markers()
            .iter()
            .map(|it| [(it.1[0] - X[0]) / (X[1] - X[0]), (it.1[1] - Y[0]) / (Y[1] - Y[0])])
            .collect();
        // a pixel beside the border may be on its other side
        let is_clear = shares.iter().all(|[x, y]| {
            [0.35, 0.65].iter().all(|it| (x - it).abs() > 0.005)
                && [high, 1.0 - high].iter().all(|it| (y - it).abs() > 0.008)
        });
        let corners = [(true, true), (false, true), (false, false), (true, false)];
        let counts = corners.map(|(left, upper)| {
            let is_here = |[x, y]: &&[f64; 2]| {
                (if left { *x < 0.35 } else { *x > 0.65 })
                    && (if upper { *y > 1.0 - high } else { *y < high })
            };
            shares.iter().filter(is_here).count()
        });
        let least = counts.iter().min().copied().unwrap_or(0);
        if !is_clear || counts.iter().filter(|it| **it == least).count() > 1 {
            continue;
        }
        let legend = drawn.svg.lines().find(|it| it.starts_with("<rect")).expect("a legend");
        let middle = [
            number(legend, "x") + 0.5 * number(legend, "width"),
            number(legend, "y") + 0.5 * number(legend, "height"),
        ];
        let found = (middle[0] < 0.5 * (X[0] + X[1]), middle[1] < 0.5 * (Y[0] + Y[1]));
        let expected = counts.iter().position(|it| *it == least).unwrap_or(0);
        assert_eq!(
            found, corners[expected],
            "left and upper of the legend, {counts:?} points in corners"
        );
        seen[expected] += 1;
    }
    assert!(seen.iter().all(|n| *n > 3), "legends in each corner: {seen:?}");
}
