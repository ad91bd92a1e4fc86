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

/// Removes the triangles that a section cuts away.
void keepSeen(const Geometry& geometry, const std::vector<Material>& materials,
              std::vector<Keyed<2>>& triangles) {
    std::vector<std::uint8_t> away(geometry.indices.size() / 3, 0);
    for (const SurfaceGroup& group : geometry.groups)
        if (group.material < materials.size() && !materials[group.material].isSeen())
            std::fill_n(away.begin() + group.firstIndex / 3, group.indexCount / 3, 1);
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                   [&](const Keyed<2>& item) { return away[item.number] != 0; }),
                    triangles.end());
}

/// The visible triangles along the Morton curve.
std::vector<std::uint32_t> alongCurve(const Geometry& geometry,
                                      const std::vector<Material>& materials, Threads threads) {
    const std::size_t count = geometry.indices.size() / 3;
    const Box all = boundsOf(geometry);
    std::vector<Keyed<2>> order(count);
    forEachItem(count, itemsOfThread, threads, [&](std::size_t t) {
        order[t] = {mortonKey(mortonCode(middleOf(geometry, t), all)),
                    static_cast<std::uint32_t>(t)};
    });
    if (std::any_of(materials.begin(), materials.end(),
                    [](const Material& material) { return !material.isSeen(); }))
        keepSeen(geometry, materials, order);
    radixSort(order, threads);
    std::vector<std::uint32_t> triangles(order.size());
    std::transform(order.begin(), order.end(), triangles.begin(),
                   [](const Keyed<2>& item) { return item.number; });
    return triangles;
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
    : triangles_(alongCurve(geometry, materials, threads)),
      boxes_((triangles_.size() + leafSize - 1) / leafSize),
      cones_(cones == Cones::found ? boxes_.groups() : 0) {
    refit(geometry, materials);
}

void TriangleTree::refit(const Geometry& geometry, const std::vector<Material>& materials) {
    bounds_ = {};
    for (std::size_t leaf = 0; leaf < boxes_.items(); ++leaf)
        fitLeaf(leaf, geometry);
    boxes_.fit();
    if (hasCones()) fitCones(geometry, materials);
    farthest_ = glm::dvec3(0.0);
    for (const glm::vec3& position : geometry.positions)
        farthest_ = glm::max(farthest_, glm::dvec3(glm::abs(position)));
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
    bounds_.add(glm::dvec3(low));
    bounds_.add(glm::dvec3(high));
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
