#include "src/shadow/geometry/normal_cone.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

/// Several times the rounding of an axis to floats.
constexpr double axisRounding = 2e-6;

double sineOf(const NormalCone& cone) {
    return std::sqrt(std::max(0.0, 1.0 - cone.cosine * cone.cosine));
}

} // namespace

NormalCone coneOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
    const double twiceArea = glm::length(normal);
    if (!(twiceArea > 0.0)) return {};
    return {normal / twiceArea, 1.0, twiceArea / (glm::length(ab) + glm::length(ac))};
}

NormalCone coneAround(std::span<const NormalCone> cones) {
    glm::dvec3 sum(0.0);
    double thickness = INFINITY;
    for (const NormalCone& cone : cones) {
        sum += cone.axis;
        thickness = std::min(thickness, cone.thickness);
    }
    const double length = glm::length(sum);
    if (!(length > 0.0) || !(thickness > 0.0)) return {};
    NormalCone around{sum / length, 1.0, thickness};
    for (const NormalCone& cone : cones) {
        // The cosine of the sum of two angles, at most three right angles together.
        const double cosine = glm::dot(around.axis, cone.axis);
        const double sine = glm::length(glm::cross(around.axis, cone.axis));
        around.cosine = std::min(around.cosine, cosine * cone.cosine - sine * sineOf(cone));
    }
    return around.cosine > axisRounding ? around : NormalCone();
}

BackView::BackView(const glm::dmat4& viewFromSpace, bool orthographic, double error)
    : viewFromSpace_(viewFromSpace), orthographic_(orthographic), error_(error) {
    const glm::dmat3 linear(viewFromSpace);
    const double volume = glm::determinant(linear), sign = volume < 0.0 ? -1.0 : 1.0;
    scale_ = orthographic ? 0.0 : std::abs(volume);
    for (glm::length_t i = 0; i < 3; ++i) {
        cofactors_[i] = sign * glm::cross(linear[(i + 1) % 3], linear[(i + 2) % 3]);
        stretch_ += glm::dot(linear[i], linear[i]);
    }
    stretch_ = std::sqrt(stretch_);
}

bool BackView::showsBacks(const NormalCone& cone, const glm::dvec3& center, double radius) const {
    if (!(cone.thickness > 0.0)) return false;
    const glm::dvec3 seen = orthographic_ ? glm::dvec3(0.0, 0.0, -1.0)
                                          : glm::dvec3(viewFromSpace_ * glm::dvec4(center, 1.0));
    // A triangle's normal times this, at its corner in place of the center, is what showsBack()
    // compares, negated.
    const glm::dvec3 away = seen * cofactors_;
    const double along = glm::dot(cone.axis, away);
    if (!(along > 0.0)) return false;
    const double across = glm::length(glm::cross(cone.axis, away));
    const double least = along * cone.cosine - across * sineOf(cone) - scale_ * radius;
    const double sides = 4.0 * stretch_ * radius + error_;
    const double distance = glm::length(seen) + (orthographic_ ? 0.0 : stretch_ * radius);
    // A triangle's sides ab and ac sum up to at least four times its thickness.
    return least * cone.thickness >
           5.0 * error_ * (stretch_ + error_ / (4.0 * cone.thickness)) * (sides + distance);
}

void FourCones::set(std::size_t lane, const NormalCone& cone) {
    for (std::size_t i = 0; i < 3; ++i)
        axis[i][lane] = static_cast<float>(cone.axis[static_cast<glm::length_t>(i)]);
    cosine[lane] = static_cast<float>(cone.cosine - axisRounding);
    thickness[lane] = static_cast<float>((1.0 - axisRounding) * cone.thickness);
}

NormalCone FourCones::at(std::size_t lane) const {
    return {{axis[0][lane], axis[1][lane], axis[2][lane]}, cosine[lane], thickness[lane]};
}

} // namespace edgeshade
