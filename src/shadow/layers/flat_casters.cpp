#include "src/shadow/layers/flat_casters.hpp"

#include "preprocess/base/parallel.hpp"
#include "src/shadow/lights/light_range.hpp"

#include <cmath>

namespace edgeshade {
namespace {

/// Whether the whole triangle is beyond the light's range.
bool isBeyondRange(const std::array<glm::dvec3, 3>& rays, double range) {
    Box box;
    for (const glm::dvec3& ray : rays)
        box.add(ray);
    return isBeyond(box, glm::dvec3(0.0), range);
}

} // namespace

FlatCasters::FlatCasters(const Scene& scene, bool castMasked, const LightView& from) {
    for (const Batch& batch : scene.batches) {
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        if (casters.indices.empty()) continue;
        const std::size_t firstVertex = rays_.size();
        addVertices(batch, from);
        addTriangles(casters, firstVertex, from);
    }
}

void FlatCasters::addVertices(const Batch& batch, const LightView& from) {
    const std::vector<glm::vec3>& positions = batch.geometry->positions;
    const std::size_t first = rays_.size();
    rays_.resize(first + positions.size());
    points_.resize(rays_.size());
    faceAt_.resize(rays_.size(), 0);
    forEachItem(positions.size(), itemsOfThread, Threads(), [&](std::size_t i) {
        const glm::dvec3 ray = from.rayTo(batch.worldFromBatch * glm::dvec4(positions[i], 1.0));
        const int face = from.directional ? 0 : faceAround(ray);
        rays_[first + i] = ray;
        faceAt_[first + i] = static_cast<std::int8_t>(face);
        if (face < 0) return;
        const glm::dvec3 on = ray * from.faces[static_cast<std::size_t>(face)];
        points_[first + i] = glm::dvec2(on) / on.z;
    });
}

void FlatCasters::addTriangles(const Casters& casters, std::size_t firstVertex,
                               const LightView& from) {
    const std::size_t first = places_.size(), count = casters.indices.size() / 3;
    places_.resize(first + count);
    faceOf_.resize(first + count);
    forEachItem(count, itemsOfThread, Threads(), [&](std::size_t t) {
        std::array<std::uint32_t, 3>& corners = places_[first + t];
        for (std::size_t c = 0; c < 3; ++c)
            corners[c] = static_cast<std::uint32_t>(firstVertex + casters.indices[3 * t + c]);
        const std::int8_t face = faceAt_[corners[0]];
        const bool whole = face == faceAt_[corners[1]] && face == faceAt_[corners[2]];
        faceOf_[first + t] = whole ? face : std::int8_t{-1};
    });
    const bool ranged = std::isfinite(from.range);
    for (std::size_t t = first; t < first + count; ++t) {
        const auto triangle = static_cast<std::uint32_t>(t);
        if (ranged && isBeyondRange(raysTo(triangle), from.range))
            faceOf_[t] = -1;
        else if (faceOf_[t] < 0)
            addParts(triangle, from);
    }
}

void FlatCasters::addParts(std::uint32_t triangle, const LightView& from) {
    for (std::size_t face = 0; face < from.faces.size(); ++face) {
        const FacePolygon polygon = polygonOn(from.faces[face], raysTo(triangle));
        if (polygon.count > 0 && !outlineOf(polygon.all()).misses(from.wholeFace()))
            parts_.push_back({triangle, face, polygon});
    }
}

} // namespace edgeshade
