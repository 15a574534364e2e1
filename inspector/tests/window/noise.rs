//! A noisy pixel: its paths, its largest samples, and what each light and each lobe adds.

use egui_kittest::kittest::Queryable;
use explain::{PixelExplanation, RecordedRay, RecordedTerm};
use groundtruth::scene::Scene;
use groundtruth::trace::RayKind;

use crate::support::*;

const ON_THE_BACK_WALL: [u32; 2] = [14, 10];

/// The Cornell box in few pixels.
fn small_cornell_box() -> Scene {
    small("ch26/cornell-box", [24, 24], 16)
}

/// A window on a pixel of the box, and the library's explanation of it.
fn noisy_pixel() -> (Window, PixelExplanation) {
    let mut window = open(small_cornell_box());
    click(&mut window, ON_THE_BACK_WALL);
    let scene = small_cornell_box();
    (window, explain::pixel(&scene, &built(&scene), ON_THE_BACK_WALL, None).expect("few rays"))
}

/// The continuing rays of a path, each with the term that receives its light, and the path's shadow rays.
fn path_of(root: &RecordedRay) -> (Vec<(&RecordedRay, Option<&RecordedTerm>)>, Vec<&RecordedRay>) {
    let (mut bounces, mut shadows) = (vec![(root, None)], Vec::new());
    while let Some((hit, _)) = bounces.last().copied() {
        let mut next = None;
        for child in &hit.children {
            match child.kind {
                RayKind::Shadow { .. } => shadows.push(child),
                _ => next = Some(child),
            }
        }
        let Some(ray) = next else { return (bounces, shadows) };
        bounces.push((ray, hit.terms.iter().find(|term| term.ray == Some(ray.number))));
    }
    (bounces, shadows)
}

/// Law: the bounces of a path are listed one below the other with the same indentation; shadow rays are
/// indented more. Beside each bounce are its weight and how it was sampled. Oracle: the positions of the
/// lines in the window, and the library's path and text.
#[test]
fn the_bounces_of_a_path_are_not_indented() {
    let (mut window, explained) = noisy_pixel();
    let roots = explained.samples.iter().filter_map(|sample| sample.ray.as_ref());
    let longest = roots.enumerate().max_by_key(|(_, root)| root.count());
    let (index, root) = longest.expect("the camera sees all its film");
    window.state_mut().selection.sample = index as u32;
    // without details, a line of the tree appears only once
    push(&mut window, "The sum");
    let (bounces, shadows) = path_of(root);
    assert!(bounces.len() >= 4 && shadows.len() >= 2, "{} bounces", bounces.len());
    let rect_of = |text: &str| window.get_by_label(text).rect();
    let first = rect_of(&root.line());
    let mut above = first.top() - 1.0;
    for (bounce, term) in bounces {
        let line = rect_of(&bounce.line());
        assert_eq!(line.left(), first.left(), "{}", bounce.line());
        assert!(line.top() > above, "{}", bounce.line());
        above = line.top();
        let Some(sampling) = term.map(RecordedTerm::sampling) else { continue };
        // where there is no room, the name of the lobe is left out
        let numbers = sampling.rsplit_once(", ").map_or(&*sampling, |(numbers, _)| numbers);
        let mut beside = window.query_all_by_label_contains(numbers).map(|said| said.rect());
        let is_beside = beside.any(|said| (said.center().y - line.center().y).abs() < 2.0);
        assert!(is_beside && sampling.contains(" /sr, "), "{sampling}");
    }
    for shadow in shadows {
        assert!(rect_of(&shadow.line()).left() > first.left(), "{}", shadow.line());
    }
}

/// Law: the samples are sorted, the greatest first; a click on one shows its tree. Oracle: the library's samples, sorted by hand.
#[test]
fn a_sample_is_one_click_from_its_tree() {
    let (mut window, explained) = noisy_pixel();
    push(&mut window, "The sum");
    let mut values: Vec<(u32, f64)> =
        (0..).zip(explained.radiances.iter().map(|radiance| radiance.average())).collect();
    values.sort_by(|a, b| b.1.total_cmp(&a.1));
    assert!(values[0].1 > values[1].1 && values[0].0 != 0, "the samples differ");
    let label = |index: u32| format!("sample {index:>3}  ");
    let height = |window: &Window, index: u32| {
        window.query_by_label_contains(&label(index)).map(|line| line.rect().center().y)
    };
    // those in view
    let shown: Vec<f32> = values.iter().map_while(|&(index, _)| height(&window, index)).collect();
    assert!(shown.len() >= 3 && shown.is_sorted(), "{shown:?}");
    let greatest = text_with(&window, "greatest: ");
    assert!(greatest.ends_with(&format!("sample {}", values[0].0)), "{greatest}");
    for &(index, _) in &values[..2] {
        window.get_by_label_contains(&label(index)).click();
        settle(&mut window);
        let line = root_line_of(&small_cornell_box(), ON_THE_BACK_WALL, index);
        assert!(window.query_by_label(&line).is_some(), "{line}");
        assert!(window.query_by_label(&format!("Sample {index}")).is_some());
    }
}
