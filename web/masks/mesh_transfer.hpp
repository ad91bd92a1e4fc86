#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/base/file_io.hpp"
#include "src/engine/mesh_merging.hpp"
#include "web/archive.hpp"

namespace edgeshade::web {

/// A prepared mesh as bytes that another instance of this same program takes over with little more
/// than copying: a worker finds the edges, the page draws. They are the size of the head, 4 bytes,
/// the head, and the mesh's large arrays. This is no file format; never use it for bytes from
/// elsewhere.
Bytes toTransfer(const PreparedMesh& mesh);

/// Merged meshes, likewise, without their members, which the page has.
Bytes toTransfer(const MergedMeshes& meshes);

/// A mesh as its head restores it: a PreparedMesh, or the MergedMesh that shows merged meshes.
/// Before anything reads it, `arrays` must be filled from the bytes after the head, in this order,
/// so that a page may copy a large mesh in steps.
template <class Mesh>
struct Outlined {
    Mesh mesh;
    std::vector<VectorApart> arrays;
};

Outlined<PreparedMesh> meshOfHead(std::span<const std::uint8_t> head);
Outlined<MergedMesh> mergedOfHead(std::span<const std::uint8_t> head);

} // namespace edgeshade::web
