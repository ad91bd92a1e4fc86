#include "tests/support/plain_visible_part.hpp"

#include "src/shadow/geometry/box_plane.hpp"

#include <array>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <vector>

namespace edgeshade::test {
namespace {

using Polygon = std::vector<glm::dvec3>;

Polygon clipped(const Polygon& polygon, const glm::dvec3& normal, double offset) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        const double a = glm::dot(normal, here) + offset;
        const double b = glm::dot(normal, next) + offset;
        if (a >= 0.0) kept.push_back(here);
        if ((a >= 0.0) != (b >= 0.0)) kept.push_back(here + (next - here) * (a / (a - b)));
    }
    return kept;
}

bool showsBack(const Polygon& triangle, bool orthographic, bool mirrored, double error) {
    const glm::dvec3 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
    const glm::dvec3 towardsEye = orthographic ? glm::dvec3(0.0, 0.0, 1.0) : -triangle[0];
    const double side = (mirrored ? -1.0 : 1.0) * glm::dot(glm::cross(ab, ac), towardsEye);
    const double sides = glm::length(ab) + glm::length(ac) + error;
    return side < -4.0 * error * sides * (sides + glm::length(towardsEye));
}

void addSlope(Interval& known, double offset, double depth, double nearest, double error,
              double low, double high, bool orthographic) {
    for (const double e : {-error, error})
        known.add(depth > nearest
                      ? std::clamp((offset + e) / (orthographic ? 1.0 : depth), low, high)
                  : e < 0.0 ? low
                            : high);
}

} // namespace

void addPlainly(const Scene& scene, const Batch& batch, const Frustum& given, VisiblePart& part) {
    Frustum frustum = given;
    const glm::dvec2 more = 0.5 * (1.001 - 1.0) * frustum.size();
    frustum.low -= more;
    frustum.high += more;
    const glm::dvec2 low = frustum.low, high = frustum.high;
    const bool orthographic = frustum.orthographic;
    const std::array<glm::dvec4, 5> sides =
        orthographic ? std::array<glm::dvec4, 5>{{{1.0, 0.0, 0.0, -low.x},
                                                  {-1.0, 0.0, 0.0, high.x},
                                                  {0.0, 1.0, 0.0, -low.y},
                                                  {0.0, -1.0, 0.0, high.y},
                                                  {0.0, 0.0, -1.0, 0.0}}}
                     : std::array<glm::dvec4, 5>{{{1.0, 0.0, low.x, 0.0},
                                                  {-1.0, 0.0, -high.x, 0.0},
                                                  {0.0, 1.0, low.y, 0.0},
                                                  {0.0, -1.0, -high.y, 0.0},
                                                  {0.0, 0.0, -1.0, 0.0}}};
    const glm::dmat4 viewFromBatch = frustum.viewFromWorld * batch.worldFromBatch;
    const glm::dmat4 worldFromView = glm::inverse(frustum.viewFromWorld);
    const Geometry& geometry = *batch.geometry;

    glm::dvec3 farthest(0.0);
    for (const glm::vec3& position : geometry.positions)
        farthest = glm::max(farthest, glm::dvec3(glm::abs(position)));
    double largest = 0.0;
    for (glm::length_t axis = 0; axis < 3; ++axis)
        largest = std::max(
            largest, glm::dot(glm::abs(glm::row(viewFromBatch, axis)), glm::dvec4(farthest, 1.0)));
    const double error = placingError * largest;
    const glm::dvec2 widest = glm::max(glm::abs(low), glm::abs(high));
    const double nearest = orthographic ? 0.0 : 2.0 * error;
    const double slopeError =
        orthographic ? error : 2.0 * error * (1.0 + std::max(widest.x, widest.y));

    std::vector<bool> culled(geometry.indices.size(), false), invisible = culled;
    for (const SurfaceGroup& group : geometry.groups) {
        if (group.material >= scene.materials.size()) continue;
        const Material& material = scene.materials[group.material];
        for (std::uint32_t i = 0; i < group.indexCount; ++i) {
            culled[group.firstIndex + i] = scene.culls && !material.doubleSided;
            invisible[group.firstIndex + i] = !material.isSeen();
        }
    }
    const bool mirrored = glm::determinant(glm::dmat3(viewFromBatch)) < 0.0;

    for (std::size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
        if (invisible[i]) continue; // a section cuts it away
        Polygon polygon;
        for (std::size_t c = 0; c < 3; ++c)
            polygon.emplace_back(viewFromBatch *
                                 glm::dvec4(geometry.positions[geometry.indices[i + c]], 1.0));
        if (culled[i] && showsBack(polygon, orthographic, mirrored, error)) continue;
        for (const glm::dvec4& side : sides)
            polygon = clipped(polygon, glm::dvec3(side), side.w);
        for (const glm::dvec3& corner : polygon) {
            part.depth.add(std::max(0.0, -corner.z));
            part.box.add(glm::dvec3(worldFromView * glm::dvec4(corner, 1.0)));
            addSlope(part.slopes.right, corner.x, -corner.z, nearest, slopeError, low.x, high.x,
                     orthographic);
            addSlope(part.slopes.up, corner.y, -corner.z, nearest, slopeError, low.y, high.y,
                     orthographic);
        }
    }
}

VisiblePart plainVisiblePart(const Scene& scene, const Frustum& frustum, bool ground) {
    VisiblePart part;
    for (const Batch& batch : scene.batches)
        if (!batch.ground || ground) addPlainly(scene, batch, frustum, part);
    return part;
}

std::array<double, 12> numbersOf(const VisiblePart& part) {
    return {part.depth.nearest,    part.depth.farthest,    part.box.low.x,     part.box.low.y,
            part.box.low.z,        part.box.high.x,        part.box.high.y,    part.box.high.z,
            part.slopes.right.low, part.slopes.right.high, part.slopes.up.low, part.slopes.up.high};
}

testing::AssertionResult findsTheSame(const Scene& scene, const SceneTree& tree,
                                      const Frustum& frustum, bool ground) {
    const auto found = numbersOf(visiblePart(scene, tree, frustum, ground));
    const auto wanted = numbersOf(plainVisiblePart(scene, frustum, ground));
    if (found != wanted)
        return testing::AssertionFailure() << "found " << testing::PrintToString(found) << ", not "
                                           << testing::PrintToString(wanted);
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        VisiblePart alone;
        addPlainly(scene, scene.batches[i], frustum, alone);
        const double depth = nearestDepth(scene, tree, i, frustum);
        if (depth != alone.depth.nearest)
            return testing::AssertionFailure()
                   << "batch " << i << " at depth " << depth << ", not " << alone.depth.nearest;
    }
    return testing::AssertionSuccess();
}

} // namespace edgeshade::test
