#pragma once

#include "preprocess/base/box.hpp"
#include "src/engine/prepared_mesh.hpp"

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

namespace edgeshade {

// Merging small meshes that rest, so that a building model of thousands of meshes takes tens of
// draws instead of thousands.

/// Most triangles of a mesh that is worth merging; larger ones are draws of their own.
inline constexpr std::size_t mostTrianglesOfMember = 1024;
/// Triangles of a merged mesh: few enough to find its edges within a frame.
inline constexpr std::size_t mostTrianglesMerged = 4096;
/// Fewest meshes that are worth merging.
inline constexpr std::size_t fewestMembers = 4;

/// A merged mesh's box is at most this many times as large as its smallest member's. Vertices are
/// relative to the box's middle, so rounding moves them by at most 2^-16 of a member's size.
inline constexpr double mostSpread = 1024.0;

/// A mesh in its place.
struct PlacedMesh {
    std::shared_ptr<const PreparedMesh::Data> mesh;
    glm::dmat4 worldFromMesh{1.0};
};

/// A mesh that may be merged with others.
struct MergeCandidate {
    std::size_t number = 0;   ///< the caller's
    std::size_t material = 0; ///< only meshes of one material can be merged
    std::size_t triangles = 0;
    Box box{}; ///< in the world
};

/// A mesh's candidate. `number`: the caller's.
MergeCandidate candidateOf(std::size_t number, const PlacedMesh& mesh);

/// The numbers of the first candidate and of its nearest neighbours that fit into one mesh with it.
std::vector<std::size_t> neighbours(std::span<const MergeCandidate> candidates);

/// Whether a mesh may be part of a merged mesh: it is small, visible and not alpha-tested.
bool mayMerge(const PreparedMesh::Data& mesh);

/// A merged mesh with its place, a translation.
struct MergedMesh {
    PreparedMesh mesh;
    glm::dmat4 worldFromMerged;
};

/// Merges meshes of one material. Vertices are rounded to floats relative to the middle of the
/// result. A mirrored mesh's triangles are turned over, so that their fronts stay fronts. Throws
/// InputError if the places are too far apart for floats.
MergedMesh merge(std::span<const PlacedMesh> members);

} // namespace edgeshade
