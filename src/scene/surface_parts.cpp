#include "src/scene/surface_parts.hpp"

#include <limits>

namespace edgeshade {
namespace {

constexpr std::size_t mostIndices = 3 * 4096; // the vertices, no more than that, fit 16 bits
constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

/// Collects triangles until a part is full.
class PartBuilder {
  public:
    PartBuilder(const Batch& batch, std::vector<SurfacePart>& parts)
        : parts_(parts), local_(batch.geometry->positions.size(), unused) {}

    void addTriangle(const std::uint32_t* corners) {
        if (part_.indices.size() == mostIndices) finish();
        for (int c = 0; c < 3; ++c) {
            std::uint32_t& local = local_[corners[c]];
            if (local == unused) {
                local = static_cast<std::uint32_t>(part_.vertices.size());
                part_.vertices.push_back(corners[c]);
            }
            part_.indices.push_back(static_cast<std::uint16_t>(local));
        }
    }

    void finish() {
        if (part_.indices.empty()) return;
        for (const std::uint32_t vertex : part_.vertices)
            local_[vertex] = unused;
        part_.material = material;
        parts_.push_back(std::move(part_));
        part_ = {};
    }

    std::size_t material = 0; ///< of the triangles being added

  private:
    std::vector<SurfacePart>& parts_;
    std::vector<std::uint32_t> local_; ///< vertex in the part, by vertex of the batch
    SurfacePart part_;
};

} // namespace

std::vector<SurfacePart> surfacePartsOf(const Batch& batch) {
    std::vector<SurfacePart> parts;
    PartBuilder builder(batch, parts);
    for (const SurfaceGroup& group : batch.geometry->groups) {
        builder.material = group.material;
        for (std::uint32_t i = 0; i + 2 < group.indexCount; i += 3)
            builder.addTriangle(&batch.geometry->indices[group.firstIndex + i]);
        builder.finish();
    }
    return parts;
}

} // namespace edgeshade
