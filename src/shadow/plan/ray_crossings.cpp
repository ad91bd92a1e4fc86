#include "src/shadow/plan/ray_crossings.hpp"

#include "preprocess/volumes/clustering.hpp"

#include "preprocess/mesh/weld.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace edgeshade {
namespace {

/// Share of the factors' sizes below which a product's sign stays undecided.
constexpr double leastShare = 1e-10;

/// The sign of the shaders' planeSide(); 0 if rounding may decide it.
int certainSide(const glm::vec4& plane, const glm::dvec4& light, double rounding) {
    const glm::dvec4 terms = glm::dvec4(plane) * light;
    const double side = terms.x + terms.y + terms.z + terms.w;
    const double size =
        std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w);
    if (!(std::abs(side) > rounding * size + 1e-30)) return 0;
    return side > 0.0 ? 1 : -1;
}

std::array<glm::dvec3, 3> cornersOf(const CapRecord& cap) {
    return {glm::dvec3(cap.a), glm::dvec3(cap.b), glm::dvec3(cap.c)};
}

/// How the segment from `start` to the light crosses a triangle.
enum class Crossing { none, towardsItsFront, towardsItsBack, uncertain };

Crossing crossingOf(const std::array<glm::dvec3, 3>& triangle, const glm::dvec3& start,
                    const glm::dvec4& light) {
    const glm::dvec3 way = glm::dvec3(light) - start * light.w;
    const double length = glm::length(way);
    std::array<glm::dvec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = triangle[i] - start;
    int signs = 0, sure = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &p = corners[i], &q = corners[(i + 1) % 3];
        const double side = glm::dot(way, glm::cross(p, q));
        if (!(std::abs(side) > leastShare * length * glm::length(p) * glm::length(q))) continue;
        signs += side > 0.0 ? 1 : -1;
        ++sure;
    }
    // Two different signs suffice to show that the line misses, whatever the third is.
    if (std::abs(signs) < sure) return Crossing::none;
    if (sure < 3) return Crossing::uncertain;
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double slope = glm::dot(way, normal), height = glm::dot(corners[0], normal);
    const double normalLength = glm::length(normal);
    if (!(std::abs(slope) > leastShare * length * normalLength) ||
        !(std::abs(height) > leastShare * glm::length(corners[0]) * normalLength))
        return Crossing::uncertain;
    const double share = height / slope; // share of the segment at which it meets the plane
    if (share < 0.0) return Crossing::none;
    if (light.w != 0.0) {
        const double at = share * light.w; // 1 at the light
        if (std::abs(at - 1.0) < 1e-9) return Crossing::uncertain;
        if (at > 1.0) return Crossing::none;
    }
    return slope > 0.0 ? Crossing::towardsItsFront : Crossing::towardsItsBack;
}

std::optional<RayCrossings> crossingsFrom(const glm::dvec3& start, const glm::dvec4& light,
                                          std::span<const std::uint32_t> touched,
                                          const PlanePairShadow& shadow, double rounding) {
    RayCrossings crossings;
    for (const std::uint32_t i : touched) {
        const CapRecord& cap = shadow.caps[i];
        const Crossing crossing = crossingOf(cornersOf(cap), start, light);
        if (crossing == Crossing::uncertain) return std::nullopt;
        const int side = certainSide(cap.plane, light, rounding);
        if (side == 0 && cap.casts()) return std::nullopt;
        if (crossing == Crossing::none) continue;
        const int inSpace = crossing == Crossing::towardsItsFront ? 1 : -1;
        (side > 0 ? crossings.lightFacing : crossings.facingAway) += side * inSpace;
        ++(inSpace > 0 ? crossings.outwards : crossings.inwards);
    }
    return crossings;
}

bool mayMeetRectangle(const NearClipVolume& volume, const ClipVolumeFaces& faces,
                      const std::array<glm::dvec3, 3>& triangle) {
    if (faces.areBeforeRectangle(triangle)) return false;
    const NearClipVolume rectangle{volume.corners, glm::dvec4(volume.corners[0], 1.0)};
    return !areApart(rectangle, triangle);
}

/// A hash of an edge's ends; equal coordinates make equal numbers.
std::uint64_t numberOf(const glm::vec3& a, const glm::vec3& b) {
    std::uint64_t number = 0;
    for (const glm::vec3& end : {a, b})
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const float value = end[axis] + 0.0f; // -0 is 0
            std::uint32_t bits;
            std::memcpy(&bits, &value, sizeof(bits));
            number = (number ^ bits) * 0x9E3779B97F4A7C15u;
            number ^= number >> 29;
        }
    return number;
}

/// An order in which equal edges are neighbours.
struct EdgeOrder {
    bool operator()(const EdgeSign& p, const EdgeSign& q) const {
        if (p.number != q.number) return p.number < q.number;
        return p.a != q.a ? orderedBefore(p.a, q.a) : orderedBefore(p.b, q.b);
    }
};

/// Whether any edge that may be within the volume has a multiplicity other than 0. Edges outside
/// the volume are skipped: some of their triangles may be missing from the sum.
bool anySilhouette(std::vector<EdgeSign>& edges, const NearClipVolume& volume) {
    std::sort(edges.begin(), edges.end(), EdgeOrder());
    for (std::size_t i = 0; i < edges.size();) {
        int multiplicity = 0;
        const EdgeSign& first = edges[i];
        for (; i < edges.size() && edges[i].a == first.a && edges[i].b == first.b; ++i)
            multiplicity += edges[i].sign;
        const glm::dvec3 a(first.a), b(first.b);
        if (multiplicity != 0 && !areApart(volume, {a, b, b})) return true;
    }
    return false;
}

/// Number of neighbouring leaves whose common box is tested first, as most are far from the volume.
constexpr std::size_t leavesPerTest = 8;

/// Calls `use` with each cap that neither its leaf's box nor `faces` separates from the volume,
/// until `use` returns true.
template <class Use>
void forCapsNear(const ClipVolumeFaces& faces, const ShadowCluster& cluster,
                 const PlanePairShadow& shadow, Use use) {
    if (faces.separate(cluster.bounds)) return;
    const std::span leaves(shadow.leaves.data() + cluster.leaves.first, cluster.leaves.count);
    const auto usedIn = [&](std::size_t leaf) {
        if (faces.separate(leaves[leaf]) || areApart(faces.volume(), leaves[leaf])) return false;
        const auto first = static_cast<std::uint32_t>(cluster.caps.first + leaf * leafTriangles);
        const std::uint32_t end = std::min(first + leafTriangles, cluster.caps.end());
        for (std::uint32_t cap = first; cap < end; ++cap)
            if (!faces.separate(cornersOf(shadow.caps[cap])) && use(cap)) return true;
        return false;
    };
    for (std::size_t first = 0; first < leaves.size(); first += leavesPerTest) {
        const std::size_t end = std::min(first + leavesPerTest, leaves.size());
        Box around;
        for (const Box& leaf : leaves.subspan(first, end - first))
            around.add(leaf);
        if (faces.separate(around)) continue;
        for (std::size_t leaf = first; leaf < end; ++leaf)
            if (usedIn(leaf)) return;
    }
}

} // namespace

void findTouching(const ClipVolumeFaces& faces, const ShadowCluster& cluster,
                  const PlanePairShadow& shadow, Touched& touched, std::size_t limit) {
    touched.caps.clear();
    touched.caps.reserve(limit + 1);
    touched.tooMany = false;
    forCapsNear(faces, cluster, shadow, [&](std::uint32_t cap) {
        touched.caps.push_back(cap);
        touched.tooMany = touched.caps.size() > limit;
        return touched.tooMany;
    });
}

bool anyCapTouches(const ClipVolumeFaces& faces, const ShadowCluster& cluster,
                   const PlanePairShadow& shadow) {
    bool any = false;
    forCapsNear(faces, cluster, shadow, [&](std::uint32_t cap) {
        any = !areApart(faces.volume(), cornersOf(shadow.caps[cap]));
        return any;
    });
    return any;
}

std::optional<RayCrossings> crossingsFromSomePoint(const NearClipVolume& volume,
                                                   std::span<const std::uint32_t> touched,
                                                   const PlanePairShadow& shadow, double rounding) {
    // A segment that meets an edge is undecided, but some other start decides.
    constexpr std::array<glm::dvec2, 6> places = {{{0.5, 0.5},
                                                   {0.387, 0.561},
                                                   {0.613, 0.423},
                                                   {0.271, 0.317},
                                                   {0.717, 0.659},
                                                   {0.441, 0.191}}};
    const auto& corners = volume.corners;
    for (const glm::dvec2& place : places) {
        const glm::dvec3 start =
            corners[0] + place.x * (corners[1] - corners[0]) + place.y * (corners[3] - corners[0]);
        const auto crossings = crossingsFrom(start, volume.light, touched, shadow, rounding);
        if (crossings) return crossings;
    }
    return std::nullopt;
}

Evenness evennessOf(const ClipVolumeFaces& faces, Touched& touched, const PlanePairShadow& shadow,
                    double rounding) {
    const NearClipVolume& volume = faces.volume();
    touched.edges.clear();
    touched.edges.reserve(3 * touched.caps.capacity());
    for (const std::uint32_t i : touched.caps) {
        const CapRecord& cap = shadow.caps[i];
        if (!cap.casts()) continue;
        const std::array<glm::dvec3, 3> corners = cornersOf(cap);
        if (mayMeetRectangle(volume, faces, corners)) return Evenness::rectangleMet;
        const int side = certainSide(cap.plane, volume.light, rounding);
        if (side == 0) return Evenness::uncertain;
        const std::array<glm::vec3, 3> ends = {cap.a, cap.b, cap.c};
        for (std::size_t e = 0; e < 3; ++e) {
            const std::size_t f = (e + 1) % 3;
            const bool forward = orderedBefore(ends[e], ends[f]);
            const glm::vec3 &a = forward ? ends[e] : ends[f], &b = forward ? ends[f] : ends[e];
            touched.edges.push_back({a, b, forward ? side : -side, numberOf(a, b)});
        }
    }
    return anySilhouette(touched.edges, volume) ? Evenness::outlineMet : Evenness::even;
}

} // namespace edgeshade
