#include "src/scene/sided_triangles.hpp"

#include "src/scene/surface_parts.hpp"
#include "src/shadow/lights/light_contact.hpp"
#include "src/shadow/lights/light_range.hpp"
#include "src/shadow/primitive_map/footprint.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace edgeshade {
namespace {

constexpr int grazedSide = 2; ///< SidedVertex::lightSide

/// SidedVertex::lightSide of each triangle; triangles out of range repeat the value before them.
std::vector<int> sidesOf(const Batch& batch, const SurfacePart& part, const LightShape& light,
                         bool extended, double range) {
    const auto corner = [&](std::size_t i) {
        return glm::dvec3(batch.geometry->positions[part.vertices[part.indices[i]]]);
    };
    std::vector<int> sides;
    sides.reserve(part.indices.size() / 3);
    std::size_t unasked = 0; // triangles before the first within range
    for (std::size_t i = 0; i < part.indices.size(); i += 3) {
        const std::array<glm::dvec3, 3> corners = {corner(i), corner(i + 1), corner(i + 2)};
        if (areBeyond(corners, glm::dvec3(light.center), range)) {
            if (unasked == sides.size()) ++unasked;
            sides.push_back(sides.empty() ? 1 : sides.back());
            continue;
        }
        sides.push_back(extended                                  ? sideOfAll(corners, light)
                        : contactOf(corners, light.center).grazes ? grazedSide
                        : lightSideOf(corners, light.center) > 0  ? 1
                                                                  : -1);
    }
    if (unasked < sides.size()) std::fill_n(sides.begin(), unasked, sides[unasked]);
    return sides;
}

/// Renumbers a part's vertices, separately for each side. Four times the vertices of a part still
/// fit 16 bits.
class SidedVertices {
  public:
    SidedVertices(const Batch& batch, const SurfacePart& part) : batch_(batch), part_(part) {
        for (auto& side : numbers_)
            side.assign(part.vertices.size(), none);
    }

    std::uint16_t numberOf(std::uint16_t vertex, int side) {
        std::uint16_t& number = numbers_[static_cast<std::size_t>(side + 1)][vertex];
        if (number == none) {
            number = static_cast<std::uint16_t>(vertices_.size());
            sources_.push_back(part_.vertices[vertex]);
            vertices_.push_back(
                {surfaceVertexOf(batch_, sources_.back()), static_cast<float>(side)});
        }
        return number;
    }

    std::vector<SidedVertex> take() { return std::move(vertices_); }
    const std::vector<std::uint32_t>& sources() const { return sources_; } ///< indices in the batch

  private:
    static constexpr std::uint16_t none = std::numeric_limits<std::uint16_t>::max();

    const Batch& batch_;
    const SurfacePart& part_;
    std::array<std::vector<std::uint16_t>, 4> numbers_; ///< facing away, neither, facing, grazed
    std::vector<SidedVertex> vertices_;
    std::vector<std::uint32_t> sources_;
};

SidedTriangles sided(const Batch& batch, const std::vector<Material>& materials,
                     const SurfacePart& part, const LightShape& light, bool extended,
                     double range) {
    const std::vector<int> sides = sidesOf(batch, part, light, extended, range);
    SidedTriangles triangles;
    const bool alike =
        std::all_of(sides.begin(), sides.end(), [&](int side) { return side == sides.front(); });
    if (alike && sides.front() != 0) {
        triangles.lightSide = static_cast<float>(sides.front());
        return triangles;
    }
    SidedVertices vertices(batch, part);
    triangles.indices.reserve(part.indices.size());
    for (std::size_t i = 0; i < part.indices.size(); ++i)
        triangles.indices.push_back(vertices.numberOf(part.indices[i], sides[i / 3]));
    triangles.details = surfaceDetailsOf(batch, materials[part.material], vertices.sources());
    triangles.vertices = vertices.take();
    return triangles;
}

} // namespace

std::vector<SidedTriangles> sidedTriangles(const Batch& batch,
                                           const std::vector<Material>& materials,
                                           const LightShape& light, bool extended, double range) {
    std::vector<SidedTriangles> all;
    for (const SurfacePart& part : surfacePartsOf(batch))
        all.push_back(sided(batch, materials, part, light, extended, range));
    return all;
}

} // namespace edgeshade
