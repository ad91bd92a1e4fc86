#include "src/shadow/geometry/triangle_tree.hpp"

#include "preprocess/base/morton.hpp"
#include "preprocess/base/radix_sort.hpp"

#include <algorithm>
#include <numeric>

namespace edgeshade {
namespace {

glm::dvec3 middleOf(const Geometry& geometry, std::size_t triangle) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec3 corner(geometry.positions[geometry.indices[3 * triangle + c]]);
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    return 0.5 * (low + high);
}

/// Whether a section leaves the triangles of a group visible.
bool isSeen(const SurfaceGroup& group, const std::vector<Material>& materials) {
    return group.material >= materials.size() || materials[group.material].isSeen();
}

/// Numbers of the visible triangles, ascending.
std::vector<std::uint32_t> seenOf(const Geometry& geometry,
                                  const std::vector<Material>& materials) {
    std::vector<std::uint8_t> seen(geometry.indices.size() / 3, 1);
    for (const SurfaceGroup& group : geometry.groups)
        if (!isSeen(group, materials))
            std::fill_n(seen.begin() + group.firstIndex / 3, group.indexCount / 3, 0);
    std::vector<std::uint32_t> triangles;
    triangles.reserve(seen.size());
    for (std::uint32_t t = 0; t < seen.size(); ++t)
        if (seen[t] != 0) triangles.push_back(t);
    return triangles;
}

/// Sorts triangles, which ascend, along the Morton curve in a box.
void sortAlongCurve(const Geometry& geometry, const Box& all, Threads threads,
                    std::vector<std::uint32_t>& triangles) {
    std::vector<Keyed<2>> order(triangles.size());
    forEachItem(triangles.size(), itemsOfThread, threads, [&](std::size_t i) {
        order[i] = {mortonKey(mortonCode(middleOf(geometry, triangles[i]), all)), triangles[i]};
    });
    radixSort(order, threads);
    std::transform(order.begin(), order.end(), triangles.begin(),
                   [](const Keyed<2>& item) { return item.number; });
}

constexpr std::uint32_t notKept = std::numeric_limits<std::uint32_t>::max();

/// A cut's visible triangles.
struct CutTriangles {
    std::vector<std::uint32_t> keptAs; ///< by triangle before: its number in the cut, or `notKept`
    std::vector<std::uint32_t> made;   ///< pieces and fills, ascending
};

CutTriangles trianglesOfCut(const Geometry& cut, const CutOrigins& origins,
                            const std::vector<Material>& materials) {
    CutTriangles of;
    of.keptAs.assign(origins.from->indices.size() / 3, notKept);
    for (const SurfaceGroup& group : cut.groups) {
        if (!isSeen(group, materials)) continue;
        const std::uint32_t first = group.firstIndex / 3, end = first + group.indexCount / 3;
        for (std::uint32_t t = first; t < end; ++t)
            if (const std::uint32_t origin = origins.ofTriangle[t]; origin < CutOrigins::piece)
                of.keptAs[origin] = t;
            else
                of.made.push_back(t);
    }
    return of;
}

/// For each triangle, whether it is visible only from its front. Scenes that cull nothing may do
/// without materials.
std::vector<std::uint8_t> singleSidedOf(const Geometry& geometry,
                                        const std::vector<Material>& materials) {
    std::vector<std::uint8_t> singleSided(geometry.indices.size() / 3, 0);
    for (const SurfaceGroup& group : geometry.groups)
        if (group.material < materials.size())
            std::fill_n(singleSided.begin() + group.firstIndex / 3, group.indexCount / 3,
                        !materials[group.material].doubleSided);
    return singleSided;
}

} // namespace

TriangleTree::TriangleTree(const Geometry& geometry, const std::vector<Material>& materials,
                           Cones cones, Threads threads)
    : triangles_(seenOf(geometry, materials)) {
    sortAlongCurve(geometry, boundsOf(geometry), threads, triangles_);
    addLeaves(0);
    boxes_ = BoxTree<float>(firsts_.size() - 1);
    if (cones == Cones::found) cones_.resize(boxes_.groups());
    refit(geometry, materials);
}

TriangleTree::TriangleTree(const TriangleTree& whole, const Geometry& cut,
                           const CutOrigins& origins, const std::vector<Material>& materials)
    : farthest_(whole.farthest_) {
    CutTriangles of = trianglesOfCut(cut, origins, materials);
    const std::vector<std::uint32_t> wholeLeaves = takeLeaves(whole, of.keptAs);
    const std::size_t taken = triangles_.size();
    sortAlongCurve(cut, whole.bounds_, Threads{1}, of.made);
    triangles_.insert(triangles_.end(), of.made.begin(), of.made.end());
    addLeaves(taken);
    boxes_ = BoxTree<float>(firsts_.size() - 1);
    for (std::size_t leaf = 0; leaf < boxes_.items(); ++leaf)
        if (leaf < wholeLeaves.size() && wholeLeaves[leaf] != notKept)
            boxes_.copy(leaf, whole.boxes_, wholeLeaves[leaf]);
        else
            fitLeaf(leaf, cut);
    fitAround(cut, origins.from->positions.size());
}

/// Divides the triangles from number `first` on into leaves, and ends the last.
void TriangleTree::addLeaves(std::size_t first) {
    for (; first < triangles_.size(); first += leafSize)
        firsts_.push_back(static_cast<std::uint32_t>(first));
    firsts_.push_back(static_cast<std::uint32_t>(triangles_.size()));
}

/// Takes the triangles that a cut keeps, leaf by leaf. For each leaf, returns the one of `whole`
/// that has the same triangles, or `notKept`. `keptAs`: of CutTriangles.
std::vector<std::uint32_t> TriangleTree::takeLeaves(const TriangleTree& whole,
                                                    const std::vector<std::uint32_t>& keptAs) {
    std::vector<std::uint32_t> same;
    same.reserve(whole.boxes_.items());
    firsts_.reserve(whole.boxes_.items() + 1);
    triangles_.resize(whole.triangles_.size());
    std::uint32_t end = 0;
    for (std::uint32_t leaf = 0; leaf < whole.boxes_.items(); ++leaf) {
        const std::uint32_t first = end;
        const std::span<const std::uint32_t> before = whole.trianglesOf(leaf);
        for (const std::uint32_t triangle : before) {
            triangles_[end] = keptAs[triangle]; // overwritten if it isn't kept
            end += keptAs[triangle] != notKept;
        }
        if (end == first) continue;
        firsts_.push_back(first);
        same.push_back(end - first == before.size() ? leaf : notKept);
    }
    triangles_.resize(end);
    return same;
}

void TriangleTree::refit(const Geometry& geometry, const std::vector<Material>& materials) {
    for (std::size_t leaf = 0; leaf < boxes_.items(); ++leaf)
        fitLeaf(leaf, geometry);
    farthest_ = glm::dvec3(0.0);
    fitAround(geometry, 0);
    if (hasCones()) fitCones(geometry, materials);
}

/// Fits what is around the leaves. `firstPosition`: the first that farthest_ is still to follow.
void TriangleTree::fitAround(const Geometry& geometry, std::size_t firstPosition) {
    boxes_.fit();
    bounds_ = {};
    if (boxes_.levels() > 0) {
        const auto& [low, high] = boxes_.group(boxes_.levels() - 1, 0);
        for (std::size_t i = 0; i < boxes_.count(boxes_.levels() - 1); ++i) {
            bounds_.add({low[0][i], low[1][i], low[2][i]});
            bounds_.add({high[0][i], high[1][i], high[2][i]});
        }
    }
    for (std::size_t i = firstPosition; i < geometry.positions.size(); ++i)
        farthest_ = glm::max(farthest_, glm::dvec3(glm::abs(geometry.positions[i])));
}

void TriangleTree::fitLeaf(std::size_t leaf, const Geometry& geometry) {
    glm::vec3 low(std::numeric_limits<float>::infinity()), high(-low);
    for (const std::uint32_t triangle : trianglesOf(leaf))
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3& corner = geometry.positions[geometry.indices[3 * triangle + c]];
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    boxes_.set(leaf, low, high);
}

void TriangleTree::fitCones(const Geometry& geometry, const std::vector<Material>& materials) {
    const std::vector<std::uint8_t> singleSided = singleSidedOf(geometry, materials);
    const auto corner = [&](std::uint32_t triangle, std::size_t c) {
        return glm::dvec3(geometry.positions[geometry.indices[3 * triangle + c]]);
    };
    std::array<NormalCone, leafSize> cones;
    for (std::size_t leaf = 0; leaf < boxes_.items(); ++leaf) {
        std::size_t count = 0;
        for (const std::uint32_t t : trianglesOf(leaf))
            cones[count++] = singleSided[t] != 0 ? coneOf(corner(t, 0), corner(t, 1), corner(t, 2))
                                                 : NormalCone();
        cones_[boxes_.numberOf(0, leaf / 4)].set(leaf % 4,
                                                 coneAround(std::span(cones).first(count)));
    }
    for (std::size_t level = 1; level < boxes_.levels(); ++level)
        for (std::size_t i = 0; i < boxes_.count(level); ++i)
            fitCone(level, i);
}

void TriangleTree::fitCone(std::size_t level, std::size_t i) {
    std::array<NormalCone, 4> below;
    const std::size_t count = std::min<std::size_t>(4, boxes_.count(level - 1) - 4 * i);
    for (std::size_t lane = 0; lane < count; ++lane)
        below[lane] = cones(level - 1, i).at(lane);
    cones_[boxes_.numberOf(level, i / 4)].set(i % 4, coneAround(std::span(below).first(count)));
}

} // namespace edgeshade
