#include "src/hours/surfaces/left_out_cells.hpp"

#include "preprocess/base/parallel.hpp"
#include "preprocess/base/vectors.hpp"
#include "preprocess/mesh/components.hpp"
#include "preprocess/mesh/topology.hpp"
#include "src/rays/ray_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace edgeshade::hours {
namespace {

/// Distance from a plane at which a point counts as on it, as a share of the largest coordinate: a
/// file's floats are rounded by 2^-24, typed decimals and batches' floats once more.
constexpr double onPlane = 4e-7;
/// Least cosine between the normals of surfaces that lie on each other.
constexpr double sameFacing = 0.999;
/// Cells that one thread tests at least.
constexpr std::size_t cellsOfThread = 256;

/// Directions of rays from a sensor, along its normal and two axes of its plane: in line with
/// nothing regular, so that two of three miss all edges.
constexpr std::array<glm::dvec2, 3> slants = {
    {{0.13719, 0.07133}, {-0.09173, 0.16391}, {0.02917, -0.19877}}};

/// Where the line from `point` meets the triangle's plane, in lengths of `direction`; no value if
/// it misses the triangle.
std::optional<double> meetingOf(const WorldTriangle& triangle, const glm::dvec3& point,
                                const glm::dvec3& direction) {
    const glm::dvec3 a = triangle.a - point, b = triangle.b - point, c = triangle.c - point;
    const double ab = glm::dot(direction, glm::cross(a, b)),
                 bc = glm::dot(direction, glm::cross(b, c)),
                 ca = glm::dot(direction, glm::cross(c, a));
    const bool inside =
        (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
    const glm::dvec3 normal = normalOf(triangle);
    const double slope = glm::dot(normal, direction);
    if (!inside || slope == 0.0) return std::nullopt;
    return glm::dot(normal, a) / slope;
}

rays::RayTree treeOf(std::span<const WorldTriangle> triangles) {
    std::vector<rays::Corners> corners;
    std::vector<std::uint32_t> all;
    for (const WorldTriangle& triangle : triangles) {
        all.push_back(static_cast<std::uint32_t>(corners.size()));
        corners.push_back({triangle.a, triangle.b, triangle.c});
    }
    return {corners, std::move(all)};
}

class LeftOut {
  public:
    LeftOut(const SurfaceCells& cells, std::span<const WorldTriangle> solids)
        : cells_(cells), solids_(solids), tolerance_(onPlane * reachOf(cells.triangles, solids)),
          chosenTree_(treeOf(cells.triangles)), solidTree_(treeOf(solids)) {}

    CellState stateOf(const Cell& cell) const {
        if (isInside(cell)) return CellState::inside;
        return isWithin(cell) ? CellState::within : CellState::counted;
    }

  private:
    static double reachOf(std::span<const WorldTriangle> some,
                          std::span<const WorldTriangle> more) {
        double farthest = 0.0;
        for (const auto& triangles : {some, more})
            for (const WorldTriangle& triangle : triangles)
                for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c})
                    farthest = std::max(farthest, largestComponent(corner));
        return farthest;
    }

    bool isInside(const Cell& cell) const {
        const glm::dvec3 aside = glm::normalize(
            glm::cross(cell.normal, std::abs(cell.normal.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0)
                                                                  : glm::dvec3(1.0, 0.0, 0.0)));
        const glm::dvec3 across = glm::cross(cell.normal, aside);
        int votes = 0;
        for (const glm::dvec2& slant : slants)
            votes += windingAlong(cell, cell.normal + slant.x * aside + slant.y * across) != 0;
        return votes >= 2;
    }

    /// The winding number just off the surface: exits of a ray from solids, less entries.
    int windingAlong(const Cell& cell, const glm::dvec3& direction) const {
        int winding = 0;
        constexpr double anyFar = std::numeric_limits<double>::infinity();
        solidTree_.visit(cell.point, direction, anyFar, [&](std::uint32_t t) {
            const std::optional<double> at = meetingOf(solids_[t], cell.point, direction);
            if (!at) return false;
            const glm::dvec3 normal = glm::normalize(normalOf(solids_[t]));
            const bool parallel = std::abs(glm::dot(normal, cell.normal)) > sameFacing;
            if (*at <= (parallel ? tolerance_ : 0.0)) return false;
            winding += glm::dot(normal, direction) > 0.0 ? 1 : -1;
            return false;
        });
        return winding;
    }

    bool isWithin(const Cell& cell) const {
        const glm::dvec3 foot = cells_.footOf(cell);
        bool within = false;
        const glm::dvec3 below = foot - tolerance_ * cell.normal;
        chosenTree_.visit(below, cell.normal, 2.0 * tolerance_, [&](std::uint32_t t) {
            if (t >= cell.triangle || cells_.patchOf[t] == cells_.patchOf[cell.triangle])
                return false;
            const WorldTriangle& other = cells_.triangles[t];
            const glm::dvec3 normal = normalOf(other);
            const double length = glm::length(normal);
            if (!(length > 0.0) || glm::dot(normal, cell.normal) < sameFacing * length)
                return false;
            // One direction for all triangles: no point falls between two neighbours.
            const std::optional<double> at = meetingOf(other, foot, cell.normal);
            within = at && std::abs(*at) <= tolerance_;
            return within;
        });
        return within;
    }

    const SurfaceCells& cells_;
    std::span<const WorldTriangle> solids_;
    double tolerance_; ///< in scene units
    rays::RayTree chosenTree_, solidTree_;
};

void addSolids(const Scene& scene, std::uint32_t number, bool castMasked,
               std::vector<WorldTriangle>& to) {
    const Batch& batch = scene.batches[number];
    const Geometry& geometry = *batch.geometry;
    const Casters casters = castingSurfacesOf(geometry, scene.materials, castMasked);
    const WeldedMesh mesh = weld(geometry.positions, casters.indices);
    const Components components = findComponents(mesh, buildEdges(mesh));
    const bool mirrored = batch.isMirrored();
    WorldTriangle triangle;
    triangle.batch = number;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (components.closed[components.ofTriangle[t]] == 0) continue;
        const auto corner = [&](std::size_t i) {
            return glm::dvec3(batch.worldFromBatch *
                              glm::dvec4(mesh.positions[mesh.triangles[t][i]], 1.0));
        };
        triangle.a = corner(0);
        triangle.b = corner(mirrored ? 2 : 1);
        triangle.c = corner(mirrored ? 1 : 2);
        if (areaOf(triangle) > 0.0) to.push_back(triangle);
    }
}

} // namespace

std::vector<WorldTriangle> solidSurfaces(const Scene& scene, bool castMasked) {
    std::vector<WorldTriangle> solids;
    for (std::uint32_t b = 0; b < scene.batches.size(); ++b)
        if (!scene.batches[b].ground && !scene.batches[b].hidden)
            addSolids(scene, b, castMasked, solids);
    return solids;
}

void markLeftOut(SurfaceCells& cells, std::span<const WorldTriangle> solids) {
    const LeftOut leftOut(cells, solids);
    forEachItem(cells.cells.size(), cellsOfThread, {},
                [&](std::size_t i) { cells.cells[i].state = leftOut.stateOf(cells.cells[i]); });
}

} // namespace edgeshade::hours
