#include "src/scene/surface_buffers.hpp"

#include "src/scene/srgb.hpp"

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

/// The batch's details of a vertex, with zeros for missing ones.
SurfaceDetail detailOf(const Batch& batch, std::uint32_t index) {
    SurfaceDetail detail{};
    if (!batch.geometry->tangents.empty()) detail.tangent = batch.geometry->tangents[index];
    for (std::size_t channel = 0; channel < batch.geometry->moreTexcoords.size(); ++channel)
        if (!batch.geometry->moreTexcoords[channel].empty())
            detail.texcoords[channel] = batch.geometry->moreTexcoords[channel][index];
    return detail;
}

/// Whether the material uses tangents and all of these vertices have one.
bool haveTangents(const Batch& batch, const Material& material,
                  const std::vector<std::uint32_t>& vertices) {
    return material.hasNormalTexture() && !batch.geometry->tangents.empty() &&
           std::all_of(vertices.begin(), vertices.end(),
                       [&](std::uint32_t v) { return batch.geometry->tangents[v].w != 0.0f; });
}

/// Whether some triangle's vertex normals differ from its own.
bool isSmooth(const Batch& batch, const SurfacePart& part) {
    constexpr float parallel = 0.9999f; // the cosine of less than a degree
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
        const auto vertex = [&](std::size_t c) { return part.vertices[part.indices[i + c]]; };
        const glm::vec3& a = batch.geometry->positions[vertex(0)];
        const glm::vec3 across = glm::cross(batch.geometry->positions[vertex(1)] - a,
                                            batch.geometry->positions[vertex(2)] - a);
        const float size = glm::length(across);
        if (!(size > 0.0f)) continue;
        for (std::size_t c = 0; c < 3; ++c)
            if (glm::dot(across, batch.geometry->normals[vertex(c)]) < parallel * size) return true;
    }
    return false;
}

/// Uploads the parts of a chunk that a shape may change.
void uploadVertices(const Batch& batch, const Material& material, const SurfacePart& part,
                    SurfaceChunk& chunk) {
    std::vector<SurfaceVertex> vertices;
    vertices.reserve(part.vertices.size());
    glm::dvec3 sum(0.0);
    chunk.bounds = {};
    for (const std::uint32_t index : part.vertices) {
        const SurfaceVertex& vertex = vertices.emplace_back(surfaceVertexOf(batch, index));
        sum += vertex.position;
        chunk.bounds.add(vertex.position);
        chunk.colored = chunk.colored || !isWhite(vertex);
    }
    chunk.center = glm::vec3(sum / static_cast<double>(vertices.size()));
    chunk.vertices = gl::vertexBuffer<SurfaceVertex>(vertices);
    chunk.tangents = haveTangents(batch, material, part.vertices);
    const std::vector<SurfaceDetail> details = surfaceDetailsOf(batch, material, part.vertices);
    if (!details.empty()) chunk.details = gl::vertexBuffer<SurfaceDetail>(details);
}

SurfaceChunk upload(const Batch& batch, const Material& material, const SurfacePart& part) {
    SurfaceChunk chunk;
    chunk.material = part.material;
    uploadVertices(batch, material, part, chunk);
    chunk.smooth = batch.deforms() || isSmooth(batch, part); // any shape may be smooth
    chunk.indices = gl::Buffer(gl::Buffer::Kind::indices, std::as_bytes(std::span(part.indices)));
    chunk.indexCount = static_cast<int>(part.indices.size());
    return chunk;
}

} // namespace

SurfaceVertex surfaceVertexOf(const Batch& batch, std::uint32_t index) {
    const glm::vec4& linear = batch.geometry->colors[index];
    const bool white = linear == glm::vec4(1.0f); // most are white, and powers take time
    const glm::vec4 color = white ? linear : srgbFromLinear(linear);
    return {batch.geometry->positions[index],
            batch.geometry->normals[index],
            batch.geometry->texcoords[index],
            {byteOf(color.r), byteOf(color.g), byteOf(color.b), byteOf(color.a)}};
}

std::vector<SurfaceDetail> surfaceDetailsOf(const Batch& batch, const Material& material,
                                            const std::vector<std::uint32_t>& vertices) {
    std::vector<SurfaceDetail> details;
    if (material.texcoordChannels == 1 && !haveTangents(batch, material, vertices)) return details;
    details.reserve(vertices.size());
    for (const std::uint32_t index : vertices)
        details.push_back(detailOf(batch, index));
    return details;
}

std::vector<SurfaceChunk> uploadSurfaces(const Batch& batch,
                                         const std::vector<Material>& materials) {
    std::vector<SurfaceChunk> chunks;
    for (const SurfacePart& part : surfacePartsOf(batch)) {
        chunks.push_back(upload(batch, materials[part.material], part));
        chunks.back().place = chunks.size() - 1;
    }
    return chunks;
}

void uploadShape(const Batch& batch, const std::vector<Material>& materials,
                 const std::vector<SurfacePart>& parts, std::vector<SurfaceChunk>& chunks) {
    for (std::size_t i = 0; i < parts.size(); ++i)
        uploadVertices(batch, materials[parts[i].material], parts[i], chunks[i]);
}

} // namespace edgeshade
