#include "src/shadow/geometry/separation.hpp"

#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/geometry/interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace edgeshade {
namespace {

/// Bound of the angle by which rounding to floats may turn a directional light's direction, with a
/// margin.
constexpr double leastTurn = 1e-6;

/// A volume's interval along an axis, and the size of its coordinates there.
struct Shade {
    Interval interval;
    double size = 0.0;
};

Shade shadeOf(const NearClipVolume& volume, const glm::dvec3& axis) {
    Shade shade;
    const auto add = [&](const glm::dvec3& point) {
        shade.interval.add(glm::dot(axis, point));
        shade.size = std::max(shade.size, glm::dot(glm::abs(axis), glm::abs(point)));
    };
    for (const glm::dvec3& corner : volume.corners)
        add(corner);
    const glm::dvec3 light(volume.light);
    if (volume.light.w != 0.0) {
        add(light);
        return shade;
    }
    const double along = glm::dot(axis, light);
    const double rounding = placingError * glm::dot(glm::abs(axis), glm::abs(light));
    if (along > -rounding) shade.interval.high = std::numeric_limits<double>::infinity();
    if (along < rounding) shade.interval.low = -std::numeric_limits<double>::infinity();
    return shade;
}

/// Whether the volume and `other`, with coordinates up to `size`, are apart along the axis.
bool separates(const NearClipVolume& volume, const glm::dvec3& axis, const Interval& other,
               double size) {
    const Shade shade = shadeOf(volume, axis);
    const double gap = std::max(shade.interval.low - other.high, other.low - shade.interval.high);
    return gap > placingError * std::max(size, shade.size);
}

/// Calls `separate` for axes of unit length until it returns true. The candidates for convex sets
/// are normals of their faces and cross products of their edges; `edges` and `normals` are the
/// other set's.
template <class Separate>
bool anyAxis(const NearClipVolume& volume, std::span<const glm::dvec3> normals,
             std::span<const glm::dvec3> edges, Separate separate) {
    const auto tried = [&](const glm::dvec3& axis) {
        const double length = glm::length(axis);
        return length > 0.0 && std::isfinite(length) && separate(axis / length);
    };
    const auto& c = volume.corners;
    const glm::dvec3 light(volume.light);
    std::array<glm::dvec3, 6> own = {c[1] - c[0], c[3] - c[0]};
    for (std::size_t i = 0; i < 4; ++i)
        own[2 + i] = light - c[i] * volume.light.w;
    if (std::any_of(normals.begin(), normals.end(), tried)) return true;
    if (tried(glm::cross(own[0], own[1]))) return true;
    for (std::size_t i = 0; i < 4; ++i)
        if (tried(glm::cross(own[2 + i], c[(i + 1) % 4] - c[i]))) return true;
    for (const glm::dvec3& edge : own)
        for (const glm::dvec3& other : edges)
            if (tried(glm::cross(edge, other))) return true;
    return false;
}

} // namespace

bool areApart(const NearClipVolume& volume, const Box& box) {
    if (box.empty()) return true;
    const std::array<glm::dvec3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const glm::dvec3 center = box.center();
    const glm::dvec3 half = box.high - center;
    const glm::dvec3 largest = glm::max(glm::abs(box.low), glm::abs(box.high));
    return anyAxis(volume, axes, axes, [&](const glm::dvec3& axis) {
        const double at = glm::dot(axis, center), reach = glm::dot(glm::abs(axis), half);
        return separates(volume, axis, {at - reach, at + reach}, glm::dot(glm::abs(axis), largest));
    });
}

bool areApart(const NearClipVolume& volume, const std::array<glm::dvec3, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const std::array<glm::dvec3, 3> edges = {b - a, c - b, a - c};
    const std::array<glm::dvec3, 1> normals = {glm::cross(edges[0], edges[1])};
    return anyAxis(volume, normals, edges, [&](const glm::dvec3& axis) {
        Interval interval;
        double size = 0.0;
        for (const glm::dvec3& corner : triangle) {
            interval.add(glm::dot(axis, corner));
            size = std::max(size, glm::dot(glm::abs(axis), glm::abs(corner)));
        }
        return separates(volume, axis, interval, size);
    });
}

ClipVolumeFaces::ClipVolumeFaces(const NearClipVolume& volume) : volume_(volume) {
    const auto& c = volume.corners;
    const glm::dvec3 light(volume.light);
    add(glm::cross(c[1] - c[0], c[3] - c[0]), c[0], volume.light);
    hasRectangle_ = count_ == 1;
    for (std::size_t i = 0; i < 4; ++i)
        add(glm::cross(light - c[i] * volume.light.w, c[(i + 1) % 4] - c[i]), c[i],
            glm::dvec4(c[(i + 2) % 4], 1.0));
}

void ClipVolumeFaces::add(const glm::dvec3& normal, const glm::dvec3& point,
                          const glm::dvec4& inside) {
    const double length = glm::length(normal);
    if (!(length > 0.0) || !std::isfinite(length)) return;
    glm::dvec4 plane(normal / length, 0.0);
    plane.w = -glm::dot(glm::dvec3(plane), point);
    const double side = glm::dot(plane, inside);
    if (side == 0.0) return;
    if (side < 0.0) plane = -plane;
    double size = std::abs(plane.w);
    for (const glm::dvec3& corner : volume_.corners)
        size = std::max(size, glm::dot(glm::abs(glm::dvec3(plane)), glm::abs(corner)));
    if (volume_.light.w != 0.0)
        size = std::max(size,
                        glm::dot(glm::abs(glm::dvec3(plane)), glm::abs(glm::dvec3(volume_.light))));
    faces_[count_++] = {plane, size};
}

double ClipVolumeFaces::turnAt(const glm::dvec3& a, const glm::dvec3& b,
                               const glm::dvec3& c) const {
    if (volume_.light.w != 0.0) return 0.0;
    const glm::dvec3& from = volume_.corners[0];
    const glm::dvec3 farthest =
        glm::max(glm::max(glm::abs(a - from), glm::abs(b - from)), glm::abs(c - from));
    return leastTurn * glm::length(farthest);
}

bool ClipVolumeFaces::separate(const std::array<glm::dvec3, 3>& triangle) const {
    const double turn = turnAt(triangle[0], triangle[1], triangle[2]);
    for (std::size_t i = 0; i < count_; ++i) {
        const Face& face = faces_[i];
        double highest = -std::numeric_limits<double>::infinity(), size = face.size;
        for (const glm::dvec3& corner : triangle) {
            highest = std::max(highest, glm::dot(glm::dvec3(face.plane), corner) + face.plane.w);
            size = std::max(size, glm::dot(glm::abs(glm::dvec3(face.plane)), glm::abs(corner)));
        }
        if (highest < -placingError * size - turn) return true;
    }
    const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double length = glm::length(normal);
    if (!(length > 0.0) || !std::isfinite(length)) return false;
    Interval interval;
    double size = 0.0;
    for (const glm::dvec3& corner : triangle) {
        interval.add(glm::dot(normal, corner) / length);
        size = std::max(size, glm::dot(glm::abs(normal), glm::abs(corner)) / length);
    }
    return separates(volume_, normal / length, interval, size);
}

bool ClipVolumeFaces::separate(const Box& box) const {
    const glm::dvec3 largest = glm::max(glm::abs(box.low), glm::abs(box.high));
    const double turn = turnAt(box.low, box.high, box.high);
    return std::any_of(faces_.begin(), faces_.begin() + count_, [&](const Face& face) {
        const double size =
            std::max(face.size, glm::dot(glm::abs(glm::dvec3(face.plane)), largest));
        return largestOver(box, face.plane) < -placingError * size - turn;
    });
}

bool ClipVolumeFaces::areBeforeRectangle(const std::array<glm::dvec3, 3>& triangle) const {
    if (!hasRectangle_) return false;
    const Face& face = faces_[0];
    return std::all_of(triangle.begin(), triangle.end(), [&](const glm::dvec3& corner) {
        const glm::dvec3 normal(face.plane);
        const double size = std::max(face.size, glm::dot(glm::abs(normal), glm::abs(corner)));
        return glm::dot(normal, corner) + face.plane.w > placingError * size;
    });
}

} // namespace edgeshade
