#include "preprocess/scene/node_transform.hpp"

#include "preprocess/base/vectors.hpp"
#include "preprocess/scene/extremes.hpp"

namespace edgeshade {
namespace {

/// The vector at length 1, whatever its size; null if it is 0 or not finite.
std::optional<glm::dvec3> unit(const glm::dvec3& v) {
    const double largest = largestComponent(v);
    if (!isFinite(v) || largest == 0.0) return std::nullopt;
    return glm::normalize(v / largest);
}

/// Threshold of a column that was 1; rounding leaves less of a column that was 0.
constexpr double nothing = 1e-9;

/// The transform, with vanished columns taken from `unflattened`.
glm::dmat4 mended(const glm::dmat4& transform, const glm::dmat4& unflattened) {
    glm::dmat4 mended = transform;
    for (glm::length_t c = 0; c < 3; ++c)
        if (largestComponent(glm::dvec3(transform[c])) <=
            nothing * largestComponent(glm::dvec3(unflattened[c])))
            mended[c] = unflattened[c];
    return mended;
}

} // namespace

glm::dmat4 NodeTransform::matrix() const {
    glm::dmat4 parentFromNode = glm::mat4_cast(rotation);
    for (glm::length_t c = 0; c < 3; ++c)
        parentFromNode[c] *= scale[c];
    parentFromNode[3] = glm::dvec4(translation, 1.0);
    return parentFromNode;
}

glm::dmat4 NodeTransform::unflattened() const {
    NodeTransform transform = *this;
    for (glm::length_t c = 0; c < 3; ++c)
        if (scale[c] == 0.0) transform.scale[c] = 1.0;
    return transform.matrix();
}

glm::dmat4 unflattened(const glm::dmat4& parentFromNode) {
    glm::dmat4 mended = parentFromNode;
    for (glm::length_t c = 0; c < 3; ++c) {
        if (largestComponent(glm::dvec3(parentFromNode[c])) != 0.0) continue;
        const auto next = unit(glm::dvec3(parentFromNode[(c + 1) % 3]));
        const auto last = unit(glm::dvec3(parentFromNode[(c + 2) % 3]));
        if (next && last) mended[c] = glm::dvec4(glm::cross(*next, *last), 0.0);
    }
    return mended;
}

std::optional<glm::dvec3> originOf(const glm::dmat4& transform) {
    const glm::dvec3 origin(transform[3]);
    if (!isFinite(origin) || largestComponent(origin) > farthestPlace) return std::nullopt;
    return origin;
}

std::optional<glm::dmat3> turnOf(const glm::dmat4& transform) {
    const auto back = unit(glm::dvec3(transform[2])), upward = unit(glm::dvec3(transform[1]));
    if (!back || !upward) return std::nullopt;
    const auto right = unit(glm::cross(*upward, *back));
    if (!right) return std::nullopt;
    return glm::dmat3(*right, glm::cross(*back, *right), *back);
}

std::optional<glm::dmat3> turnOf(const glm::dmat4& transform, const glm::dmat4& unflattened) {
    if (transform == unflattened) return turnOf(transform);
    const glm::dmat4 told = mended(transform, unflattened);
    const auto back = unit(glm::dvec3(told[2])), upward = unit(glm::dvec3(told[1]));
    const bool parallel = back && upward && largestComponent(glm::cross(*upward, *back)) <= nothing;
    return turnOf(parallel ? unflattened : told);
}

std::optional<glm::dvec3> forwardOf(const glm::dmat4& transform, const glm::dmat4& unflattened) {
    const auto back = unit(glm::dvec3(mended(transform, unflattened)[2]));
    if (!back) return std::nullopt;
    return -*back;
}

} // namespace edgeshade
