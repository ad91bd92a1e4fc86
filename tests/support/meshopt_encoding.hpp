#pragma once

#include "tests/support/gltf_builder.hpp"

namespace edgeshade::test {

/// A view of EXT_meshopt_compression: compressed bytes in buffer 0; the view itself is in buffer 1,
/// the fallback without a uri. Returns its index.
int addMeshoptView(GltfBuilder& gltf, const Bytes& compressed, std::size_t count,
                   std::size_t stride, const std::string& mode, const std::string& filter = "");

/// The same for vertices of `stride` bytes each, to which `filter` was already applied.
int addMeshoptVertices(GltfBuilder& gltf, const Bytes& vertices, std::size_t stride,
                       const std::string& filter = "");

/// The same for a triangle list (mode TRIANGLES) or for any indices (INDICES), 2 bytes each.
int addMeshoptTriangles(GltfBuilder& gltf, const std::vector<std::uint32_t>& indices);
int addMeshoptIndices(GltfBuilder& gltf, const std::vector<std::uint32_t>& indices);

/// A scene of that shape, with positions, normals and indices compressed.
GltfBuilder meshoptScene(const Shape& shape);

} // namespace edgeshade::test
