#pragma once

#include "preprocess/base/box.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// Casting triangles in runs of neighbours; each run has its own vertices and a box around them.
class CasterRuns {
  public:
    static constexpr std::size_t length = 32; ///< most triangles in a run

    using Triangle = std::array<std::uint8_t, 3>; ///< indices of its corners among its run's
                                                  ///< vertices

    struct Run {
        Box bounds;
        std::uint32_t firstVertex = 0, vertexCount = 0;
        std::uint32_t firstTriangle = 0, triangleCount = 0;
    };

    CasterRuns() = default;
    /// `indices`: three per triangle.
    CasterRuns(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

    const std::vector<Run>& runs() const { return runs_; }
    std::span<const glm::vec3> verticesOf(const Run& run) const {
        return std::span(vertices_).subspan(run.firstVertex, run.vertexCount);
    }
    std::span<const Triangle> trianglesOf(const Run& run) const {
        return std::span(triangles_).subspan(run.firstTriangle, run.triangleCount);
    }

  private:
    std::vector<Run> runs_;
    std::vector<glm::vec3> vertices_;
    std::vector<Triangle> triangles_;
};

} // namespace edgeshade
