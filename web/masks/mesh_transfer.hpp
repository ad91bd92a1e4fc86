#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/base/file_io.hpp"
#include "src/engine/mesh_merging.hpp"

namespace edgeshade::web {

/// A prepared mesh as bytes that another instance of this same program takes over with little more
/// than copying: a worker finds the edges, the page draws. This is no file format; never use it for
/// bytes from elsewhere.
Bytes toTransfer(const PreparedMesh& mesh);

/// The mesh, restored.
PreparedMesh meshFromTransfer(std::span<const std::uint8_t> bytes);

/// Merged meshes, likewise, without their members, which the page has.
Bytes toTransfer(const MergedMeshes& meshes);

/// The mesh that shows them, restored.
MergedMesh mergedFromTransfer(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::web
