//! The exercises of chapter 10: one test each.

mod forest;
mod mistakes;
mod solutions;

use boxes::aabb::Aabb;
use bvh::exercises;
use common::exercise::judge::Failure;
use common::exercise::{Chapter, Exercise, Mistake, agree};
use common::sampler::Stream;
use glam::Vec3;

use forest::Forest;

const CHAPTER: Chapter =
    Chapter { package: env!("CARGO_PKG_NAME"), folder: env!("CARGO_MANIFEST_DIR") };

/// The centres of a set.
#[derive(Debug)]
pub(crate) struct Cloud {
    pub(crate) centers: Vec<Vec3>,
}

/// A node that is cut in two.
#[derive(Debug)]
pub(crate) struct Cut {
    pub(crate) node: Aabb,
    pub(crate) sides: [(Aabb, u32); 2],
    pub(crate) step: f32,
}

/// An item and how far away it is hit.
pub(crate) type Hit = Option<(u32, f32)>;

/// What was found in two children.
#[derive(Debug)]
pub(crate) struct Children {
    pub(crate) left: Hit,
    pub(crate) right: Hit,
}

fn point(stream: &mut Stream, size: Vec3) -> Vec3 {
    let x = stream.uniform() * size.x;
    let y = stream.uniform() * size.y;
    Vec3::new(x, y, stream.uniform() * size.z)
}

#[test]
fn exercise_10_1() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "10.1",
        title: "Half of them on each side",
        section: "Where to cut",
        cases: centers,
        expected: half_by_rank,
        agree: |_, expected, yours| expected == yours,
        yours: |case| sorted(exercises::lower_half(&case.centers)),
        solution: |case| sorted(solutions::lower_half(case)),
        mistakes: vec![
            Mistake {
                name: "unsorted",
                diagnosis: "You took the first half of the list as it came. The centres have to be \
                    in order along the axis first: see \"Where to cut\".",
                answer: mistakes::first_of_the_list,
            },
            Mistake {
                name: "always along x",
                diagnosis: "You sorted along x whatever the longest axis is. Look at which side of \
                    the box around the centres is longest: see \"Where to cut\".",
                answer: mistakes::along_x,
            },
            Mistake {
                name: "the upper half",
                diagnosis: "You gave the half that lies higher. The first child has the lower one.",
                answer: mistakes::upper_half,
            },
            Mistake {
                name: "below the middle",
                diagnosis: "You cut through the middle of the axis: that is the midpoint, and the \
                    sides need not have as many. The median is the middle one of the sorted centres.",
                answer: mistakes::below_the_middle,
            },
        ],
    }
    .judge()
}

/// Four by hand, then clouds that are longest along each axis in turn.
fn centers() -> Vec<Cloud> {
    let few = [(3.0, 1.0, 9.0), (1.0, 2.0, 0.5), (2.0, 0.0, 4.0), (4.0, 3.0, 1.0)];
    let mut cases = vec![Cloud { centers: few.map(Vec3::from).to_vec() }];
    for trial in 0..60 {
        let mut stream = Stream::of_trial(1011, trial);
        let mut size = Vec3::new(1.0, 2.0, 3.0);
        size[(trial % 3) as usize] = 10.0;
        let centers = (0..2 + trial).map(|_| point(&mut stream, size)).collect();
        cases.push(Cloud { centers });
    }
    cases
}

/// A centre is in the lower half if fewer than half of the others lie below it.
fn half_by_rank(Cloud { centers }: &Cloud) -> Vec<usize> {
    let extent = |axis: usize| {
        let along = centers.iter().map(|center| f64::from(center[axis]));
        along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
    };
    let axis = (0..3).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
    let below = |it: &Vec3| centers.iter().filter(|other| other[axis] < it[axis]).count();
    (0..centers.len()).filter(|&at| below(&centers[at]) < centers.len() / 2).collect()
}

fn sorted(mut places: Vec<usize>) -> Vec<usize> {
    places.sort_unstable();
    places
}

#[test]
fn exercise_10_2() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "10.2",
        title: "What a cut costs",
        section: "What a cut costs",
        cases: cuts,
        expected: |Cut { node, sides, step }| {
            let surface = |it: &Aabb| {
                let size = it.max.as_dvec3() - it.min.as_dvec3();
                2.0 * (size.x * size.y + size.y * size.z + size.z * size.x)
            };
            let side = |(it, count): &(Aabb, u32)| surface(it) / surface(node) * f64::from(*count);
            (f64::from(*step) + side(&sides[0]) + side(&sides[1])) as f32
        },
        agree: |_, expected, yours| agree::close(*expected, *yours, 1e-5),
        yours: |case| exercises::cost_of_cut(&case.node, &case.sides, case.step),
        solution: solutions::cost_of_cut,
        mistakes: vec![
            Mistake {
                name: "volumes",
                diagnosis: "You compared volumes. How many rays meet a box goes with its surface: \
                    a flat box has no volume, and rays meet it all the same. See \"What a cut costs\".",
                answer: mistakes::by_volume,
            },
            Mistake {
                name: "not divided",
                diagnosis: "You multiplied by the sides' surfaces and did not divide by the node's. \
                    What counts is the share of its rays: see \"What a cut costs\".",
                answer: mistakes::undivided,
            },
            Mistake {
                name: "surfaces alone",
                diagnosis: "You forgot how many items each side has. A ray that meets a side asks \
                    all of them.",
                answer: mistakes::without_counts,
            },
            Mistake {
                name: "two faces of six",
                diagnosis: "Your surface has x y and y z, but not z x. A box has three pairs of \
                    faces. A cube would not have told you.",
                answer: mistakes::two_pairs,
            },
        ],
    }
    .judge()
}

/// The page's two boxes, then others, some of them flat.
fn cuts() -> Vec<Cut> {
    let at = |x: f32| Aabb { min: Vec3::X * x, max: Vec3::new(x + 1.0, 2.0, 3.0) };
    let (left, right) = (at(0.0), at(3.0));
    let mut cases =
        vec![Cut { node: left.union(right), sides: [(left, 1), (right, 1)], step: 0.5 }];
    for trial in 0..60 {
        let mut stream = Stream::of_trial(1012, trial);
        let mut side = || {
            let low = point(&mut stream, Vec3::new(4.0, 5.0, 6.0));
            let mut size = point(&mut stream, Vec3::new(1.0, 2.0, 3.0));
            if trial % 4 == 0 {
                size.z = 0.0;
            }
            (Aabb { min: low, max: low + size }, 1 + stream.bits() % 9)
        };
        let sides = [side(), side()];
        cases.push(Cut { node: sides[0].0.union(sides[1].0), sides, step: 0.25 });
    }
    cases
}

#[test]
fn exercise_10_3() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "10.3",
        title: "Not behind what was found",
        section: "The nearer child first",
        cases: forests,
        expected: Forest::nearest_by_scan,
        agree: |_, expected, yours| {
            // A hit may be found a little late, and some that lie behind it were asked before.
            let as_few = agree::close(expected.asked, yours.asked, 0.2);
            expected.hits == yours.hits && as_few
        },
        yours: |case| case.nearest(exercises::nearest),
        solution: |case| case.nearest(solutions::nearest),
        mistakes: vec![
            Mistake {
                name: "nothing is pruned",
                diagnosis: "Your hits are right, but you also asked what lies behind them. Give the \
                    nearest distance so far to `ray.enter` and to `ask`, and leave out what was put \
                    aside and is farther by now: see \"The nearer child first\".",
                answer: |case| case.nearest(mistakes::never_prunes),
            },
            Mistake {
                name: "in the order of the list",
                diagnosis: "Your hits are right, and you prune, but you go to the children as they \
                    come. Go to the one first whose box is entered first: then the near hits are \
                    found early, and the rest lies behind them. See \"The nearer child first\".",
                answer: |case| case.nearest(mistakes::in_any_order),
            },
            Mistake {
                name: "the first hit",
                diagnosis: "You gave the first hit that you found. Boxes overlap: another leaf may \
                    hold a nearer one. See \"The nearer child first\".",
                answer: |case| case.nearest(mistakes::first_found),
            },
            Mistake {
                name: "the nearer child alone",
                diagnosis: "Where the nearer child had a hit you left out the other one. Their boxes \
                    may overlap: leave it out only if its box is entered behind the hit.",
                answer: |case| case.nearest(mistakes::near_child_only),
            },
        ],
    }
    .judge()
}

/// Few spheres first.
fn forests() -> Vec<Forest> {
    [3, 12, 60, 250, 700].iter().zip(1..).map(|(&spheres, seed)| Forest { spheres, seed }).collect()
}

#[test]
fn exercise_10_4() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "10.4",
        title: "Is anything in the way",
        section: "Any hit will do",
        cases: forests,
        expected: Forest::blocked_by_scan,
        agree: |_, expected, yours| expected == yours,
        yours: |case| case.blocked(exercises::is_hit),
        solution: |case| case.blocked(solutions::is_hit),
        mistakes: vec![
            Mistake {
                name: "the nearest hit",
                diagnosis: "Your answers are right, but after a hit you went on to look for a \
                    nearer one. One is enough: see \"Any hit will do\".",
                answer: |case| case.blocked(mistakes::by_nearest),
            },
            Mistake {
                name: "the nearest hit of all",
                diagnosis: "You looked for the nearest hit, and compared it with `t_max` \
                    afterwards. Your answers are right, but one hit below `t_max` is enough: give \
                    `ask` that limit, and stop when it answers. See \"Any hit will do\".",
                answer: |case| case.blocked(mistakes::by_nearest_of_all),
            },
            Mistake {
                name: "without an end",
                diagnosis: "You gave infinity for the limit. What lies behind the lamp casts no \
                    shadow: hits count below `t_max`.",
                answer: |case| case.blocked(mistakes::without_end),
            },
            Mistake {
                name: "everybody is asked",
                diagnosis: "You asked items whose boxes the ray does not meet. What is not in a box \
                    that is met needs no question.",
                answer: |case| case.blocked(mistakes::asks_everybody),
            },
            Mistake {
                name: "one path down",
                diagnosis: "You went to the first child that is met and forgot the other one. It has \
                    to wait its turn.",
                answer: |case| case.blocked(mistakes::one_path),
            },
        ],
    }
    .judge()
}

#[test]
fn exercise_10_5() -> Result<(), Failure> {
    Exercise {
        chapter: CHAPTER,
        number: "10.5",
        title: "Find the mistake: the nearer of two",
        section: "The report's traversal",
        cases: children,
        expected: |Children { left, right }| {
            let both = [left, right].into_iter().flatten();
            both.copied().min_by(|a, b| f64::from(a.1).total_cmp(&f64::from(b.1)).then(a.0.cmp(&b.0)))
        },
        agree: |_, expected, yours| expected == yours,
        yours: |case| exercises::nearer(case.left, case.right),
        solution: solutions::nearer,
        mistakes: vec![
            Mistake {
                name: "the published line",
                diagnosis: "That is the report's line. Where both are as far away it takes the right \
                    one, whichever that is: another tree, another picture. See \"The report's \
                    traversal\".",
                answer: mistakes::published,
            },
            Mistake {
                name: "the left one of two as far away",
                diagnosis: "Where both are as far away you take the left one, as the report takes the \
                    right one. Which is which depends on the tree: another tree, another picture. \
                    The lower number counts. See \"The report's traversal\".",
                answer: mistakes::left_of_two,
            },
            Mistake {
                name: "no hit is at 0",
                diagnosis: "A child without a hit has no distance, and certainly not 0: you let it \
                    win over every hit.",
                answer: mistakes::none_is_nearest,
            },
            Mistake {
                name: "the farther one",
                diagnosis: "You gave the farther hit. The nearer one hides it.",
                answer: mistakes::farther,
            },
            Mistake {
                name: "the lower number alone",
                diagnosis: "You gave the lower number whatever the distances are. It decides only \
                    where they are equal.",
                answer: mistakes::lower_number,
            },
        ],
    }
    .judge()
}

/// All there is: either, neither, nearer, farther, and as far.
fn children() -> Vec<Children> {
    let hits = [None, Some((4, 2.5)), Some((7, 2.5)), Some((2, 8.0)), Some((9, 1.0))];
    let pairs = hits.into_iter().flat_map(|left| hits.map(|right| Children { left, right }));
    pairs.collect()
}

/// Used by the files beside this one.
pub(crate) type Ask<'a> = &'a mut dyn FnMut(u32, f32) -> Option<f32>;
