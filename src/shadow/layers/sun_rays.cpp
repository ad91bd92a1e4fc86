#include "src/shadow/layers/sun_rays.hpp"

#include "preprocess/base/vectors.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Rounding of a ray, as a share of its terms: seven roundings to floats.
constexpr double rayRounding = 0x1p-21;

/// Bounds a box's extent and the map's columns: no product is beyond the range of floats.
constexpr double mostInFloats = 0x1p100;

silhouette::Floats twice(const glm::dvec3& v) {
    const auto x = static_cast<float>(v.x), y = static_cast<float>(v.y);
    return silhouette::Floats{x, y, x, y};
}

} // namespace

SunRays::SunRays(const RaysOfBatch& rays, const Box& box) : center_(box.center()) {
    const glm::dvec3 center(center_), offset = rays.to(center_);
    const glm::dvec3 extent = glm::max(box.high - center, center - box.low);
    glm::dvec3 terms = glm::abs(offset);
    double largest = largestComponent(extent);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::dvec3& column = rays.linear[axis];
        columns_[static_cast<std::size_t>(axis)] = twice(column);
        terms += glm::abs(column) * extent[axis];
        largest = std::max(largest, largestComponent(column));
    }
    offset_ = twice(offset);
    rounding_ = largest < mostInFloats ? rayRounding * std::max(terms.x, terms.y) : INFINITY;
}

} // namespace edgeshade
