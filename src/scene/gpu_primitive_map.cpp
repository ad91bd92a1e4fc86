#include "src/scene/gpu_primitive_map.hpp"

#include <algorithm>
#include <bit>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr std::size_t shortestBound = 8;

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

AlphaTexture uploadAlpha(std::span<const std::uint8_t> alpha, int width, int height) {
    AlphaTexture made{gl::nearestTexture(), {width, height}, alpha.size()};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, width, height, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                 alpha.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    gl::requireNoError("uploading cutouts");
    return made;
}

GpuPrimitiveMap uploadPrimitiveMap(const PrimitiveMap& map,
                                   const std::vector<std::vector<SidedTriangles>>& triangles,
                                   std::shared_ptr<const AlphaTexture> cutouts,
                                   const gl::Capabilities& capabilities) {
    GpuPrimitiveMap gpu;
    if (map.cutouts) gpu.cutouts = std::move(cutouts);
    gpu.kind = kindOf(map.tiles);
    gpu.extended = map.extended;
    gpu.mapFromWorld = map.tiles.mapFromWorld;
    gpu.size = static_cast<float>(map.size);
    gpu.longestList = static_cast<int>(std::bit_ceil(std::max(map.longestList, shortestBound)));
    const std::span texels(map.texels);
    gpu.header = gl::FloatTable(texels, map.headers, capabilities);
    gpu.entries = gl::FloatTable(texels.subspan(map.entriesBegin()), map.entries, capabilities);
    gpu.records = gl::FloatTable(texels.subspan(map.recordsBegin()), capabilities);
    for (const auto& batch : triangles) {
        auto& chunks = gpu.sided.emplace_back();
        for (const SidedTriangles& chunk : batch)
            chunks.push_back(uploadSided(chunk));
    }
    return gpu;
}

} // namespace edgeshade
