//! A mesh in parts, one a material.

use std::collections::HashMap;

use crate::mesh::Mesh;

/// The triangles of a mesh that are of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// A mesh of its own, with the vertices that its triangles use.
    pub mesh: Mesh,
    /// The material's number; None where the file names none.
    pub material: Option<u32>,
}

// ANCHOR: by_material
/// The parts of `mesh` in the order in which their materials are first used; `material_of` has the
/// material of each triangle.
///
/// Vertices are copied with their normals. So a surface that runs on from one material into another
/// stays smooth, and the edges at the seam are the same to the bit on both sides: no ray slips
/// through.
pub fn by_material(mesh: &Mesh, material_of: &[Option<u32>]) -> Vec<Part> {
    let mut place = HashMap::new();
    let mut parts: Vec<(Option<u32>, Vec<[u32; 3]>)> = Vec::new();
    for (triangle, material) in mesh.triangles.iter().zip(material_of) {
        let at = *place.entry(material).or_insert(parts.len());
        if at == parts.len() {
            parts.push((*material, Vec::new()));
        }
        parts[at].1.push(*triangle);
    }
    let part = |(material, triangles): (_, Vec<_>)| Part { mesh: cut(mesh, &triangles), material };
    parts.into_iter().map(part).collect()
}
// ANCHOR_END: by_material

/// Some of the mesh's triangles, with their vertices numbered anew.
fn cut(mesh: &Mesh, triangles: &[[u32; 3]]) -> Mesh {
    let mut part = Mesh::default();
    let mut numbers: HashMap<u32, u32> = HashMap::new();
    let mut number = |old: u32| {
        let next = numbers.len() as u32;
        *numbers.entry(old).or_insert_with(|| {
            part.positions.push(mesh.positions[old as usize]);
            part.normals.extend(mesh.normals.get(old as usize));
            part.uvs.extend(mesh.uvs.get(old as usize));
            next
        })
    };
    part.triangles = triangles.iter().map(|triangle| triangle.map(&mut number)).collect();
    part
}

#[cfg(test)]
mod tests {
    use super::by_material;
    use crate::bumpy;
    use crate::mesh::Mesh;

    #[test]
    fn every_triangle_is_in_the_part_of_its_material() {
        let mesh = bumpy::sphere(90);
        let material_of: Vec<Option<u32>> =
            (0..90).map(|it| [Some(4), None, Some(1)][it * it % 3]).collect();
        let parts = by_material(&mesh, &material_of);
        let materials: Vec<_> = parts.iter().map(|part| part.material).collect();
        assert_eq!(materials, [Some(4), None], "0, 1, 1, 0, 1, 1: a square is never 2 of 3");
        for part in &parts {
            let own = (0..90).filter(|&it| material_of[it] == part.material);
            let corners: Vec<_> = own.map(|it| mesh.corners(it)).collect();
            assert_eq!(part.mesh.all_corners(), corners);
            assert_eq!(part.mesh.normals.len(), part.mesh.positions.len());
            assert!(part.mesh.positions.len() <= mesh.positions.len());
        }
    }

    #[test]
    fn one_material_is_one_part() {
        let mesh = bumpy::sphere(50);
        let [part] = &by_material(&mesh, &[None; 50])[..] else { panic!("it was cut") };
        assert_eq!(part.mesh.all_corners(), mesh.all_corners());
        assert!(by_material(&Mesh::default(), &[]).is_empty());
    }
}
