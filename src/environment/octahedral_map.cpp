#include "src/environment/octahedral_map.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Reflects a point over the diagonal edge, as the lower half is folded outwards.
glm::vec2 folded(const glm::vec2& at) {
    return {(1.0f - std::abs(at.y)) * (at.x >= 0.0f ? 1.0f : -1.0f),
            (1.0f - std::abs(at.x)) * (at.y >= 0.0f ? 1.0f : -1.0f)};
}

/// The point on the octahedron |x| + |y| + |z| = 1.
glm::vec3 pointFromOctahedral(const glm::vec2& at) {
    const float height = 1.0f - std::abs(at.x) - std::abs(at.y);
    const glm::vec2 ground = height >= 0.0f ? at : folded(at);
    return {ground.x, height, ground.y};
}

} // namespace

glm::vec2 octahedralFromDirection(const glm::vec3& direction) {
    const glm::vec3 size = glm::abs(direction);
    const glm::vec2 at = glm::vec2(direction.x, direction.z) / (size.x + size.y + size.z);
    return direction.y >= 0.0f ? at : folded(at);
}

glm::vec3 directionFromOctahedral(const glm::vec2& at) {
    return glm::normalize(pointFromOctahedral(at));
}

OctahedralMap::OctahedralMap(int size)
    : size_(size), texels_(static_cast<std::size_t>(size + 2) * static_cast<std::size_t>(size + 2),
                           glm::vec3(0.0f)) {}

glm::vec2 OctahedralMap::middle(int x, int y) const {
    return (glm::vec2(x, y) + 0.5f) * (2.0f / static_cast<float>(size_)) - 1.0f;
}

glm::vec3 OctahedralMap::direction(int x, int y) const {
    return directionFromOctahedral(middle(x, y));
}

glm::ivec2 OctahedralMap::texelAt(const glm::vec3& direction) const {
    const glm::vec2 texel =
        (octahedralFromDirection(direction) * 0.5f + 0.5f) * static_cast<float>(size_);
    return glm::min(glm::ivec2(texel), glm::ivec2(size_ - 1));
}

float OctahedralMap::solidAngle(int x, int y) const {
    // A face is 1 / sqrt(3) from the centre, and unfolding shrinks it by sqrt(3).
    const float distance = glm::length(pointFromOctahedral(middle(x, y)));
    const float edge = 2.0f / static_cast<float>(size_);
    return edge * edge / (distance * distance * distance);
}

void OctahedralMap::closeBorder() {
    const int last = size_ - 1;
    for (int i = 0; i < size_; ++i) {
        at(i, -1) = at(last - i, 0);
        at(i, size_) = at(last - i, last);
        at(-1, i) = at(0, last - i);
        at(size_, i) = at(last, last - i);
    }
    at(-1, -1) = at(last, last);
    at(size_, -1) = at(0, last);
    at(-1, size_) = at(last, 0);
    at(size_, size_) = at(0, 0);
}

float OctahedralMap::largest() const {
    float largest = 0.0f;
    for (const glm::vec3& texel : texels_)
        largest = std::max({largest, texel.r, texel.g, texel.b});
    return largest;
}

glm::vec3 OctahedralMap::lookUp(const glm::vec3& direction) const {
    const glm::vec2 texel =
        (octahedralFromDirection(direction) * 0.5f + 0.5f) * static_cast<float>(size_) +
        0.5f; // counted from the middle of the border's first texel
    const glm::ivec2 first = glm::min(glm::ivec2(texel), glm::ivec2(size_));
    const glm::vec2 share = texel - glm::vec2(first);
    const std::size_t corner = index(first.x - 1, first.y - 1);
    const std::size_t below = corner + static_cast<std::size_t>(size_ + 2);
    return glm::mix(glm::mix(texels_[corner], texels_[corner + 1], share.x),
                    glm::mix(texels_[below], texels_[below + 1], share.x), share.y);
}

} // namespace edgeshade
