#include "src/shadow/geometry/flat_casters.hpp"

#include "src/shadow/geometry/light_range.hpp"

#include <cmath>

namespace edgeshade {
namespace {

/// Whether all of a triangle is farther away than the light reaches.
bool isOutOfRange(const std::array<glm::dvec3, 3>& rays, const LightView& from) {
    if (!std::isfinite(from.range)) return false;
    Box box;
    for (const glm::dvec3& ray : rays)
        box.add(ray);
    return isBeyond(box, glm::dvec3(0.0), from.range);
}

} // namespace

FlatCasters::FlatCasters(const Scene& scene, bool castMasked, const LightView& from) {
    std::vector<glm::dvec3> rays;
    for (const Batch& batch : scene.batches) {
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        if (casters.indices.empty()) continue;
        rays.clear();
        for (const glm::vec3& position : batch.geometry->positions)
            rays.push_back(from.rayTo(batch.worldFromBatch * glm::dvec4(position, 1.0)));
        add(casters, rays, from);
    }
}

void FlatCasters::add(const Casters& casters, const std::vector<glm::dvec3>& rays,
                      const LightView& from) {
    const auto first = static_cast<std::uint32_t>(points_.size());
    std::vector<std::int8_t> faces(rays.size(), 0); // of vertices
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!from.directional) faces[i] = static_cast<std::int8_t>(faceAround(rays[i]));
        if (faces[i] < 0) {
            points_.emplace_back();
            continue;
        }
        const glm::dvec3 on = rays[i] * from.faces[static_cast<std::size_t>(faces[i])];
        points_.emplace_back(on.x / on.z, on.y / on.z);
    }
    for (std::size_t i = 0; i + 2 < casters.indices.size(); i += 3) {
        const std::uint32_t a = casters.indices[i], b = casters.indices[i + 1],
                            c = casters.indices[i + 2];
        const std::array corners{rays[a], rays[b], rays[c]};
        const auto triangle = static_cast<std::uint32_t>(faceOf_.size());
        const bool oneFace = faces[a] >= 0 && faces[a] == faces[b] && faces[a] == faces[c];
        const bool reached = !isOutOfRange(corners, from);
        places_.push_back({first + a, first + b, first + c});
        faceOf_.push_back(oneFace && reached ? faces[a] : std::int8_t{-1});
        if (oneFace || !reached) continue;
        for (std::size_t face = 0; face < from.faces.size(); ++face) {
            const FacePolygon polygon = polygonOn(from.faces[face], corners);
            if (polygon.count > 0 && !outlineOf(polygon.all()).misses(from.wholeFace()))
                parts_.push_back({triangle, face, polygon});
        }
    }
}

} // namespace edgeshade
