#include "src/scene/sided_triangles.hpp"

#include "src/scene/surface_parts.hpp"
#include "src/shadow/primitive_map/footprint.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace edgeshade {
namespace {

/// Of each triangle whether the light sees it counter-clockwise.
std::vector<bool> facingOf(const Batch& batch, const SurfacePart& part, const glm::dvec4& light) {
    const auto corner = [&](std::size_t i) {
        return glm::dvec3(batch.geometry->positions[part.vertices[part.indices[i]]]);
    };
    std::vector<bool> facing;
    facing.reserve(part.indices.size() / 3);
    for (std::size_t i = 0; i < part.indices.size(); i += 3)
        facing.push_back(lightSideOf({corner(i), corner(i + 1), corner(i + 2)}, light) > 0);
    return facing;
}

/// Numbers a part's vertices anew, apart for either side; twice as many as a part has fit 16 bits.
class SidedVertices {
  public:
    SidedVertices(const Batch& batch, const SurfacePart& part) : batch_(batch), part_(part) {
        for (auto& side : numbers_)
            side.assign(part.vertices.size(), none);
    }

    std::uint16_t numberOf(std::uint16_t vertex, bool facing) {
        std::uint16_t& number = numbers_[facing ? 1 : 0][vertex];
        if (number == none) {
            number = static_cast<std::uint16_t>(vertices_.size());
            sources_.push_back(part_.vertices[vertex]);
            vertices_.push_back({surfaceVertexOf(batch_, sources_.back()), facing ? 1.0f : -1.0f});
        }
        return number;
    }

    std::vector<SidedVertex> take() { return std::move(vertices_); }
    const std::vector<std::uint32_t>& sources() const { return sources_; } ///< of the batch

  private:
    static constexpr std::uint16_t none = std::numeric_limits<std::uint16_t>::max();

    const Batch& batch_;
    const SurfacePart& part_;
    std::array<std::vector<std::uint16_t>, 2> numbers_; ///< turned away, facing
    std::vector<SidedVertex> vertices_;
    std::vector<std::uint32_t> sources_;
};

SidedTriangles sided(const Batch& batch, const std::vector<Material>& materials,
                     const SurfacePart& part, const glm::dvec4& light) {
    const std::vector<bool> facing = facingOf(batch, part, light);
    SidedTriangles triangles;
    if (std::find(facing.begin(), facing.end(), !facing.front()) == facing.end()) {
        triangles.lightSide = facing.front() ? 1.0f : -1.0f;
        return triangles;
    }
    SidedVertices vertices(batch, part);
    triangles.indices.reserve(part.indices.size());
    for (std::size_t i = 0; i < part.indices.size(); ++i)
        triangles.indices.push_back(vertices.numberOf(part.indices[i], facing[i / 3]));
    triangles.details = surfaceDetailsOf(batch, materials[part.material], vertices.sources());
    triangles.vertices = vertices.take();
    return triangles;
}

} // namespace

std::vector<SidedTriangles> sidedTriangles(const Batch& batch,
                                           const std::vector<Material>& materials,
                                           const glm::dvec4& light) {
    std::vector<SidedTriangles> all;
    for (const SurfacePart& part : surfacePartsOf(batch))
        all.push_back(sided(batch, materials, part, light));
    return all;
}

} // namespace edgeshade
