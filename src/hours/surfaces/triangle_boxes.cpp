#include "src/hours/surfaces/triangle_boxes.hpp"

#include "preprocess/base/morton.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade::hours {
namespace {

/// Growth of boxes, as a share of the coordinates.
constexpr double boxRounding = 1e-12;

Box boxOf(const WorldTriangle& triangle) {
    Box box;
    for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c})
        box.add(corner);
    return box;
}

} // namespace

TriangleBoxes::TriangleBoxes(std::span<const WorldTriangle> triangles, double margin)
    : boxes_(triangles.size()) {
    Box all;
    for (const WorldTriangle& triangle : triangles)
        all.add(boxOf(triangle));
    std::vector<std::uint64_t> codes;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        triangles_.push_back(t);
        codes.push_back(mortonCode(boxOf(triangles[t]).center(), all));
    }
    std::stable_sort(triangles_.begin(), triangles_.end(),
                     [&](std::uint32_t s, std::uint32_t t) { return codes[s] < codes[t]; });
    for (std::size_t item = 0; item < triangles_.size(); ++item) {
        const Box box = boxOf(triangles[triangles_[item]]);
        const glm::dvec3 room =
            margin + boxRounding * glm::max(glm::abs(box.low), glm::abs(box.high));
        boxes_.set(item, box.low - room, box.high + room);
    }
    boxes_.fit();
}

template <class Meets>
void TriangleBoxes::search(const Meets& meets, Use use) const {
    struct Step {
        std::size_t level, group;
    };
    if (boxes_.levels() == 0) return;
    std::array<Step, BoxTree<double>::arity * BoxTree<double>::mostLevels> stack;
    std::size_t height = 0;
    stack[height++] = {boxes_.levels() - 1, 0};
    while (height > 0) {
        const Step step = stack[--height];
        const FourBoxes<double>& four = boxes_.group(step.level, step.group);
        for (std::size_t lane = 0; lane < BoxTree<double>::arity; ++lane) {
            const std::size_t number = BoxTree<double>::arity * step.group + lane;
            if (number >= boxes_.count(step.level)) break;
            const glm::dvec3 low(four.low[0][lane], four.low[1][lane], four.low[2][lane]),
                high(four.high[0][lane], four.high[1][lane], four.high[2][lane]);
            if (!meets(low, high)) continue;
            if (step.level == 0)
                use(triangles_[number]);
            else
                stack[height++] = {step.level - 1, number};
        }
    }
}

void TriangleBoxes::forPoint(const glm::dvec3& point, Use use) const {
    search(
        [&](const glm::dvec3& low, const glm::dvec3& high) {
            return glm::all(glm::lessThanEqual(low, point)) &&
                   glm::all(glm::lessThanEqual(point, high));
        },
        use);
}

void TriangleBoxes::forRay(const glm::dvec3& origin, const glm::dvec3& direction, Use use) const {
    search(
        [&](const glm::dvec3& low, const glm::dvec3& high) {
            double enter = 0.0, leave = std::numeric_limits<double>::infinity();
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                if (direction[axis] == 0.0) {
                    if (origin[axis] < low[axis] || origin[axis] > high[axis]) return false;
                    continue;
                }
                const double p = (low[axis] - origin[axis]) / direction[axis],
                             q = (high[axis] - origin[axis]) / direction[axis];
                enter = std::max(enter, std::min(p, q));
                leave = std::min(leave, std::max(p, q));
            }
            return enter <= leave;
        },
        use);
}

} // namespace edgeshade::hours
