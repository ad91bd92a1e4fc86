#include "src/rays/sun_packet.hpp"

#include "preprocess/base/vectors.hpp"
#include "src/rays/exact_blocking.hpp"
#include "src/shadow/lights/light_contact.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::rays {
namespace {

/// Half a unit in the last place of a double at 1.
constexpr double doubleUnit = 0x1p-53;
/// Bound of a determinant's error, in units of the product of its vectors' sums of magnitudes: the
/// test below rounds at most twelve times on the way to one (docs/method.md, C56).
constexpr double roundings = 16.0 * doubleUnit;
/// Values below this may have lost digits to underflow.
constexpr double underflow = 1e-290;

double sumOf(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// The sign of dot(a, b), without rounding.
int dotSign(const glm::dvec3& a, const glm::dvec3& b) {
    const double value = glm::dot(a, b);
    const double error =
        roundings * (std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z));
    if (std::abs(value) > error + underflow) return value > 0.0 ? 1 : -1;
    return dotSignExactly(a, b);
}

/// The sign of dot(normal, direction) for a triangle. `error`: bound of the normal's, times the
/// direction's sum of magnitudes.
int sideOf(const Corners& triangle, const glm::dvec3& normal, double error,
           const glm::dvec3& direction) {
    const double value = glm::dot(normal, direction);
    if (std::abs(value) > error * sumOf(direction) + underflow) return value > 0.0 ? 1 : -1;
    return sideExactly(triangle, direction);
}

/// A half-space's test: a point is certainly outside where x * n.x + y * n.y + z * n.z - offset is
/// above `error`, and certainly inside where it is below -error.
struct HalfSpace {
    double x, y, z, offset, error;
};

/// A bit for each point, as wide as a double, so that no vector has to be narrowed.
constexpr std::array<std::uint64_t, packetSize> laneBits = [] {
    std::array<std::uint64_t, packetSize> bits{};
    for (std::size_t i = 0; i < packetSize; ++i)
        bits[i] = std::uint64_t{1} << i;
    return bits;
}();

/// Points of a packet relative to the first one, and the bounds of what is rounded there.
struct Places {
    const glm::dvec3& first;
    const double *x, *y, *z;
    double reach; ///< largest magnitude of these
    double error; ///< bound of their errors, by component
};

/// The points whose light a triangle certainly doesn't block, and certainly blocks.
struct Outcome {
    Lanes misses, meets;
    bool sided; ///< false: nearly edge-on to the sun, with no certain sign to compare with, so that
                ///< the points have no meaning
};

// Compiled for several vector widths; the processor's is taken at run time. The operations are the
// same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__)
__attribute__((target_clones("avx512f", "avx2", "default")))
#endif
Outcome
outcomeOf(const Corners& corners, const glm::dvec3& sun, double sunSum, const Places& places) {
    const glm::dvec3 ab = corners[1] - corners[0], bc = corners[2] - corners[1],
                     ca = corners[0] - corners[2];
    const glm::dvec3 normal = glm::cross(ab, -ca);
    const std::array<double, 3> sums = {sumOf(ab), sumOf(bc), sumOf(ca)};
    const double along = glm::dot(normal, sun);
    const double alongError = roundings * sums[0] * sums[2] * sunSum + underflow;
    // The sun comes from the front if `along` is above 0; then a point is outside of an edge where
    // its determinant is.
    const double sign = along < 0.0 ? -1.0 : 1.0;
    const std::array<glm::dvec3, 3> from = {corners[0] - places.first, corners[1] - places.first,
                                            corners[2] - places.first};
    const double size =
        std::max({largestComponent(from[0]), largestComponent(from[1]), largestComponent(from[2])});
    const double placing = 1.01 * places.error + roundings * (size + places.reach);
    // Written out: lambdas aren't compiled for the widths.
    const std::array<glm::dvec3, 3> edges = {ab, bc, ca};
    std::array<HalfSpace, 4> spaces;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 n = sign * glm::cross(edges[i], sun);
        spaces[i] = {n.x, n.y, n.z, glm::dot(n, from[i]), sums[i] * sunSum * placing + underflow};
    }
    const glm::dvec3 n = sign * normal;
    spaces[3] = {n.x, n.y, n.z, glm::dot(n, from[0]), sums[0] * sums[2] * placing + underflow};
    alignas(64) double highest[packetSize], lowest[packetSize];
    for (std::size_t i = 0; i < packetSize; ++i) {
        double high = -1e300, low = -1e300;
        for (const HalfSpace& space : spaces) {
            const double value = space.x * places.x[i] + space.y * places.y[i] +
                                 space.z * places.z[i] - space.offset;
            const double out = value - space.error, in = value + space.error;
            high = out > high ? out : high;
            low = in > low ? in : low;
        }
        highest[i] = high;
        lowest[i] = low;
    }
    std::uint64_t bits = 0; // meets above misses
    for (std::size_t i = 0; i < packetSize; ++i) {
        bits |= highest[i] > 0.0 ? laneBits[i] : 0;
        bits |= lowest[i] < 0.0 ? laneBits[i] << packetSize : 0;
    }
    return {static_cast<Lanes>(bits), static_cast<Lanes>(bits >> packetSize),
            std::abs(along) > alongError};
}

} // namespace

SunPacket::SunPacket(const SurfaceSet& surfaces, const Holes& holes,
                     std::span<const SurfacePoint> points, std::span<const std::uint32_t> slots)
    : set_(surfaces), holes_(holes), points_(points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        double error = 0.0;
        addSurface(i, slots);
        place(i, places_[i], error);
        error_ = std::max(error_, error);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 offset = places_[i] - places_[0];
        x_[i] = offset.x;
        y_[i] = offset.y;
        z_[i] = offset.z;
        reach_ = std::max(reach_, largestComponent(offset));
    }
    origins_ = surfaces.tree.originsOf(std::span(places_).first(points.size()));
}

void SunPacket::addSurface(std::size_t point, std::span<const std::uint32_t> slots) {
    const SurfacePoint& at = points_[point];
    if (at.triangle == SurfacePoint::none) return;
    const auto lane = static_cast<Lanes>(1u << point);
    std::size_t i = 0;
    while (i < surfaceCount_ && surfaces_[i].triangle != at.triangle)
        ++i;
    Surface& surface = surfaces_[i];
    const Corners& corners = set_.corners[at.triangle];
    if (i == surfaceCount_) {
        ++surfaceCount_;
        const SurfaceTriangle& triangle = set_.triangles[at.triangle];
        const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
        surface.triangle = at.triangle;
        surface.normal = glm::cross(ab, ac);
        surface.normalError = roundings * sumOf(ab) * sumOf(ac);
        surface.slot = slots[triangle.batch];
        surface.casts = triangle.casts;
        const std::array<glm::dvec3, 3> inBatch = cornersInBatch(triangle);
        const glm::dvec3 across = glm::cross(inBatch[1] - inBatch[0], inBatch[2] - inBatch[0]);
        const double size = glm::length(across);
        if (size > 0.0) surface.normalInBatch = across / size;
    }
    surface.points |= lane;
    addCoplanar(at.triangle, lane);
    const int side = sideOf(corners, surface.normal, surface.normalError, at.direction);
    if (side < 0) surface.fromFront |= lane;
    if (side > 0) surface.fromBack |= lane;
}

void SunPacket::place(std::size_t point, glm::dvec3& place, double& error) const {
    const SurfacePoint& at = points_[point];
    place = at.origin;
    error = 0.0;
    if (at.triangle == SurfacePoint::none || at.direction == glm::dvec3(0.0)) return;
    const Corners& corners = set_.corners[at.triangle];
    const auto surface = std::find_if(surfaces_.begin(), surfaces_.end(), [&](const Surface& of) {
        return of.triangle == at.triangle;
    });
    const double size = largestComponent(at.direction);
    const glm::dvec3 direction = at.direction / size, from = corners[0] - at.origin;
    const double along = glm::dot(surface->normal, direction),
                 height = glm::dot(surface->normal, from);
    const double alongError = surface->normalError * sumOf(direction),
                 heightError = surface->normalError * largestComponent(from);
    // Seen nearly edge-on, the point is rounded from its exact place.
    if (std::abs(along) > 1e3 * alongError + underflow) {
        const double t = height / along;
        place = at.origin + t * direction;
        error = 1.01 * (heightError + std::abs(t) * alongError) / (std::abs(along) - alongError) +
                8.0 * doubleUnit * (std::abs(t) + largestComponent(at.origin));
    } else {
        place = placeExactly(at, corners);
        error = 2.0 * doubleUnit * largestComponent(place) + underflow;
    }
}

Lanes SunPacket::facing(const SunDirection& sun) const {
    Lanes facing = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (points_[i].triangle != SurfacePoint::none) continue;
        const glm::dvec3& sight = points_[i].direction;
        if (sight == glm::dvec3(0.0) || dotSign(sight, sun.exact) < 0)
            facing |= static_cast<Lanes>(1u << i);
    }
    for (std::size_t i = 0; i < surfaceCount_; ++i) {
        const Surface& surface = surfaces_[i];
        if (surface.normalInBatch != glm::dvec3(0.0) &&
            grazesFrom(surface.normalInBatch, sun.inBatch[surface.slot]))
            continue;
        if (!surface.casts) {
            facing |= surface.points;
            continue;
        }
        const int side =
            sideOf(set_.corners[surface.triangle], surface.normal, surface.normalError, sun.scaled);
        const auto turnedAway = static_cast<Lanes>(side > 0   ? surface.fromBack
                                                   : side < 0 ? surface.fromFront
                                                              : 0);
        facing |= static_cast<Lanes>(surface.points & ~turnedAway);
    }
    return facing;
}

Lanes SunPacket::lit(const SunDirection& sun) {
    lit_ = facing(sun);
    if (lit_ == 0) return 0;
    sun_ = &sun;
    sunSum_ = sumOf(sun.scaled);
    // The last direction's blocker is likely to block this one too.
    tried_ = SurfacePoint::none;
    const std::uint32_t last = blocker_;
    if (last != SurfacePoint::none) test(last);
    tried_ = last;
    if (lit_ == 0) return 0;
    if (origins_.inside) {
        set_.tree.visitPacket(
            origins_, sun.scaled, lit_,
            [](void* packet, std::uint32_t triangle) {
                return static_cast<SunPacket*>(packet)->test(triangle);
            },
            this);
        return lit_;
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
        if ((lit_ >> i & 1) != 0)
            set_.tree.visit(places_[i], sun.scaled, std::numeric_limits<double>::infinity(),
                            [&](std::uint32_t triangle) {
                                test(triangle);
                                return (lit_ >> i & 1) == 0;
                            });
    return lit_;
}

Lanes SunPacket::test(std::uint32_t triangle) {
    if (triangle == tried_ || set_.casts[triangle] == 0) return 0;
    Lanes open = lit_;
    for (std::size_t i = 0; i < coplanarCount_; ++i)
        if (coplanar_[i].triangle == triangle) open &= static_cast<Lanes>(~coplanar_[i].points);
    if (open == 0) return 0;

    const Corners& corners = set_.corners[triangle];
    const auto [misses, meets, sided] =
        outcomeOf(corners, sun_->scaled, sunSum_,
                  {places_[0], x_.data(), y_.data(), z_.data(), reach_, error_});
    Lanes blocked = 0;
    if (sided) {
        blocked = open & meets;
        const auto doubtful = static_cast<Lanes>(open & ~meets & ~misses);
        if (doubtful != 0) blocked |= settled(triangle, doubtful);
    } else if (sideExactly(corners, sun_->exact) != 0) {
        blocked = settled(triangle, open);
    }
    if (blocked == 0) return 0;
    if (holes_.any()) blocked = withoutHoles(triangle, blocked);
    lit_ &= static_cast<Lanes>(~blocked);
    if (blocked != 0) blocker_ = triangle;
    return blocked;
}

Lanes SunPacket::settled(std::uint32_t triangle, Lanes doubtful) {
    Lanes blocked = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if ((doubtful >> i & 1) == 0) continue;
        const std::uint32_t own = points_[i].triangle;
        const auto lane = static_cast<Lanes>(1u << i);
        const Blocking blocking =
            blockingExactly(points_[i], own == SurfacePoint::none ? nullptr : &set_.corners[own],
                            set_.corners[triangle], glm::dvec4(sun_->exact, 0.0));
        if (blocking == Blocking::blocks) blocked |= lane;
        if (blocking == Blocking::inPlane) addCoplanar(triangle, lane);
    }
    return blocked;
}

void SunPacket::addCoplanar(std::uint32_t triangle, Lanes point) {
    std::size_t i = 0;
    while (i < coplanarCount_ && coplanar_[i].triangle != triangle)
        ++i;
    if (i == coplanar_.size()) return; // integers will decide again
    if (i == coplanarCount_) coplanar_[coplanarCount_++] = {triangle, 0};
    coplanar_[i].points |= point;
}

Lanes SunPacket::withoutHoles(std::uint32_t triangle, Lanes blocked) const {
    for (std::size_t i = 0; i < points_.size(); ++i)
        if ((blocked >> i & 1) != 0 &&
            holes_.at(set_.triangles, triangle, places_[i], sun_->scaled))
            blocked &= static_cast<Lanes>(~(1u << i));
    return blocked;
}

} // namespace edgeshade::rays
