//! The cells of a grid, against brute force over all cells.

use ask::Draw;
use serde_json::{Value, json};

use super::{ask, numbers};

/// A point nearer to a border than this share of a cell may be counted on either side of it.
const TIE: f64 = 1e-9;
/// How much the box of an object is enlarged, as a share of the longest cell side.
const PAD: f64 = 1.0 / 64.0;

type Box3 = [[f64; 3]; 2];

struct Case {
    boxes: Vec<Box3>,
    multiplier: f64,
    answer: Value,
}

/// Random boxes in a random block, with one box at each of two opposite corners of the block.
fn case(draw: &mut Draw) -> Case {
    let sides = [draw.between(0.5, 4.0), draw.between(0.5, 4.0), draw.between(0.5, 4.0)];
    let corner = draw.point(10.0).to_array();
    let at = |share: [f64; 3]| [0, 1, 2].map(|i| corner[i] + share[i] * sides[i]);
    let mut boxes = vec![[at([0.0; 3]), at([0.01; 3])], [at([0.99; 3]), at([1.0; 3])]];
    for _ in 0..draw.below(60) {
        let low = [0, 1, 2].map(|_| draw.between(0.0, 0.9));
        let high = low.map(|x| x + draw.between(0.0, 0.1));
        boxes.push([at(low), at(high)]);
    }
    let multiplier = draw.between(0.5, 3.0);
    let list: Vec<Value> = boxes.iter().map(|[min, max]| json!({"min": min, "max": max})).collect();
    let answer = ask(&json!({"grid": {"boxes": list, "multiplier": multiplier}}));
    Case { boxes, multiplier, answer }
}

fn whole(boxes: &[Box3]) -> Box3 {
    let end = |which: usize, better: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|i| boxes.iter().map(|b| b[which][i]).reduce(better).expect("some"))
    };
    [end(0, f64::min), end(1, f64::max)]
}

impl Case {
    fn resolution(&self) -> [usize; 3] {
        let found = numbers(&self.answer["resolution"]);
        [0, 1, 2].map(|i| found[i] as usize)
    }

    /// The corners of a cell, and its sides.
    fn cell(&self, cell: [usize; 3]) -> (Box3, [f64; 3]) {
        let ([min, max], counts) = (whole(&self.boxes), self.resolution());
        let sides = [0, 1, 2].map(|i| (max[i] - min[i]) / counts[i] as f64);
        let low = [0, 1, 2].map(|i| min[i] + cell[i] as f64 * sides[i]);
        ([low, [0, 1, 2].map(|i| low[i] + sides[i])], sides)
    }

    /// The objects whose enlarged boxes overlap the cell, by testing all; `None` near a tie.
    fn objects(&self, cell: [usize; 3]) -> Option<Vec<usize>> {
        let ([low, high], sides) = self.cell(cell);
        let longest = sides.into_iter().fold(0.0, f64::max);
        let mut inside = Vec::new();
        for (index, [min, max]) in self.boxes.iter().enumerate() {
            // the least overlap of the two boxes on any axis
            let overlap = (0..3)
                .map(|i| (max[i] + PAD * longest - low[i]).min(high[i] - (min[i] - PAD * longest)))
                .fold(f64::INFINITY, f64::min);
            if overlap.abs() < TIE * longest {
                return None;
            }
            if overlap > 0.0 {
                inside.push(index);
            }
        }
        Some(inside)
    }
}

/// Law: the objects of the requested cell are those of brute force. Objects are numbered as in the list,
/// including planes, which are in no cell. Oracle: the boxes, and a case worked out by hand.
#[test]
fn a_cell_holds_the_objects_that_overlap_it() {
    let mut draw = Draw::new(2263);
    for _ in 0..100 {
        let case = case(&mut draw);
        let counts = case.resolution();
        let cell = counts.map(|count| draw.below(count));
        let list: Vec<Value> =
            case.boxes.iter().map(|[min, max]| json!({"min": min, "max": max})).collect();
        let answer =
            ask(&json!({"grid": {"boxes": list, "multiplier": case.multiplier, "cell": cell}}));
        if let Some(objects) = case.objects(cell) {
            assert_eq!(answer["objects"], json!(objects));
        }
    }
    let ball = |x: f64| json!({"sphere": {"center": [x, 0, 0], "radius": 1}});
    let plane = json!({"plane": {"point": [0, -1, 0], "normal": [0, 1, 0]}});
    let answer =
        ask(&json!({"grid": {"shapes": [plane, ball(0.0), ball(9.0)], "cell": [0, 0, 0]}}));
    assert_eq!(answer["unbounded"], json!([0]));
    assert_eq!(answer["objects"], json!([1]));
    assert_eq!(numbers(&answer["min"]), [-1.0, -1.0, -1.0]);
    assert_eq!(numbers(&answer["max"]), [10.0, 1.0, 1.0]);
}

/// Law: boxes of any size and position get an answer, never a panic.
#[test]
fn extreme_boxes_get_an_answer() {
    let numbers = [0.0, 1.0, -1.0, 1e-310, 1e-40, 1e40, -1e155, 1e308, -1e308];
    let mut draw = Draw::new(2264);
    for _ in 0..2_000 {
        let mut corner = || [0, 1, 2].map(|_| draw.pick(&numbers));
        let boxes: Vec<Value> = (0..3)
            .map(|_| {
                let (a, b) = (corner(), corner());
                let end = |better: fn(f64, f64) -> f64| [0, 1, 2].map(|i| better(a[i], b[i]));
                json!({"min": end(f64::min), "max": end(f64::max)})
            })
            .collect();
        let ray = json!({"origin": corner(), "direction": [1, 1e-9, -0.5]});
        ask(&json!({"grid": {"boxes": boxes, "ray": ray}}));
    }
}
