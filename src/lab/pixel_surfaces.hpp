#pragma once

#include "src/lab/oracle.hpp"

#include <functional>
#include <vector>

namespace edgeshade::lab {

/// The first surface on the ray through a pixel's centre.
struct PixelSurface {
    std::uint32_t triangle = 0; ///< index in Oracle::triangles()
    double area = 0.0; ///< of the pixel on it, see footprintArea(); 0: the ray meets nothing
};

/// Lower bound of the cosine of a surface's slant, for surfaces seen edge-on: a pixel's area on
/// them is at most a hundred times its area head-on.
inline constexpr double leastCosine = 0.01;

/// The area of the triangle's plane that a pixel shows, in scene units squared, if its ray meets
/// the triangle at that depth. It is the pixel's solid angle, or an orthographic picture's pixel,
/// projected onto the plane.
double footprintArea(const Question& question, const SurfaceTriangle& triangle, const PixelRay& ray,
                     double depth);

/// The surfaces of all pixels, rows top to bottom, on all cores; exact, as by surfaceExactly(), but
/// for cutouts. `progress` receives the
/// share done, from one thread.
std::vector<PixelSurface> pixelSurfaces(const Oracle& oracle,
                                        const std::function<void(double)>& progress);

} // namespace edgeshade::lab
