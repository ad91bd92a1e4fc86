#pragma once

#include "src/lab/oracle.hpp"

#include <functional>
#include <vector>

namespace edgeshade::lab {

/// What the ray through a pixel's centre meets first.
struct PixelSurface {
    std::uint32_t triangle = 0; ///< of Oracle::triangles()
    double area = 0.0;          ///< of it, see footprintArea(); 0: the ray meets nothing
};

/// The cosine from which surfaces seen edge-on count as no more slanted: what a pixel shows of them
/// is at most a hundred times what it would show head-on.
inline constexpr double leastCosine = 0.01;

/// How much of the triangle's plane a pixel shows, in scene units squared, where its ray meets the
/// triangle at that depth: the pixel's solid angle, or an orthographic picture's pixel, laid onto
/// the plane.
double footprintArea(const Question& question, const EyeTriangle& triangle, const PixelRay& ray,
                     double depth);

/// Of all pixels, rows top to bottom, on all cores. `progress` as traceAll() has it.
std::vector<PixelSurface> pixelSurfaces(const Oracle& oracle,
                                        const std::function<void(double)>& progress);

} // namespace edgeshade::lab
