#pragma once

#include "src/hours/surfaces/surface_run.hpp"

#include <optional>

namespace edgeshade::hours {

/// A colour as 0xRRGGBB, in display values.
using DisplayColor = std::uint32_t;

/// A picture of cells on their scene, parallel, with the scene in grey on white.
struct CellsPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba; ///< rows top to bottom
    /// Where each cell's sensor is, in pixels; null: it faces away, or something hides it.
    std::vector<std::optional<glm::dvec2>> places;
};

/// Draws on the processor. `scene`: all triangles. `towardsEye`: of length 1, not straight up or
/// down; +Y is up in the picture. `width`, `height`: of the picture, above 0; the cells fill it,
/// with some of their surroundings if they are a part of the scene.
CellsPicture pictureOf(const SurfaceRun& run, std::span<const WorldTriangle> scene,
                       const std::function<DisplayColor(std::size_t cell)>& color,
                       const glm::dvec3& towardsEye, int width, int height);

} // namespace edgeshade::hours
