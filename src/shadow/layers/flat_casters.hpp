#pragma once

#include "preprocess/mesh/topology.hpp"
#include "src/shadow/lights/light_view.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// The casting triangles as a light sees them, flattened onto its faces. Triangles are counted in
/// the order of batches and their casters; those out of the light's range are on no face.
class FlatCasters {
  public:
    FlatCasters(const Scene& scene, bool castMasked, const LightView& from);

    using Corners = std::array<glm::dvec2, 3>; ///< (u, v)

    /// What a face holds of a triangle that is on no face wholly, with some room to spare.
    struct Part {
        std::uint32_t triangle;
        std::size_t face;
        FacePolygon polygon;
    };

    std::size_t count() const { return faceOf_.size(); }
    /// The face that wholly holds a triangle; -1: none does, or it is out of range.
    int faceOf(std::uint32_t triangle) const { return faceOf_[triangle]; }
    /// Of such a triangle, on that face.
    Corners cornersOf(std::uint32_t triangle) const {
        const auto& [a, b, c] = places_[triangle];
        return {points_[a], points_[b], points_[c]};
    }
    /// From the light to the corners of any triangle.
    std::array<glm::dvec3, 3> raysTo(std::uint32_t triangle) const {
        const auto& [a, b, c] = places_[triangle];
        return {rays_[a], rays_[b], rays_[c]};
    }
    /// Of all others within range.
    const std::vector<Part>& parts() const { return parts_; }

  private:
    void addVertices(const Batch& batch, const LightView& from);
    void addTriangles(const Casters& casters, std::size_t firstVertex, const LightView& from);
    void addParts(std::uint32_t triangle, const LightView& from);

    std::vector<glm::dvec3> rays_;    ///< to vertices
    std::vector<glm::dvec2> points_;  ///< likewise, each on the face that it is on
    std::vector<std::int8_t> faceAt_; ///< likewise, that face; -1: none with room to spare
    std::vector<std::array<std::uint32_t, 3>> places_; ///< of triangles among the vertices
    std::vector<std::int8_t> faceOf_;
    std::vector<Part> parts_;
};

} // namespace edgeshade
