//! Triangles stored by where their middles are.

use boxes::aabb::Aabb;
use glam::Vec3;

use crate::leaf::Stored;
use crate::octree::Octree;

// ANCHOR: centroid
/// An octree that stores each triangle once, in the cell of its centroid. A ray that hits one where
/// it reaches out of that cell doesn't find it (hard case AC-11).
pub fn octree_by_centroids(triangles: &[[Vec3; 3]]) -> Octree {
    Octree::planted(triangles, |triangle: &Stored| {
        let [a, b, c] = triangle.corners;
        let centroid = (a + b + c) / 3.0;
        Aabb { min: centroid, max: centroid }
    })
}
// ANCHOR_END: centroid
