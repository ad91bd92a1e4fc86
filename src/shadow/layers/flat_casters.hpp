#pragma once

#include "preprocess/mesh/topology.hpp"
#include "src/shadow/lights/light_view.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// The casting triangles projected onto a light's faces. Triangles are in the order of batches and
/// their casters; those beyond the light's range are on no face.
class FlatCasters {
  public:
    FlatCasters(const Scene& scene, bool castMasked, const LightView& from);

    using Corners = std::array<glm::dvec2, 3>; ///< (u, v)

    /// The part on one face of a triangle that no face holds wholly, with a margin.
    struct Part {
        std::uint32_t triangle;
        std::size_t face;
        FacePolygon polygon;
    };

    std::size_t count() const { return faceOf_.size(); }
    /// The face that wholly holds a triangle; -1: none, or the triangle is out of range.
    int faceOf(std::uint32_t triangle) const { return faceOf_[triangle]; }
    /// The corners of such a triangle on its face.
    Corners cornersOf(std::uint32_t triangle) const {
        const auto& [a, b, c] = places_[triangle];
        return {points_[a], points_[b], points_[c]};
    }
    /// Rays from the light to the corners of any triangle.
    std::array<glm::dvec3, 3> raysTo(std::uint32_t triangle) const {
        const auto& [a, b, c] = places_[triangle];
        return {rays_[a], rays_[b], rays_[c]};
    }
    /// Parts of all other triangles within range.
    const std::vector<Part>& parts() const { return parts_; }

  private:
    void addVertices(const Batch& batch, const LightView& from);
    void addTriangles(const Casters& casters, std::size_t firstVertex, const LightView& from);
    void addParts(std::uint32_t triangle, const LightView& from);

    std::vector<glm::dvec3> rays_;    ///< to vertices
    std::vector<glm::dvec2> points_;  ///< of vertices, each on its own face
    std::vector<std::int8_t> faceAt_; ///< face of each vertex; -1: none holds it with a margin
    std::vector<std::array<std::uint32_t, 3>> places_; ///< indices of triangles' vertices
    std::vector<std::int8_t> faceOf_;
    std::vector<Part> parts_;
};

} // namespace edgeshade
