#include "src/shadow/view/visible_depth.hpp"

#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/geometry/normal_cone.hpp"
#include "src/shadow/view/bound_test.hpp"
#include "src/shadow/view/tree_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <optional>

namespace edgeshade {
namespace {

/// A batch's triangles and boxes in a picture.
struct BatchBoxes {
    BatchBoxes(const ClippingFrustum& clipping, const Scene& scene, const Batch& batch,
               const TriangleTree& triangles_)
        : triangles(triangles_), placed(clipping, scene, batch, triangles.farthest()),
          space(clipping, placed.viewFromBatch(), triangles.farthest(), placed.slopeErrors()) {
        if (scene.culls && triangles.hasCones())
            back.emplace(placed.viewFromBatch(), clipping.frustum.orthographic, placed.error());
    }

    /// Whether the scene certainly culls all triangles of a box.
    bool areCulled(std::size_t level, std::size_t group, std::size_t lane) const {
        if (!back) return false;
        const NormalCone cone = triangles.cones(level, group).at(lane);
        if (!(cone.thickness > 0.0)) return false;
        const auto& [low, high] = triangles.boxes().group(level, group);
        const Box box{{low[0][lane], low[1][lane], low[2][lane]},
                      {high[0][lane], high[1][lane], high[2][lane]}};
        return back->showsBacks(cone, box.center(), 0.5 * box.diagonal());
    }

    const TriangleTree& triangles;
    BatchInView placed;
    SpaceInView space;
    std::optional<BackView> back;
};

/// Finds the visible part of a scene, bound by bound.
class VisibleSearch {
  public:
    VisibleSearch(const Scene& scene, const SceneTree& tree, const Frustum& frustum)
        : scene_(scene), tree_(tree), clipping_(frustum) {}

    /// Extends the bound by the surfaces of all places. Returns false if it gave up.
    bool findInPlaces(PartBound bound) {
        if (tree_.places().empty()) return true;
        const SpaceInView world = worldInView();
        BoundTest test(world, bound, part_);
        bool finds = true;
        const auto isNever = [](std::size_t, std::size_t, std::size_t) { return false; };
        search(tree_.boxes(), world, test, allSides, isNever,
               [&](std::size_t place, SideBits sides) {
                   finds = findInBatch(bound, tree_.places()[place], sides);
                   test.follow(part_);
                   return finds;
               });
        return finds;
    }

    /// Extends the bound by the surfaces of a batch. Returns false if it gave up.
    bool findInBatch(PartBound bound, std::size_t batch, SideBits sides = allSides) {
        const BatchBoxes boxes = boxesOf(batch);
        BoundTest test(boxes.space, bound, part_);
        bool finds = true;
        const auto areCulled = [&](std::size_t level, std::size_t group, std::size_t lane) {
            return boxes.areCulled(level, group, lane);
        };
        search(boxes.triangles.boxes(), boxes.space, test, sides, areCulled,
               [&](std::size_t leaf, SideBits) {
                   for (const std::uint32_t triangle : boxes.triangles.trianglesOf(leaf)) {
                       if (!test.mayExtend(boxes.placed.corners(triangle))) continue;
                       boxes.placed.add(triangle, part_);
                       test.follow(part_);
                       ++steps_;
                   }
                   finds = ++steps_ < mostSteps_;
                   return finds;
               });
        return finds;
    }

    /// Extends all bounds by the surfaces of a batch, leaf by leaf. It costs less than searches
    /// that visit most leaves, once for each bound.
    void sweep(std::size_t batch) {
        const BatchBoxes boxes = boxesOf(batch);
        Tests tests;
        for (std::size_t i = 0; i < tests.size(); ++i)
            tests[i].emplace(boxes.space, partBounds[i], part_);
        const BoxTree<float>& tree = boxes.triangles.boxes();
        for (std::size_t group = 0; 4 * group < tree.items(); ++group) {
            const InFrustum in = inFrustum(tree.group(0, group), boxes.space, allSides);
            const std::array<BoundBits, 4> bounds = extendedBy(tree.group(0, group), tests);
            const std::size_t lanes = std::min<std::size_t>(4, tree.items() - 4 * group);
            for (std::size_t i = 0; i < lanes; ++i)
                if (!in.outside[i] && bounds[i] != 0)
                    sweepLeaf(4 * group + i, boxes, tests, bounds[i]);
        }
    }

    const VisiblePart& part() const { return part_; }

  private:
    using Tests = std::array<std::optional<BoundTest>, partBounds.size()>;
    using BoundBits = unsigned; ///< one bit for each of partBounds

    static std::array<BoundBits, 4> extendedBy(const FourBoxes<float>& boxes, const Tests& tests) {
        std::array<BoundBits, 4> bounds{};
        for (std::size_t t = 0; t < tests.size(); ++t) {
            const BoundTest::Reach reach = tests[t]->reachOf(boxes);
            for (std::size_t i = 0; i < 4; ++i)
                if (tests[t]->mayExtend(reach.beyond[i])) bounds[i] |= 1u << t;
        }
        return bounds;
    }

    void sweepLeaf(std::size_t leaf, const BatchBoxes& boxes, Tests& tests, BoundBits bounds) {
        for (const std::uint32_t triangle : boxes.triangles.trianglesOf(leaf)) {
            const auto corners = boxes.placed.corners(triangle);
            bool mayExtend = false;
            for (BoundBits left = bounds; left != 0 && !mayExtend; left &= left - 1)
                mayExtend =
                    tests[static_cast<std::size_t>(std::countr_zero(left))]->mayExtend(corners);
            if (!mayExtend) continue;
            boxes.placed.add(triangle, part_);
            for (auto& test : tests)
                test->follow(part_);
        }
    }

    BatchBoxes boxesOf(std::size_t batch) const {
        return {clipping_, scene_, scene_.batches[batch], tree_.trianglesOf(batch)};
    }

    SpaceInView worldInView() const {
        const Box& extent = tree_.extent();
        const glm::dmat4& viewFromWorld = clipping_.frustum.viewFromWorld;
        const glm::dvec3 center = extent.center(), half = extent.high - center;
        double largest = 0.0;
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const glm::dvec4 row = glm::row(viewFromWorld, axis);
            largest = std::max(largest, std::abs(glm::dot(row, glm::dvec4(center, 1.0))) +
                                            glm::dot(glm::abs(glm::dvec3(row)), half));
        }
        const glm::dvec3 farthest = glm::max(glm::abs(extent.low), glm::abs(extent.high));
        return {clipping_, viewFromWorld, farthest,
                slopeErrorsOf(clipping_.frustum, (1.0 + 1e-6) * placingError * largest)};
    }

    const Scene& scene_;
    const SceneTree& tree_;
    ClippingFrustum clipping_;
    VisiblePart part_;
    std::size_t steps_ = 0; ///< leaves and triangles that searches have looked at
    /// From here on, a sweep costs less.
    std::size_t mostSteps_ = 1024 + tree_.leaves() / 4;
};

} // namespace

VisiblePart visiblePart(const Scene& scene, const SceneTree& tree, const Frustum& frustum,
                        bool ground) {
    VisibleSearch search(scene, tree, frustum);
    const auto findAll = [&] {
        for (const PartBound& bound : partBounds) {
            if (ground && !search.findInBatch(bound, *tree.ground())) return false;
            if (!search.findInPlaces(bound)) return false;
            if (search.part().depth.empty()) return true; // nothing is visible
        }
        return true;
    };
    if (findAll()) return search.part();
    for (const std::uint32_t batch : tree.places())
        search.sweep(batch);
    if (ground) search.sweep(*tree.ground());
    return search.part();
}

double nearestDepth(const Scene& scene, const SceneTree& tree, std::size_t batch,
                    const Frustum& frustum) {
    VisibleSearch search(scene, tree, frustum);
    if (!search.findInBatch({PartBound::Of::depth, false}, batch)) search.sweep(batch);
    return search.part().depth.nearest;
}

bool isAboveGround(const Frustum& frustum, const Batch& ground) {
    const glm::dvec4 eye = frustum.eye();
    return eye.y > ground.worldFromBatch[3].y * eye.w;
}

} // namespace edgeshade
