//! Closed meshes: those that have an inside.

use std::collections::HashMap;

// ANCHOR: closed
/// How many edges lack a partner: a neighbour that runs along the same edge the other way.
///
/// In a closed mesh each edge has one, so the answer is 0: a ray that starts inside has to hit
/// something on its way out.
pub fn edges_without_partner(triangles: &[[u32; 3]]) -> usize {
    let mut balance: HashMap<[u32; 2], i32> = HashMap::new();
    for &[a, b, c] in triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let step = if from < to { 1 } else { -1 };
            *balance.entry([from.min(to), from.max(to)]).or_default() += step;
        }
    }
    balance.values().filter(|&&sum| sum != 0).count()
}
// ANCHOR_END: closed

#[cfg(test)]
mod tests {
    use super::edges_without_partner;

    #[test]
    fn a_tetrahedron_is_closed_until_a_face_is_missing_or_turned() {
        let mut faces = vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
        assert_eq!(edges_without_partner(&faces), 0);
        faces[1] = [0, 1, 3];
        assert_eq!(edges_without_partner(&faces), 3);
        faces.remove(1);
        assert_eq!(edges_without_partner(&faces), 3);
    }
}
