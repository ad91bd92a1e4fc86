#include "src/shadow/layers/closer_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

constexpr int deepest = 12;  // most halvings of a face's side
constexpr int stepDepth = 2; // halvings per finer grid
constexpr double rounding = 1e-12;

/// A convex cone of three rays, as seen from the light; for a directional light, points (x, y, 1)
/// of the plane across its direction. `sides` are the planes between neighbouring rays, positive
/// inside.
struct TriangleCone {
    std::array<glm::dvec3, 3> rays;
    std::array<glm::dvec3, 3> sides;

    explicit TriangleCone(const std::array<glm::dvec3, 3>& corners) : rays(corners) {
        for (std::size_t i = 0; i < 3; ++i) {
            sides[i] = glm::cross(rays[i], rays[(i + 1) % 3]);
            if (glm::dot(sides[i], rays[(i + 2) % 3]) < 0.0) sides[i] = -sides[i];
        }
    }
};

/// A cell of directions: a rectangle on a face of a cube around the light.
struct Cell {
    glm::dmat3 face; ///< columns: u axis, v axis, outward axis
    double u0, u1, v0, v1;

    Cell(const glm::dmat3& onFace, const Outline& part)
        : face(onFace), u0(part.u0), u1(part.u1), v0(part.v0), v1(part.v1) {}

    std::array<glm::dvec3, 4> corners() const {
        return {face * glm::dvec3(u0, v0, 1.0), face * glm::dvec3(u1, v0, 1.0),
                face * glm::dvec3(u1, v1, 1.0), face * glm::dvec3(u0, v1, 1.0)};
    }
    /// Planes through the cell's sides and the light, positive inside.
    std::array<glm::dvec3, 4> sides() const {
        return {face * glm::dvec3(1.0, 0.0, -u0), face * glm::dvec3(-1.0, 0.0, u1),
                face * glm::dvec3(0.0, 1.0, -v0), face * glm::dvec3(0.0, -1.0, v1)};
    }
};

double magnitude(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// Whether all vectors are outside the plane by more than rounding.
template <std::size_t N>
bool allOutside(const glm::dvec3& plane, const std::array<glm::dvec3, N>& vectors) {
    for (const glm::dvec3& vector : vectors)
        if (glm::dot(plane, vector) >= -rounding * magnitude(plane) * magnitude(vector))
            return false;
    return true;
}

/// Whether the cones may share a direction: no side of either separates them.
bool mayTouch(const TriangleCone& triangle, const std::array<glm::dvec3, 4>& corners,
              const std::array<glm::dvec3, 4>& sides) {
    for (const glm::dvec3& side : sides)
        if (allOutside(side, triangle.rays)) return false;
    for (const glm::dvec3& side : triangle.sides)
        if (allOutside(side, corners)) return false;
    return true;
}

/// Whether a convex polygon certainly contains a whole part of its face. Dividing the part can't
/// then separate it from other such polygons.
bool covers(std::span<const glm::dvec2> polygon, const Outline& part) {
    const std::array corners{glm::dvec2(part.u0, part.v0), glm::dvec2(part.u1, part.v0),
                             glm::dvec2(part.u1, part.v1), glm::dvec2(part.u0, part.v1)};
    bool left = true, right = true;
    for (std::size_t i = 0; i < polygon.size() && (left || right); ++i) {
        const glm::dvec2 from = polygon[i], along = polygon[(i + 1) % polygon.size()] - from;
        for (const glm::dvec2& corner : corners) {
            const glm::dvec2 to = corner - from;
            const double side = along.x * to.y - along.y * to.x;
            left = left && side > 0.0;
            right = right && side < 0.0;
        }
    }
    return left || right;
}

} // namespace

void CloserLook::at(const glm::dmat3& face, const CrowdedCell& cell, int depth,
                    std::size_t mostWork) {
    work_ = 0;
    mostWork_ = mostWork;
    refine(face, cell, depth);
}

void CloserLook::refine(const glm::dmat3& face, const CrowdedCell& cell, int depth) {
    work_ += cell.members.size();
    if (depth == deepest || work_ > mostWork_ || isCovered(cell)) return findTouching(face, cell);
    const int finer = std::min(stepDepth, deepest - depth);
    TouchGrid grid(cell.part, finer);
    for (const CellMember& member : cell.members)
        member.withPolygon(casters_, [&](auto polygon) { grid.add(polygon); });
    grid.sum();
    CrowdedCells crowded(grid, limit_, most_);
    if (crowded.empty()) return;
    for (const CellMember& member : cell.members)
        member.withPolygon(casters_, [&](auto polygon) { crowded.add(member, polygon, grid); });
    for (const CrowdedCell& one : crowded.all())
        refine(face, one, depth + finer);
}

/// Whether more than `limit` members contain the whole cell.
bool CloserLook::isCovered(const CrowdedCell& cell) const {
    std::size_t covering = 0;
    for (const CellMember& member : cell.members)
        member.withPolygon(casters_, [&](auto polygon) { covering += covers(polygon, cell.part); });
    return covering > limit_;
}

void CloserLook::findTouching(const glm::dmat3& face, const CrowdedCell& cell) {
    const Cell directions(face, cell.part);
    const auto corners = directions.corners();
    const auto sides = directions.sides();
    TriangleIndices touching;
    for (const CellMember& member : cell.members)
        if (mayTouch(TriangleCone(casters_.raysTo(member.triangle)), corners, sides))
            touching.push_back(member.triangle);
    most_ = std::max(most_, touching.size());
    if (touching.size() > limit_) crowded_.insert(std::move(touching));
}

} // namespace edgeshade
