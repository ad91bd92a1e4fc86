#include "src/scene/gpu_primitive_map.hpp"

#include <algorithm>
#include <bit>

namespace edgeshade {
namespace {

constexpr std::size_t shortestBound = 8;

GpuPrimitiveMap::Kind kindOf(const LightTiles& tiles) {
    if (tiles.directional) return GpuPrimitiveMap::Kind::directional;
    return tiles.tiles.size() == 1 ? GpuPrimitiveMap::Kind::oneTile
                                   : GpuPrimitiveMap::Kind::sixTiles;
}

SidedChunk uploadSided(const SidedTriangles& triangles) {
    SidedChunk chunk{triangles.lightSide, {}, {}, {}};
    if (chunk.lightSide != 0.0f) return chunk;
    chunk.vertices = gl::vertexBuffer<SidedVertex>(triangles.vertices);
    if (!triangles.details.empty())
        chunk.details = gl::vertexBuffer<SurfaceDetail>(triangles.details);
    chunk.indices =
        gl::Buffer(gl::Buffer::Kind::indices, std::as_bytes(std::span(triangles.indices)));
    return chunk;
}

} // namespace

std::size_t GpuPrimitiveMap::bytes() const {
    std::size_t total = header.bytes() + entries.bytes() + records.bytes();
    for (const auto& batch : sided)
        for (const SidedChunk& chunk : batch)
            total += chunk.vertices.size() + chunk.details.size() + chunk.indices.size();
    return total;
}

GpuPrimitiveMap uploadPrimitiveMap(const PrimitiveMap& map,
                                   const std::vector<std::vector<SidedTriangles>>& triangles,
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
        auto& chunks = gpu.sided.emplace_back();
        for (const SidedTriangles& chunk : batch)
            chunks.push_back(uploadSided(chunk));
    }
    return gpu;
}

} // namespace edgeshade
