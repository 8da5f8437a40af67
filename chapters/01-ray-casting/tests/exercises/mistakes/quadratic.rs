//! Mistakes with quadratic equations: exercises 1.2 and 1.5.

use common::exercise::Mistake;

use crate::cases::{Aim, Quadratic};

/// a, h and c of a t² + 2 h t + c = 0 for a ray and a sphere.
fn coefficients(aim: &Aim) -> Quadratic {
    let f = aim.ray.origin - aim.sphere.center;
    let d = aim.ray.direction;
    Quadratic { a: d.dot(d), h: f.dot(d), c: f.dot(f) - aim.sphere.radius * aim.sphere.radius }
}

/// Both roots by the textbook, NaN where there are none.
fn textbook(case: &Quadratic) -> [f32; 2] {
    let root = (case.h * case.h - case.a * case.c).sqrt();
    [(-case.h - root) / case.a, (-case.h + root) / case.a]
}

fn first_positive(roots: [f32; 2]) -> Option<f32> {
    roots.into_iter().find(|&t| t > 0.0)
}

pub(crate) fn of_hit_sphere() -> Vec<Mistake<Aim, Option<f32>>> {
    vec![
        Mistake {
            name: "only the smaller root",
            diagnosis: "From inside a sphere the smaller root lies behind you, and the larger one \
                        is where you leave it. Try that one next: see 'Where a ray meets a sphere'.",
            answer: |aim| Some(textbook(&coefficients(aim))[0]).filter(|&t| t > 0.0),
        },
        Mistake {
            name: "hits behind the origin",
            diagnosis: "You return a negative t. That point is on the line, but not on the ray: see \
                        'A ray'.",
            answer: |aim| Some(textbook(&coefficients(aim))[0]).filter(|t| !t.is_nan()),
        },
        Mistake {
            name: "the direction is taken to have length 1",
            diagnosis: "Your a is missing or 1. It is d·d, the square of the direction's length, \
                        and belongs under the root and below the fraction: see 'Where a ray meets \
                        a sphere'.",
            answer: |aim| first_positive(textbook(&Quadratic { a: 1.0, ..coefficients(aim) })),
        },
        Mistake {
            name: "4ac beside half of b",
            diagnosis: "With h, half of the textbook's b, the discriminant is h² - a k: the 4 goes \
                        away with the 2. See 'Where a ray meets a sphere'.",
            answer: |aim| {
                let Quadratic { a, h, c } = coefficients(aim);
                let root = (h * h - 4.0 * a * c).sqrt();
                first_positive([(-h - root) / a, (-h + root) / a])
            },
        },
        Mistake {
            name: "from the wrong end",
            diagnosis: "The vector f goes from the centre to the ray's origin: o - c. Yours goes the \
                        other way, which turns the sign of h and puts the sphere behind you: see \
                        'Where a ray meets a sphere'.",
            answer: |aim| {
                let case = coefficients(aim);
                first_positive(textbook(&Quadratic { h: -case.h, ..case }))
            },
        },
        Mistake {
            name: "the radius isn't squared",
            diagnosis: "The sphere is |p - c|² = r²: the radius belongs squared into k. See 'Where a \
                        ray meets a sphere'.",
            answer: |aim| {
                let (case, radius) = (coefficients(aim), aim.sphere.radius);
                first_positive(textbook(&Quadratic {
                    c: case.c + radius * radius - radius,
                    ..case
                }))
            },
        },
    ]
}

pub(crate) fn of_roots() -> Vec<Mistake<Quadratic, Option<[f32; 2]>>> {
    vec![
        Mistake {
            name: "the textbook's formula",
            diagnosis: "One of your roots is the difference of two numbers that nearly agree, and \
                        has lost most of its digits. Compute the other one first, and this one as \
                        k / q: see 'Two roots, no subtraction'.",
            answer: |case| Some(textbook(case)).filter(|roots| !roots[0].is_nan()),
        },
        Mistake {
            name: "both roots cancel",
            diagnosis: "h and the root must have one sign in q, so that they add up; yours have \
                        opposite signs: see 'Two roots, no subtraction'.",
            answer: |case| {
                let root = (case.h * case.h - case.a * case.c).sqrt();
                sorted(case, -case.h + root.copysign(case.h))
            },
        },
        Mistake {
            name: "the sign of zero is zero",
            diagnosis: "Where h is 0 your sign is 0 too, q becomes 0, and k / q divides by it. \
                        copysign has an answer for 0: see 'Two roots, no subtraction'.",
            answer: |case| {
                let root = (case.h * case.h - case.a * case.c).sqrt();
                let sign = if case.h == 0.0 { 0.0 } else { case.h.signum() };
                sorted(case, -case.h - sign * root)
            },
        },
        Mistake {
            name: "not in order",
            diagnosis: "Which of q / a and k / q is the smaller depends on the sign of h. Compare \
                        them before you return them: see 'Two roots, no subtraction'.",
            answer: |case| {
                let root = (case.h * case.h - case.a * case.c).sqrt();
                let q = -(case.h + root.copysign(case.h));
                Some([q / case.a, case.c / q]).filter(|_| !root.is_nan())
            },
        },
        Mistake {
            name: "in the wrong order",
            diagnosis: "k / q is the smaller one only where h is below 0. Compare the two before \
                        you return them: see 'Two roots, no subtraction'.",
            answer: |case| {
                let root = (case.h * case.h - case.a * case.c).sqrt();
                let q = -(case.h + root.copysign(case.h));
                Some([case.c / q, q / case.a]).filter(|_| !root.is_nan())
            },
        },
        Mistake {
            name: "NaN for no root",
            diagnosis: "Below 0 the discriminant has no root, and the answer is None. Yours is NaN, \
                        which every later line will believe: see 'Where a ray meets a sphere'.",
            answer: |case| {
                let root = (case.h * case.h - case.a * case.c).sqrt();
                let q = -(case.h + root.copysign(case.h));
                let (first, second) = (q / case.a, case.c / q);
                Some([first.min(second), first.max(second)])
            },
        },
    ]
}

/// Both roots from q; None when that is NaN.
fn sorted(case: &Quadratic, q: f32) -> Option<[f32; 2]> {
    let (first, second) = (q / case.a, case.c / q);
    Some([first.min(second), first.max(second)]).filter(|_| !q.is_nan())
}
