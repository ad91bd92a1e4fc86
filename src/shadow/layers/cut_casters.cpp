#include "src/shadow/layers/cut_casters.hpp"

#include "preprocess/mesh/topology.hpp"
#include "preprocess/section/geometry_cut.hpp"

namespace edgeshade {

CutCasters cutCasters(const Scene& scene, bool castMasked, const glm::dvec4& plane) {
    CutCasters cut;
    cut.scene.materials = scene.materials;
    std::uint32_t before = 0; // casters of the batches before
    for (const Batch& batch : scene.batches) {
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        Batch& to = cut.scene.batches.emplace_back(batch);
        to.origins = nullptr;
        Geometry& geometry = to.geometry.edit();
        geometry.normals.clear(); // used only for drawing surfaces
        geometry.indices.clear();
        geometry.groups.clear();
        geometry.simplifiedCasters.reset();
        GeometryCut pieces(geometry, casters.indices);
        pieces.cut(planeInBatch(plane, batch.worldFromBatch), true);
        auto piece = pieces.triangles().begin();
        for (const SurfaceGroup& group : casters.groups) {
            geometry.groups.push_back(
                {group.material, static_cast<std::uint32_t>(geometry.indices.size()), 0});
            const std::uint32_t end = (group.firstIndex + group.indexCount) / 3;
            for (; piece != pieces.triangles().end() && piece->source < end; ++piece) {
                geometry.indices.insert(geometry.indices.end(), piece->corners.begin(),
                                        piece->corners.end());
                geometry.groups.back().indexCount += 3;
                cut.from.push_back(before + piece->source);
                cut.inside.push_back(!piece->away);
            }
        }
        before += static_cast<std::uint32_t>(casters.indices.size() / 3);
    }
    return cut;
}

} // namespace edgeshade
