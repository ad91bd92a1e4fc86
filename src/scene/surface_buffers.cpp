#include "src/scene/surface_buffers.hpp"

#include "src/scene/srgb.hpp"
#include "src/scene/surface_parts.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(glm::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

bool isWhite(const SurfaceVertex& vertex) {
    return std::all_of(std::begin(vertex.color), std::end(vertex.color),
                       [](std::uint8_t value) { return value == 255; });
}

SurfaceChunk upload(const Batch& batch, const SurfacePart& part) {
    SurfaceChunk chunk;
    chunk.material = part.material;
    std::vector<SurfaceVertex> vertices;
    vertices.reserve(part.vertices.size());
    glm::dvec3 sum(0.0);
    for (const std::uint32_t index : part.vertices) {
        const SurfaceVertex& vertex = vertices.emplace_back(surfaceVertexOf(batch, index));
        sum += vertex.position;
        chunk.bounds.add(vertex.position);
        chunk.colored = chunk.colored || !isWhite(vertex);
    }
    chunk.center = glm::vec3(sum / static_cast<double>(vertices.size()));
    chunk.vertices = gl::vertexBuffer<SurfaceVertex>(vertices);
    chunk.indices = gl::Buffer(gl::Buffer::Kind::indices, std::as_bytes(std::span(part.indices)));
    chunk.indexCount = static_cast<int>(part.indices.size());
    return chunk;
}

} // namespace

SurfaceVertex surfaceVertexOf(const Batch& batch, std::uint32_t index) {
    const glm::vec4 color = srgbFromLinear(batch.colors[index]);
    return {batch.positions[index],
            batch.normals[index],
            batch.texcoords[index],
            {byteOf(color.r), byteOf(color.g), byteOf(color.b), byteOf(color.a)}};
}

std::vector<SurfaceChunk> uploadSurfaces(const Batch& batch) {
    std::vector<SurfaceChunk> chunks;
    for (const SurfacePart& part : surfacePartsOf(batch)) {
        chunks.push_back(upload(batch, part));
        chunks.back().place = chunks.size() - 1;
    }
    return chunks;
}

} // namespace edgeshade
