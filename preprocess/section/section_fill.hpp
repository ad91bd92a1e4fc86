#pragma once

#include "preprocess/section/geometry_cut.hpp"

namespace edgeshade {

/// Triangles that close the cut of solids, as seen from the side that the plane cuts away
/// counter-clockwise: everywhere that the lines wind around, whatever their sense. `lines`: of
/// GeometryCut::cut(), whose corners the triangles share, so that solids are closed again. Where
/// lines cross, vertices are added to `geometry`; `positions` alone, other attributes stay short.
/// Throws Error(unavailable) if memory runs out.
std::vector<std::array<std::uint32_t, 3>> fillOf(const std::vector<CutLine>& lines,
                                                 const glm::dvec4& plane, Geometry& geometry);

} // namespace edgeshade
