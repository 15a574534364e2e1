//! A pixel that is worth explaining, before the user selects one.

use groundtruth::render::Renderer;
use groundtruth::trace::RayBudget;
use groundtruth::world::World;

/// The pixels that are tried across and down, evenly spread.
const GRID: u32 = 11;
/// The most rays of a sample that are counted: a larger tree is no better to begin with.
const MAX_RAYS: u64 = 200;

/// Of a grid of pixels the one whose first sample has most rays; of equal ones that nearest to the middle.
pub fn interesting(world: &World) -> [u32; 2] {
    let size = world.picture_size();
    let middle =
        |step: u32, side: u32| u64::from(side) * u64::from(2 * step + 1) / u64::from(2 * GRID);
    let at = |step: [u32; 2]| [0, 1].map(|axis| middle(step[axis], size[axis]) as u32);
    let rays = |pixel: [u32; 2]| {
        let mut budget = RayBudget::up_to(MAX_RAYS);
        world.sample(pixel, 0, &mut (), &mut budget);
        budget.spent().min(MAX_RAYS)
    };
    let from_middle = |[column, row]: [u32; 2]| {
        [column, row].map(|step| (2 * step + 1).abs_diff(GRID).pow(2)).iter().sum::<u32>()
    };
    let tried = (0..GRID).flat_map(|row| (0..GRID).map(move |column| [column, row]));
    let best = tried.max_by_key(|&step| (rays(at(step)), std::cmp::Reverse(from_middle(step))));
    at(best.expect("the grid has pixels"))
}
