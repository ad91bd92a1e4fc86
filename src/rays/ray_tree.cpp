#include "src/rays/ray_tree.hpp"

#include "preprocess/base/box.hpp"
#include "preprocess/base/vectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeshade::rays {
namespace {

/// Half a unit in the last place of a float at 1.
constexpr double floatUnit = 0x1p-24;
/// How much wider than a triangle its box is, on each side, where all coordinates are at most 1:
/// the sum of all roundings between an exact ray and a tree's test of a box is less than half of it
/// (docs/method.md, C56).
constexpr double padding = 32.0 * floatUnit;
/// Coordinates up to which an origin counts as within the tree's box.
constexpr double largestOrigin = 1.0 + 2.0 * padding;
/// Coordinates up to which doubles move an origin to the tree's box with errors far below
/// `padding`.
constexpr double farthestOrigin = 0x1p20;

/// Where a ray's search ends, of a length in the tree's coordinates: rounding included.
float endOf(double length) {
    return static_cast<float>(std::min(length + padding * (1.0 + std::abs(length)), 1e9));
}

bool isFinite(const Corners& corners) {
    return edgeshade::isFinite(corners[0]) && edgeshade::isFinite(corners[1]) &&
           edgeshade::isFinite(corners[2]);
}

std::vector<std::uint32_t> finiteOf(std::span<const Corners> corners,
                                    std::vector<std::uint32_t> which) {
    std::erase_if(which, [&](std::uint32_t i) { return !isFinite(corners[i]); });
    return which;
}

} // namespace

RayTree::Space::Space(std::span<const Corners> corners, std::span<const std::uint32_t> which) {
    Box box;
    for (const std::uint32_t i : which)
        if (isFinite(corners[i]))
            for (const glm::dvec3& corner : corners[i])
                box.add(corner);
    if (box.empty()) return;
    center = 0.5 * box.low + 0.5 * box.high;
    const double reach =
        std::max(largestComponent(box.low - center), largestComponent(box.high - center));
    if (reach > 0.0) scale = std::ldexp(1.0, -std::ilogb(reach) - 1);
}

RayTree::RayTree(std::span<const Corners> corners, std::vector<std::uint32_t> which)
    : space_(corners, which), boxes_(finiteOf(corners, std::move(which)), [&](std::uint32_t i) {
          Box box;
          for (const glm::dvec3& corner : corners[i])
              box.add(space_.local(corner));
          return BoxTree::FloatBox{glm::vec3(box.low - padding), glm::vec3(box.high + padding)};
      }) {}

struct RayTree::Line {
    glm::dvec3 start;      ///< in the tree's coordinates, within its box or close to it
    glm::dvec3 along;      ///< of length 1
    double scale = 0.0;    ///< lengths along it of t = 1
    double skipped = 0.0;  ///< length between the origin and the start
    bool isTooFar = false; ///< doubles don't place the start well enough

    /// Up to a length in the tree's coordinates.
    BoxTree::Ray rayTo(double length) const {
        return {glm::vec3(start), glm::vec3(along), endOf(length)};
    }
};

std::optional<RayTree::Line> RayTree::lineOf(const glm::dvec3& origin,
                                             const glm::dvec3& direction) const {
    const double reach = largestComponent(direction);
    if (reach == 0.0 || boxes_.items().empty()) return std::nullopt;
    const double size = glm::length(direction / reach);
    Line line{space_.local(origin), direction / reach / size, reach * size * space_.scale};
    const double farthest = largestComponent(line.start);
    line.isTooFar = farthest > farthestOrigin;
    if (farthest <= largestOrigin || line.isTooFar) return line;
    // A start far away would lose digits: it is moved to where the line comes near the box.
    double from = 0.0, to = std::numeric_limits<double>::infinity();
    const double grown = 1.0 + padding + 1e-12 * farthest;
    for (glm::length_t i = 0; i < 3; ++i) {
        if (line.along[i] == 0.0) {
            if (std::abs(line.start[i]) > grown) return std::nullopt;
            continue;
        }
        const double a = (-grown - line.start[i]) / line.along[i],
                     b = (grown - line.start[i]) / line.along[i];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (from > to * (1.0 + 1e-12)) return std::nullopt;
    line.skipped = from * (1.0 - 1e-12);
    line.start += line.skipped * line.along;
    return line;
}

void RayTree::visit(const glm::dvec3& origin, const glm::dvec3& direction, double length,
                    const std::function<bool(std::uint32_t)>& visit) const {
    const std::optional<Line> line = lineOf(origin, direction);
    if (!line) return;
    if (line->isTooFar) {
        for (const std::uint32_t triangle : boxes_.items())
            if (visit(triangle)) return;
        return;
    }
    boxes_.visit(line->rayTo(length * line->scale - line->skipped), visit);
}

void RayTree::visitInOrder(const glm::dvec3& origin, const glm::dvec3& direction,
                           const std::function<double(std::uint32_t)>& visit) const {
    const std::optional<Line> line = lineOf(origin, direction);
    if (!line) return;
    if (line->isTooFar) {
        for (const std::uint32_t triangle : boxes_.items())
            visit(triangle);
        return;
    }
    boxes_.visitInOrder(line->rayTo(std::numeric_limits<double>::infinity()),
                        [&](std::uint32_t triangle) {
                            return endOf(visit(triangle) * line->scale - line->skipped);
                        });
}

RayTree::Origins RayTree::originsOf(std::span<const glm::dvec3> places) const {
    Origins origins{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 start = space_.local(places[i]);
        origins.inside = origins.inside && largestComponent(start) <= largestOrigin;
        origins.x[i] = static_cast<float>(start.x);
        origins.y[i] = static_cast<float>(start.y);
        origins.z[i] = static_cast<float>(start.z);
    }
    return origins;
}

void RayTree::visitPacket(const Origins& origins, const glm::dvec3& direction, Lanes rays,
                          Test test, void* state) const {
    if (boxes_.items().empty()) return;
    const double reach = largestComponent(direction);
    boxes_.visitPacket(origins, glm::vec3(glm::normalize(direction / reach)), rays, test, state);
}

} // namespace edgeshade::rays
