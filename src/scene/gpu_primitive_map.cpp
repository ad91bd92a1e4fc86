#include "src/scene/gpu_primitive_map.hpp"

#include "src/shadow/primitive_map/footprint.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

namespace edgeshade {
namespace {

constexpr std::size_t shortestBound = 8;

GpuPrimitiveMap::Kind kindOf(const LightTiles& tiles) {
    if (tiles.directional) return GpuPrimitiveMap::Kind::directional;
    return tiles.tiles.size() == 1 ? GpuPrimitiveMap::Kind::oneTile
                                   : GpuPrimitiveMap::Kind::sixTiles;
}

/// A plane whichever way it faces, on a grid that is coarse beside rounding and fine beside models.
using PlaneKey = std::array<std::int64_t, 4>;
constexpr double planeGrid = 1e5; // of normals, and of distances as shares of the part's size

PlaneKey planeKeyOf(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& origin,
                    double size) {
    glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(normal);
    if (!(length > 0.0)) return {};
    normal /= length;
    double distance = glm::dot(normal, corners[0] - origin) / size;
    PlaneKey key;
    for (glm::length_t i = 0; i < 3; ++i)
        key[static_cast<std::size_t>(i)] = std::llround(planeGrid * normal[i]);
    key[3] = std::llround(planeGrid * distance);
    const PlaneKey turned = {-key[0], -key[1], -key[2], -key[3]};
    return std::max(key, turned);
}

/// A part's triangles and what a light makes of them.
class FacedTriangles {
  public:
    FacedTriangles(const Batch& batch, const SurfacePart& part, const glm::dvec4& light)
        : batch_(batch), part_(part), faces_(part.indices.size() / 3), planes_(faces_.size()) {
        Box bounds;
        for (const std::uint32_t vertex : part.vertices)
            bounds.add(batch.positions[vertex]);
        const double size = std::max(bounds.diagonal(), 1e-300);
        for (std::size_t t = 0; t < faces_.size(); ++t) {
            const auto corners = cornersOf(t);
            faces_[t] = lightSideOf(corners, light) > 0;
            planes_[t] = planeKeyOf(corners, bounds.center(), size);
        }
    }

    std::size_t count() const { return faces_.size(); }
    bool facesLight(std::size_t triangle) const { return faces_[triangle]; }

    /// Of each triangle whether it is turned away and before the first one in its plane that isn't:
    /// where they coincide it is seen.
    std::vector<bool> beforeFacing() const {
        std::vector<std::size_t> order(count());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return std::tie(planes_[a], a) < std::tie(planes_[b], b);
        });
        std::vector<bool> before(count(), false);
        for (std::size_t first = 0; first < count();) {
            std::size_t end = first;
            while (end < count() && planes_[order[end]] == planes_[order[first]])
                ++end;
            std::size_t facing = first;
            while (facing < end && !faces_[order[facing]])
                ++facing;
            for (std::size_t i = first; i < facing && facing < end; ++i)
                before[order[i]] = true;
            first = end;
        }
        return before;
    }

  private:
    std::array<glm::dvec3, 3> cornersOf(std::size_t triangle) const {
        const auto at = [&](std::size_t c) {
            return glm::dvec3(batch_.positions[part_.vertices[part_.indices[3 * triangle + c]]]);
        };
        return {at(0), at(1), at(2)};
    }

    const Batch& batch_;
    const SurfacePart& part_;
    std::vector<bool> faces_;
    std::vector<PlaneKey> planes_;
};

} // namespace

std::vector<SortedTriangles> sortedByFacing(const Batch& batch, const glm::dvec4& light) {
    std::vector<SortedTriangles> sorted;
    for (const SurfacePart& part : surfacePartsOf(batch)) {
        const FacedTriangles triangles(batch, part, light);
        const std::vector<bool> hides = triangles.beforeFacing();
        std::vector<std::uint16_t> before, facing, after;
        for (std::size_t t = 0; t < triangles.count(); ++t) {
            auto& kind = triangles.facesLight(t) ? facing : hides[t] ? before : after;
            kind.insert(kind.end(), &part.indices[3 * t], &part.indices[3 * t] + 3);
        }
        SortedTriangles& of = sorted.emplace_back();
        of.before = before.size();
        of.facing = facing.size();
        for (const auto& kind : {before, facing, after})
            of.indices.insert(of.indices.end(), kind.begin(), kind.end());
    }
    return sorted;
}

std::size_t GpuPrimitiveMap::bytes() const {
    std::size_t total = header.bytes() + entries.bytes() + records.bytes();
    for (const auto& batch : facings)
        for (const FacingIndices& chunk : batch)
            total += chunk.indices.size();
    return total;
}

GpuPrimitiveMap uploadPrimitiveMap(const PrimitiveMap& map,
                                   const std::vector<std::vector<SortedTriangles>>& triangles,
                                   const gl::Capabilities& capabilities) {
    GpuPrimitiveMap gpu;
    gpu.kind = kindOf(map.tiles);
    gpu.mapFromWorld = map.tiles.mapFromWorld;
    gpu.size = static_cast<float>(map.size);
    gpu.splits = map.splits;
    gpu.longestList = static_cast<int>(std::bit_ceil(std::max(map.longestList, shortestBound)));
    gpu.header = gl::FloatTable(std::span(map.header), capabilities);
    gpu.entries = gl::FloatTable(std::span(map.entries), capabilities);
    gpu.records = gl::FloatTable(std::span(map.records), capabilities);
    for (const auto& batch : triangles) {
        auto& chunks = gpu.facings.emplace_back();
        for (const SortedTriangles& chunk : batch)
            chunks.push_back(
                {gl::Buffer(gl::Buffer::Kind::indices, std::as_bytes(std::span(chunk.indices))),
                 static_cast<int>(chunk.before), static_cast<int>(chunk.facing),
                 static_cast<int>(chunk.indices.size() - chunk.before - chunk.facing)});
    }
    return gpu;
}

} // namespace edgeshade
