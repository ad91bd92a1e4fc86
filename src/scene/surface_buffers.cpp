#include "src/scene/surface_buffers.hpp"

#include "src/scene/srgb.hpp"

#include <algorithm>
#include <limits>

namespace edgeshade {
namespace {

constexpr std::size_t mostIndices = 3 * 4096; // so no more vertices either, which 16 bits hold
constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(glm::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

SurfaceVertex vertexOf(const Batch& batch, std::uint32_t index) {
    const glm::vec4 color = srgbFromLinear(batch.colors[index]);
    return {batch.positions[index],
            batch.normals[index],
            batch.texcoords[index],
            {byteOf(color.r), byteOf(color.g), byteOf(color.b), byteOf(color.a)}};
}

bool isWhite(const SurfaceVertex& vertex) {
    return std::all_of(std::begin(vertex.color), std::end(vertex.color),
                       [](std::uint8_t value) { return value == 255; });
}

/// Collects triangles until a chunk is full.
class ChunkBuilder {
  public:
    ChunkBuilder(const Batch& batch, std::vector<SurfaceChunk>& chunks)
        : batch_(batch), chunks_(chunks), local_(batch.positions.size(), unused) {}

    void addTriangle(const std::uint32_t* corners) {
        if (indices_.size() == mostIndices) finish();
        for (int c = 0; c < 3; ++c) {
            std::uint32_t& local = local_[corners[c]];
            if (local == unused) {
                local = static_cast<std::uint32_t>(vertices_.size());
                vertices_.push_back(vertexOf(batch_, corners[c]));
                taken_.push_back(corners[c]);
            }
            indices_.push_back(static_cast<std::uint16_t>(local));
        }
    }

    void finish() {
        if (indices_.empty()) return;
        SurfaceChunk chunk;
        chunk.material = material;
        chunk.vertices = gl::vertexBuffer<SurfaceVertex>(vertices_);
        chunk.indices = gl::Buffer(gl::Buffer::Kind::indices, std::as_bytes(std::span(indices_)));
        chunk.indexCount = static_cast<int>(indices_.size());
        glm::dvec3 sum(0.0);
        for (const SurfaceVertex& vertex : vertices_) {
            sum += vertex.position;
            chunk.bounds.add(vertex.position);
            chunk.colored = chunk.colored || !isWhite(vertex);
        }
        chunk.center = glm::vec3(sum / static_cast<double>(vertices_.size()));
        chunks_.push_back(std::move(chunk));
        for (const std::uint32_t index : taken_)
            local_[index] = unused;
        vertices_.clear();
        indices_.clear();
        taken_.clear();
    }

    std::size_t material = 0; ///< of the triangles added now

  private:
    const Batch& batch_;
    std::vector<SurfaceChunk>& chunks_;
    std::vector<std::uint32_t> local_; ///< batch vertex to chunk vertex
    std::vector<std::uint32_t> taken_; ///< batch vertices in the chunk
    std::vector<SurfaceVertex> vertices_;
    std::vector<std::uint16_t> indices_;
};

} // namespace

std::vector<SurfaceChunk> uploadSurfaces(const Batch& batch) {
    std::vector<SurfaceChunk> chunks;
    ChunkBuilder builder(batch, chunks);
    for (const SurfaceGroup& group : batch.groups) {
        builder.material = group.material;
        for (std::uint32_t i = 0; i + 2 < group.indexCount; i += 3)
            builder.addTriangle(&batch.indices[group.firstIndex + i]);
        builder.finish();
    }
    return chunks;
}

} // namespace edgeshade
