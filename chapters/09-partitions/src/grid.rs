//! A uniform grid: space in equal boxes, each with a list of the triangles that reach into it.

use boxes::aabb::Aabb;
use boxes::bounded::Bounded;
use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::accelerator::{Accelerator, CELL_STEPS, MOST_COPIES, Statistics};
use crate::cells::{MOST_A_SIDE, Side, cubes};
use crate::leaf::{Question, Stored, hittable};
use crate::march::March;
use crate::wide::WideRay;

// ANCHOR: grid
/// A uniform grid.
#[derive(Clone, Debug)]
pub struct Grid {
    bounds: Aabb,
    sides: [Side; 3],
    /// Where each cell's triangles begin in `stored`, and at the end, where the last one's end.
    starts: Vec<u32>,
    stored: Vec<Stored>,
    triangles: usize,
    left_out: usize,
}
// ANCHOR_END: grid

// ANCHOR: heuristic
/// Cells for each triangle, where nothing else is asked for.
///
/// Twice as many cells hold half as many triangles each, and a ray passes 2^(1/3) times as many.
/// The chapter's first experiment shows where that pays.
pub const CELLS_PER_TRIANGLE: f32 = 2.0;
// ANCHOR_END: heuristic

/// The most triangles that a grid stores at the reader's own number of cells: 640 MB of them.
const MOST_STORED: u64 = 1 << 24;

impl Grid {
    /// With `cells` cells along the longest side and cubes as nearly as can be, or fewer, where
    /// that would store more than 16 million triangles.
    pub fn with_cells(triangles: &[[Vec3; 3]], cells: u32) -> Self {
        let most = |stored: usize| MOST_STORED.max(stored as u64);
        Self::arranged(triangles, most, |_, size| {
            let longest = size.max_element();
            let cells = cells.clamp(1, MOST_A_SIDE as u32) as f32;
            size.to_array().map(|length| ((length / longest * cells).round() as i32).max(1))
        })
    }

    /// How many cells there are along each side.
    pub fn cells(&self) -> [i32; 3] {
        self.sides.map(|side| side.count)
    }

    fn arranged(
        triangles: &[[Vec3; 3]],
        most: impl Fn(usize) -> u64,
        cells: impl Fn(usize, Vec3) -> [i32; 3],
    ) -> Self {
        let hittable = hittable(triangles);
        let bounds = Aabb::of_points(hittable.iter().flat_map(|it| it.corners));
        let mut counts = cells(hittable.len(), bounds.size());
        let mut sides = cut(&bounds, counts);
        // A few long triangles can be in every cell: then there are too many cells.
        while copies(&hittable, &sides) > most(hittable.len()) {
            counts = counts.map(|count| (count / 2).max(1));
            sides = cut(&bounds, counts);
        }
        let (starts, stored) = sorted_into(&hittable, &sides);
        let left_out = triangles.len() - hittable.len();
        Self { bounds, sides, starts, stored, triangles: triangles.len(), left_out }
    }

    /// The box around all that is stored.
    pub fn bounds(&self) -> &Aabb {
        &self.bounds
    }

    /// Its three sides, cut into cells.
    pub fn sides(&self) -> &[Side; 3] {
        &self.sides
    }

    /// The triangles in the cell with these indices.
    #[inline]
    pub fn cell(&self, [x, y, z]: [i32; 3]) -> &[Stored] {
        let number = number(&self.sides, [x, y, z]);
        &self.stored[self.starts[number] as usize..self.starts[number + 1] as usize]
    }
}

/// The sides of `bounds`, each in so many cells.
fn cut(bounds: &Aabb, counts: [i32; 3]) -> [Side; 3] {
    let side = |axis| Side::new(bounds.min[axis], bounds.max[axis], counts[axis]);
    [0, 1, 2].map(side)
}

#[inline]
fn number(sides: &[Side; 3], [x, y, z]: [i32; 3]) -> usize {
    let (across, up) = (sides[0].count as usize, sides[1].count as usize);
    (z as usize * up + y as usize) * across + x as usize
}

// ANCHOR: cells_of
/// The cells that a triangle's box reaches into: from these indices to those, both included.
fn cells_of(triangle: &Stored, sides: &[Side; 3]) -> [[i32; 2]; 3] {
    let Aabb { min, max } = triangle.corners.bounds();
    [0, 1, 2].map(|axis| [min[axis], max[axis]].map(|end| sides[axis].index(end)))
}
// ANCHOR_END: cells_of

/// How many triangles all cells together would hold.
fn copies(triangles: &[Stored], sides: &[Side; 3]) -> u64 {
    let cells = |triangle: &Stored| {
        cells_of(triangle, sides).map(|[low, high]| (high - low + 1) as u64).iter().product::<u64>()
    };
    triangles.iter().map(cells).sum()
}

// ANCHOR: sorted_into
/// The triangles by cells, in two passes: how many each cell gets says where it begins, then each
/// triangle goes to the next free place of its cells. Within a cell they stay in order.
fn sorted_into(triangles: &[Stored], sides: &[Side; 3]) -> (Vec<u32>, Vec<Stored>) {
    let cells: usize = sides.iter().map(|side| side.count as usize).product();
    let mut starts = vec![0; cells + 1];
    for triangle in triangles {
        each_cell(triangle, sides, |cell| starts[cell + 1] += 1);
    }
    for cell in 0..cells {
        starts[cell + 1] += starts[cell];
    }
    let mut next = starts.clone();
    let nothing = Stored { corners: [Vec3::ZERO; 3], index: 0 };
    let mut stored = vec![nothing; starts[cells] as usize];
    for triangle in triangles {
        each_cell(triangle, sides, |cell| {
            stored[next[cell] as usize] = *triangle;
            next[cell] += 1;
        });
    }
    (starts, stored)
}
// ANCHOR_END: sorted_into

fn each_cell(triangle: &Stored, sides: &[Side; 3], mut take: impl FnMut(usize)) {
    let [x, y, z] = cells_of(triangle, sides).map(|[low, high]| low..=high);
    for z in z {
        for y in y.clone() {
            for x in x.clone() {
                take(number(sides, [x, y, z]));
            }
        }
    }
}

impl Accelerator for Grid {
    fn build(triangles: Vec<[Vec3; 3]>) -> Self {
        let most = |stored: usize| (MOST_COPIES * stored as f32) as u64;
        Self::arranged(&triangles, most, |stored, size| {
            cubes(size.to_array(), CELLS_PER_TRIANGLE * stored as f32)
        })
    }

    // ANCHOR: walk
    fn walk<Q: Question, T: Tally>(&self, ray: &Ray, question: &mut Q, tally: &mut T) {
        if self.stored.is_empty() {
            return;
        }
        let ray = WideRay::new(ray, &self.bounds);
        let Some(mut march) = March::start(&ray, &self.bounds, &self.sides, question.limit())
        else {
            return;
        };
        while let Some(cells) = march.next_cells() {
            for cell in cells {
                tally.count(CELL_STEPS, 1);
                let triangles = self.cell(cell);
                if triangles.is_empty() {
                    continue;
                }
                question.ask_all(triangles, tally);
                if question.answered() {
                    return;
                }
                march.end_at(ray.reach(question.limit()));
            }
        }
    }
    // ANCHOR_END: walk

    fn statistics(&self) -> Statistics {
        Statistics {
            triangles: self.triangles,
            left_out: self.left_out,
            references: self.stored.len(),
            nodes: self.starts.len() - 1,
            depth: 0,
            bytes: size_of_val(&self.starts[..]) + size_of_val(&self.stored[..]),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use triangles::bumpy;

    use super::{CELLS_PER_TRIANGLE, Grid};
    use crate::accelerator::{Accelerator, MOST_COPIES};

    #[test]
    fn a_grid_by_hand() {
        let corner = |x: f32, y: f32| Vec3::new(x, y, 0.0);
        // One triangle in the first of four cells, one in the last two.
        let triangles = [
            [corner(0.0, 0.0), corner(0.9, 0.0), corner(0.0, 0.5)],
            [corner(2.1, 0.0), corner(4.0, 0.5), corner(4.0, 1.0)],
        ];
        let grid = Grid::with_cells(&triangles, 4);
        assert_eq!(grid.cells(), [4, 1, 1]);
        let held = |x| -> Vec<u32> { grid.cell([x, 0, 0]).iter().map(|it| it.index).collect() };
        let held = [0, 1, 2, 3].map(held);
        assert_eq!(held, [vec![0], vec![], vec![1], vec![1]]);
        assert_eq!(grid.statistics().references, 3);
        // Three stored triangles of 40 bytes, and five places of 4.
        assert_eq!(grid.statistics().bytes, 3 * 40 + 5 * 4);
    }

    #[test]
    fn the_heuristic_takes_its_number_of_cells() {
        let triangles = bumpy::sphere(5000).all_corners();
        let cells = Grid::build(triangles).statistics().nodes as f32;
        let wanted = 5000.0 * CELLS_PER_TRIANGLE;
        assert!((0.8 * wanted..1.2 * wanted).contains(&cells), "{cells}");
    }

    #[test]
    fn long_triangles_make_the_cells_fewer() {
        let along = |z: usize| {
            let z = 1e-6 * z as f32;
            [Vec3::new(0.0, 0.0, z), Vec3::new(1.0, 1.0, z), Vec3::new(0.0, 1.0, 1.0 - z)]
        };
        let triangles: Vec<_> = (0..3000).map(along).collect();
        let statistics = Grid::build(triangles).statistics();
        assert!(statistics.copies() <= f64::from(MOST_COPIES), "{statistics:?}");
    }
}
