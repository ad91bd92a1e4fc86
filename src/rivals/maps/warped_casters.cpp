#include "src/rivals/maps/warped_casters.hpp"

#include "src/rivals/maps/warp_cuts.hpp"

#include <map>

namespace edgeshade {
namespace {

/// Cuts a batch's group of triangles.
template <class Add>
void cutGroup(const Geometry& geometry, const SurfaceGroup& group,
              const std::vector<glm::dvec3>& places, const WarpCuts& cuts, Add add) {
    std::vector<WarpedCorner> pieces;
    for (std::uint32_t i = group.firstIndex; i < group.firstIndex + group.indexCount; i += 3) {
        const std::uint32_t* of = &geometry.indices[i];
        pieces.clear();
        cuts.add({places[of[0]], places[of[1]], places[of[2]]}, pieces);
        for (const WarpedCorner& corner : pieces)
            add(corner, of);
    }
}

WarpedCasters::Vertex vertexOf(const Geometry& geometry, const WarpedCorner& corner,
                               const std::uint32_t* of) {
    glm::vec2 texcoord(0.0f);
    float alpha = 0.0f;
    for (glm::length_t i = 0; i < 3; ++i) {
        const auto weight = static_cast<float>(corner.weights[i]);
        texcoord += weight * geometry.texcoords[of[i]];
        alpha += weight * geometry.colors[of[i]].a;
    }
    const auto byte = static_cast<std::uint8_t>(glm::clamp(alpha, 0.0f, 1.0f) * 255.0f + 0.5f);
    return {glm::vec3(corner.place), texcoord, {255, 255, 255, byte}};
}

template <class Vertex>
WarpedCasters::Part partOf(std::optional<std::size_t> cutout, const std::vector<Vertex>& vertices) {
    return {cutout, gl::vertexBuffer<Vertex>(vertices), static_cast<int>(vertices.size())};
}

} // namespace

WarpedCasters::WarpedCasters(const GpuScene& scene, const glm::dmat4& mapFromWorld,
                             const MapWarp& warp) {
    const WarpCuts cuts(warp);
    std::vector<glm::vec3> whole;
    std::map<std::size_t, std::vector<Vertex>> cutouts;
    for (const GpuBatch& batch : scene.batches) {
        if (batch.hidden) continue;
        const Geometry& geometry = *batch.geometry;
        const glm::dmat4 mapFromBatch = mapFromWorld * batch.worldFromBatch;
        std::vector<glm::dvec3> places;
        places.reserve(geometry.positions.size());
        for (const glm::vec3& position : geometry.positions)
            places.emplace_back(mapFromBatch * glm::dvec4(position, 1.0));
        for (const SurfaceGroup& group : geometry.groups) {
            const Material& material = scene.materials[group.material];
            if (!scene.castsInMaps(material)) continue;
            if (material.alphaMode == AlphaMode::mask) {
                std::vector<Vertex>& to = cutouts[group.material];
                cutGroup(geometry, group, places, cuts, [&](const auto& corner, const auto* of) {
                    to.push_back(vertexOf(geometry, corner, of));
                });
            } else {
                cutGroup(geometry, group, places, cuts, [&](const auto& corner, const auto*) {
                    whole.emplace_back(corner.place);
                });
            }
        }
    }
    if (!whole.empty()) parts_.push_back(partOf({}, whole));
    for (const auto& [material, vertices] : cutouts)
        if (!vertices.empty()) parts_.push_back(partOf(material, vertices));
}

std::size_t WarpedCasters::bytes() const {
    std::size_t total = 0;
    for (const Part& part : parts_)
        total += part.vertices.size();
    return total;
}

} // namespace edgeshade
