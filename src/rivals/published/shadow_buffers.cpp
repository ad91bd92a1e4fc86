#include "src/rivals/published/shadow_buffers.hpp"

#include "shaders_es2/record_layout.glsl"

#include <algorithm>

namespace edgeshade {
namespace {

constexpr std::size_t largestBuffer = std::size_t{32} << 20; // bytes, for copied records

/// Number of records that fit into a chunk if each is copied for each of its vertices.
std::size_t recordsPerChunk(std::size_t vectorsPerRecord, std::size_t verticesPerRecord) {
    return std::max<std::size_t>(1, largestBuffer /
                                        (vectorsPerRecord * verticesPerRecord * sizeof(glm::vec4)));
}

void uploadSides(const SidesData& sides, SidesLayout layout, std::vector<RecordChunk>& chunks) {
    if (sides.records.empty()) return;
    if (layout != SidesLayout::notInstanced) {
        chunks.push_back({gl::vertexBuffer<glm::vec4>(sides.records), 0, sides.recordCount()});
        return;
    }
    const std::size_t limit =
        recordsPerChunk(sides.vectorsPerRecord(),
                        static_cast<std::size_t>(sides.maxMultiplicity) * VERTICES_PER_SIDE);
    for (std::size_t first = 0; first < sides.recordCount(); first += limit) {
        const std::size_t count = std::min(limit, sides.recordCount() - first);
        chunks.push_back(
            {gl::vertexBuffer<glm::vec4>(expandSides(sides, first, count)), first, count});
    }
}

/// `vertices`: vertex shader runs per record.
void uploadCaps(const CapsData& caps, SidesLayout layout, int vertices,
                std::vector<RecordChunk>& chunks) {
    if (caps.records.empty()) return;
    if (layout != SidesLayout::notInstanced) {
        chunks.push_back({gl::vertexBuffer<glm::vec4>(caps.records), 0, caps.recordCount()});
        return;
    }
    const std::size_t limit =
        recordsPerChunk(CapsData::vectorsPerRecord, static_cast<std::size_t>(vertices));
    for (std::size_t first = 0; first < caps.recordCount(); first += limit) {
        const std::size_t count = std::min(limit, caps.recordCount() - first);
        chunks.push_back(
            {gl::vertexBuffer<glm::vec4>(expandCaps(caps, first, count, vertices)), first, count});
    }
}

gl::Buffer uploadAlphaCorners(const std::vector<glm::vec4>& corners, SidesLayout layout,
                              int vertices) {
    constexpr std::size_t perRecord = 3;
    if (corners.empty()) return {};
    if (layout != SidesLayout::notInstanced) return gl::vertexBuffer<glm::vec4>(corners);
    std::vector<glm::vec4> copies;
    copies.reserve(corners.size() * static_cast<std::size_t>(vertices));
    for (std::size_t i = 0; i < corners.size(); i += perRecord)
        for (int vertex = 0; vertex < vertices; ++vertex)
            copies.insert(copies.end(), &corners[i], &corners[i] + perRecord);
    return gl::vertexBuffer<glm::vec4>(copies);
}

std::size_t bytesOf(const std::vector<RecordChunk>& chunks) {
    std::size_t total = 0;
    for (const RecordChunk& chunk : chunks)
        total += chunk.buffer.size();
    return total;
}

} // namespace

std::size_t ShadowBuffers::sideBytes() const {
    return bytesOf(sides);
}

std::size_t ShadowBuffers::capBytes() const {
    return bytesOf(caps) + alphaCorners.size();
}

OppositeVertexRecords ShadowBuffers::records() const {
    OppositeVertexRecords records{0, maxMultiplicity, groups};
    for (const RecordChunk& chunk : sides)
        records.sides += static_cast<std::uint32_t>(chunk.recordCount);
    return records;
}

ShadowBuffers uploadShadow(const BatchShadow& shadow, const std::vector<glm::vec4>& alphaCorners,
                           SidesLayout layout) {
    ShadowBuffers buffers;
    buffers.maxMultiplicity = shadow.sides.maxMultiplicity;
    buffers.groups = shadow.groups;
    uploadSides(shadow.sides, layout, buffers.sides);
    uploadCaps(shadow.caps, layout, VERTICES_PER_CAP_PAIR, buffers.caps);
    buffers.alphaCorners = uploadAlphaCorners(alphaCorners, layout, VERTICES_PER_CAP_PAIR);
    return buffers;
}

ShadowBuffers uploadTriangles(const CasterMesh& mesh, const std::vector<glm::vec4>& alphaCorners,
                              SidesLayout layout) {
    ShadowBuffers buffers;
    buffers.groups = mesh.groups;
    uploadCaps(buildCaps(mesh.welded), layout, VERTICES_PER_TRIANGLE_VOLUME, buffers.caps);
    buffers.alphaCorners = uploadAlphaCorners(alphaCorners, layout, VERTICES_PER_TRIANGLE_VOLUME);
    return buffers;
}

} // namespace edgeshade
