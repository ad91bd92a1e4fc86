#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"
#include "tests/support/tiny_meshes.hpp"

namespace edgeshade::test {

/// The plane-pair records of a soup with one material.
inline PlanePairShadow shadowOf(const Soup& soup) {
    CasterMesh mesh;
    mesh.welded = weld(soup.positions, soup.indices);
    const auto count = static_cast<std::uint32_t>(mesh.welded.triangles.size());
    if (count > 0) mesh.groups = {{0, 0, count}};
    return buildPlanePairs(mesh, buildEdges(mesh.welded), {Material()});
}

} // namespace edgeshade::test
