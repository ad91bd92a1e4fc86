#include "src/lab/tie.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace edgeshade::lab {
namespace {

/// The picture points around a pixel's centre.
std::array<glm::dvec2, 8> movedPoints(const glm::dvec2& center, double grid) {
    std::array<glm::dvec2, 8> points;
    std::size_t count = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (dx != 0 || dy != 0) points[count++] = center + grid * glm::dvec2(dx, dy);
    return points;
}

/// The largest change of a hit's depth when its triangle's plane is met one grid step aside.
double depthChange(const Oracle& oracle, const Oracle::Hit& hit, const glm::dvec2& at,
                   double grid) {
    const SurfaceTriangle& triangle = oracle.triangles()[hit.triangle];
    const glm::dvec3 normal = normalOf(triangle);
    const double offset = glm::dot(normal, triangle.a);
    double change = 0.0;
    for (const glm::dvec2& point : movedPoints(at, grid)) {
        const PixelRay ray = pixelRay(oracle.question(), point.x, point.y);
        const double depth =
            (offset - glm::dot(normal, ray.origin)) / glm::dot(normal, ray.direction);
        // Behind the eye or at infinity: the plane is seen edge-on.
        if (!(depth > 0.0)) return std::numeric_limits<double>::infinity();
        change = std::max(change, std::abs(depth - hit.depth));
    }
    return change;
}

/// Whether the triangle's facing could change if its corners moved to the grid.
bool couldTurn(const Oracle& oracle, const SurfaceTriangle& triangle, const glm::dvec4& light,
               double grid) {
    const Question& question = oracle.question();
    const double pixel = question.frustum.size().y / question.height;
    const auto reach = [&](const glm::dvec3& corner) { // how far the corner may move, in scene
                                                       // units
        return grid * pixel * (question.frustum.orthographic ? 1.0 : glm::length(corner));
    };
    const glm::dvec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const glm::dvec3 aL = glm::dvec3(light) - triangle.a * light.w;
    const glm::dvec3 byB = glm::cross(ac, aL), byC = glm::cross(aL, ab);
    const glm::dvec3 byA = -(byB + byC + light.w * glm::cross(ab, ac));
    const double freedom = glm::length(byA) * reach(triangle.a) +
                           glm::length(byB) * reach(triangle.b) +
                           glm::length(byC) * reach(triangle.c);
    return std::abs(glm::dot(glm::cross(ab, ac), aL)) <= freedom;
}

std::optional<Oracle::Hit> visibleAt(const Oracle& oracle, const glm::dvec2& at) {
    const std::vector<Oracle::Hit> hits = oracle.surfacesAt(at.x, at.y);
    const auto nearest = std::min_element(
        hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.depth < b.depth; });
    return nearest == hits.end() ? std::nullopt : std::optional(*nearest);
}

bool shareEdge(const SurfaceTriangle& first, const SurfaceTriangle& second) {
    int shared = 0;
    for (const glm::dvec3& p : {first.a, first.b, first.c})
        for (const glm::dvec3& q : {second.a, second.b, second.c})
            shared += p == q;
    return shared >= 2;
}

double lightSide(const Oracle& oracle, const SurfaceTriangle& triangle, const glm::dvec4& light) {
    return oracle.eyeSide(triangle) *
           glm::dot(normalOf(triangle), glm::dvec3(light) - triangle.a * light.w);
}

/// Whether a silhouette passes between two visible surfaces one grid step apart. They aren't joined
/// there, so that one ends before the other, or only one of them faces a light, so that a shadow
/// volume begins between them.
bool silhouetteBetween(const Oracle& oracle, const Oracle::Hit& here, const glm::dvec2& center,
                       const Oracle::Hit& there, const glm::dvec2& moved, double grid) {
    const SurfaceTriangle& first = oracle.triangles()[here.triangle];
    const SurfaceTriangle& second = oracle.triangles()[there.triangle];
    if (!shareEdge(first, second)) return true;
    const double reach =
        depthChange(oracle, here, center, grid) + depthChange(oracle, there, moved, grid);
    if (std::abs(here.depth - there.depth) > reach) return true;
    for (std::size_t i = 0; i < oracle.question().lights.size(); ++i) {
        const glm::dvec4 light = oracle.lightFromEye(i);
        if ((lightSide(oracle, first, light) > 0.0) != (lightSide(oracle, second, light) > 0.0))
            return true;
    }
    return false;
}

/// Whether the answer changes when the visible surface moves in depth by as much as its own depth
/// changes over a grid step.
bool hangsOnDepth(const Oracle& oracle, const Oracle::Hit& visible, const glm::dvec2& center,
                  const Answer& answer, double grid) {
    const double change = depthChange(oracle, visible, center, grid);
    if (!std::isfinite(change)) return true;
    for (double part = change; part > 1e-3 * change; part /= 4.0)
        for (const double depth : {visible.depth - part, visible.depth + part})
            if (!(oracle.answerOn({visible.triangle, depth, 0.0}, center.x, center.y) == answer))
                return true;
    return false;
}

/// Whether a hidden surface has another answer, and is hidden by no more than the changes of both
/// surfaces' depths over a grid step.
bool hangsOnHidden(const Oracle& oracle, const Oracle::Hit& visible, const glm::dvec2& center,
                   const glm::dvec2& at, const Answer& answer, double grid) {
    const double reach = visible.depth + depthChange(oracle, visible, center, grid);
    for (const Oracle::Hit& hit : oracle.surfacesAt(at.x, at.y))
        if (hit.depth - depthChange(oracle, hit, at, grid) <= reach &&
            !(oracle.answerOn(hit, at.x, at.y) == answer))
            return true;
    return false;
}

/// Whether the texture filter may decide if the visible surface, or one in front of it, exists.
bool hangsOnFilter(const Oracle& oracle, const std::optional<Oracle::Hit>& visible,
                   const glm::dvec2& center) {
    const double depth = visible ? visible->depth : std::numeric_limits<double>::infinity();
    const PixelRay ray = pixelRay(oracle.question(), center.x, center.y);
    const std::vector<std::uint32_t> met = oracle.candidates(ray.origin, ray.direction, false);
    return std::any_of(met.begin(), met.end(), [&](std::uint32_t triangle) {
        return oracle.isCutOutByFilter(oracle.triangles()[triangle], center.x, center.y, depth);
    });
}

} // namespace

bool isTie(const Oracle& oracle, std::size_t pixel, const Verdict& verdict, double grid) {
    if (verdict.coincident) return true;
    const glm::dvec2 center = centerOf(oracle.question(), pixel);
    const std::optional<Oracle::Hit> visible = visibleAt(oracle, center);
    for (const glm::dvec2& point : movedPoints(center, grid)) {
        if (!(oracle.at(point.x, point.y) == verdict.answer)) return true;
        const std::optional<Oracle::Hit> moved = visibleAt(oracle, point);
        if (visible && moved && moved->triangle != visible->triangle &&
            silhouetteBetween(oracle, *visible, center, *moved, point, grid))
            return true;
    }
    if (hangsOnFilter(oracle, visible, center)) return true;
    if (!visible) return false;
    for (std::size_t i = 0; i < oracle.question().lights.size(); ++i)
        if (couldTurn(oracle, oracle.triangles()[visible->triangle], oracle.lightFromEye(i), grid))
            return true;
    for (const glm::dvec2& point : movedPoints(center, grid))
        if (hangsOnHidden(oracle, *visible, center, point, verdict.answer, grid)) return true;
    return hangsOnHidden(oracle, *visible, center, center, verdict.answer, grid) ||
           hangsOnDepth(oracle, *visible, center, verdict.answer, grid);
}

} // namespace edgeshade::lab
