#pragma once

#include "preprocess/volumes/adapted_data.hpp"
#include "tests/support/tiny_meshes.hpp"

namespace edgeshade::test {

/// The adapted records of a soup of one material.
inline AdaptedShadow shadowOf(const Soup& soup) {
    CasterMesh mesh;
    mesh.welded = weld(soup.positions, soup.indices);
    const auto count = static_cast<std::uint32_t>(mesh.welded.triangles.size());
    if (count > 0) mesh.groups = {{0, 0, count}};
    return buildAdapted(mesh, buildEdges(mesh.welded), {Material()});
}

} // namespace edgeshade::test
