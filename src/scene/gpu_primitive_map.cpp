#include "src/scene/gpu_primitive_map.hpp"

#include "src/shadow/primitive_map/footprint.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

namespace edgeshade {
namespace {

constexpr std::size_t shortestBound = 8;

GpuPrimitiveMap::Kind kindOf(const LightTiles& tiles) {
    if (tiles.directional) return GpuPrimitiveMap::Kind::directional;
    return tiles.tiles.size() == 1 ? GpuPrimitiveMap::Kind::oneTile
                                   : GpuPrimitiveMap::Kind::sixTiles;
}

/// A triangle's corners, whatever their order.
using CornerSet = std::array<std::array<float, 3>, 3>;

CornerSet cornerSetOf(const Batch& batch, const SurfacePart& part, std::size_t triangle) {
    CornerSet corners;
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::vec3& at = batch.positions[part.vertices[part.indices[3 * triangle + c]]];
        corners[c] = {at.x, at.y, at.z};
    }
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// For each triangle the first one with the same corners: often itself.
std::vector<std::size_t> firstTwins(const Batch& batch, const SurfacePart& part) {
    const std::size_t count = part.indices.size() / 3;
    std::vector<CornerSet> corners(count);
    std::vector<std::size_t> order(count), first(count);
    for (std::size_t t = 0; t < count; ++t)
        corners[t] = cornerSetOf(batch, part, order[t] = t);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(corners[a], a) < std::tie(corners[b], b);
    });
    for (std::size_t i = 0; i < count; ++i) {
        const bool isTwin = i > 0 && corners[order[i - 1]] == corners[order[i]];
        first[order[i]] = isTwin ? first[order[i - 1]] : order[i];
    }
    return first;
}

} // namespace

std::vector<SortedTriangles> sortedByFacing(const Batch& batch, const glm::dvec4& light) {
    std::vector<SortedTriangles> sorted;
    for (const SurfacePart& part : surfacePartsOf(batch)) {
        const std::size_t count = part.indices.size() / 3;
        std::vector<bool> faces(count), hides(count, false); // a later twin that faces the light
        const std::vector<std::size_t> first = firstTwins(batch, part);
        for (std::size_t t = 0; t < count; ++t) {
            const auto at = [&](std::size_t c) {
                return glm::dvec3(batch.positions[part.vertices[part.indices[3 * t + c]]]);
            };
            faces[t] = lightSideOf({at(0), at(1), at(2)}, light) > 0;
            if (faces[t] && !faces[first[t]]) hides[first[t]] = true;
        }
        std::vector<std::uint16_t> before, facing, after;
        for (std::size_t t = 0; t < count; ++t) {
            auto& kind = faces[t] ? facing : hides[t] ? before : after;
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
