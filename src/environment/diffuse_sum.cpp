#include "src/environment/diffuse_sum.hpp"

namespace edgeshade {
namespace {

/// For each harmonic the squared norm of its factor, times 4 pi, times the clamped cosine's factor
/// for its band over pi: 1, 2/3, 1/4.
constexpr std::array<double, 9> scales = {1.0,      3.0 * 2 / 3, 3.0 * 2 / 3, 3.0 * 2 / 3, 15.0 / 4,
                                          15.0 / 4, 5.0 / 16,    15.0 / 4,    15.0 / 16};

} // namespace

std::array<float, 9> diffuseTerms(const glm::vec3& n) {
    return {1.0f,
            n.y,
            n.z,
            n.x,
            n.x * n.y,
            n.y * n.z,
            3.0f * n.z * n.z - 1.0f,
            n.x * n.z,
            n.x * n.x - n.y * n.y};
}

void DiffuseSum::add(const glm::vec3& direction, const glm::vec3& radiance, double solidAngle) {
    const std::array<float, 9> terms = diffuseTerms(direction);
    const glm::dvec3 weighted = glm::dvec3(radiance) * solidAngle;
    for (std::size_t i = 0; i < terms.size(); ++i)
        sums_[i] += weighted * static_cast<double>(terms[i]);
    solidAngle_ += solidAngle;
}

glm::dvec3 DiffuseSum::mean() const {
    return sums_[0] / solidAngle_;
}

DiffuseCoefficients DiffuseSum::coefficients() const {
    DiffuseCoefficients coefficients;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        coefficients[i] = glm::vec3(sums_[i] * (scales[i] / solidAngle_));
    return coefficients;
}

} // namespace edgeshade
