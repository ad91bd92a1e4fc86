#include "tests/lab/line_counts.hpp"

#include "preprocess/mesh/topology.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::test {
namespace {

/// Corners of all casters, three each, in the world.
std::vector<glm::dvec3> cornersOf(const Scene& scene, bool castMasked) {
    std::vector<glm::dvec3> corners;
    for (const Batch& batch : scene.batches) {
        if (batch.hidden) continue;
        for (const std::uint32_t index : castersOf(batch, scene.materials, castMasked).indices)
            corners.emplace_back(batch.worldFromBatch *
                                 glm::dvec4(batch.geometry->positions[index], 1.0));
    }
    return corners;
}

} // namespace

LineCounts::LineCounts(const Scene& scene, bool castMasked, const Light& light, int side)
    : view_(light), side_(side), faces_(view_.faces.size()) {
    const std::vector<glm::dvec3> corners = cornersOf(scene, castMasked);
    for (Face& face : faces_) {
        face.part = view_.wholeFace();
        face.counts.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
    }
    if (view_.directional) {
        faces_[0].part = {};
        for (const glm::dvec3& corner : corners) {
            const glm::dvec3 ray = view_.rayTo(corner);
            faces_[0].part.add({ray.x, ray.x, ray.y, ray.y});
        }
    }
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const Rays rays{view_.rayTo(corners[i]), view_.rayTo(corners[i + 1]),
                        view_.rayTo(corners[i + 2])};
        double largest = glm::length(view_.origin);
        for (std::size_t c = 0; c < 3; ++c)
            largest = std::max(largest, glm::length(corners[i + c]));
        add(rays, 1e-15 * largest);
    }
}

glm::dvec2 LineCounts::lineAt(const Face& face, int row, int column) const {
    // Not in line with regular models.
    const double u = (column + 0.4871) / side_, v = (row + 0.5233) / side_;
    return {glm::mix(face.part.u0, face.part.u1, u), glm::mix(face.part.v0, face.part.v1, v)};
}

void LineCounts::add(const Rays& rays, double rounding) {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        Face& face = faces_[f];
        Outline outline;
        if (view_.directional)
            for (const glm::dvec3& ray : rays)
                outline.add({ray.x, ray.x, ray.y, ray.y});
        else
            outline = outlineOf(polygonOn(view_.faces[f], rays).all());
        if (outline.misses(face.part)) continue;
        const auto index = [&](double at, double low, double high) {
            return static_cast<int>(
                std::clamp((at - low) / (high - low) * side_, 0.0, static_cast<double>(side_ - 1)));
        };
        const int left = index(outline.u0, face.part.u0, face.part.u1);
        const int right = index(outline.u1, face.part.u0, face.part.u1);
        const int top = index(outline.v1, face.part.v0, face.part.v1);
        for (int row = index(outline.v0, face.part.v0, face.part.v1); row <= top; ++row)
            for (int column = left; column <= right; ++column) {
                const glm::dvec3 line = view_.faces[f] * glm::dvec3(lineAt(face, row, column), 1.0);
                if (meets(line, rays, rounding))
                    ++face.counts[static_cast<std::size_t>(row * side_ + column)];
            }
    }
}

bool LineCounts::meets(const glm::dvec3& line, const Rays& rays, double rounding) const {
    const double sense = glm::dot(rays[0], glm::cross(rays[1], rays[2])) > 0.0 ? 1.0 : -1.0;
    std::array<double, 3> shares;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &p = rays[i], &q = rays[(i + 1) % 3];
        const double sizes = glm::length(p) + glm::length(q);
        shares[(i + 2) % 3] = sense * glm::dot(line, glm::cross(p, q));
        if (!(shares[(i + 2) % 3] > 4.0 * (rounding + 1e-13 * sizes) * sizes * glm::length(line)))
            return false;
    }
    if (!std::isfinite(view_.range)) return true;
    const glm::dvec3 at = (shares[0] * rays[0] + shares[1] * rays[1] + shares[2] * rays[2]) /
                          (shares[0] + shares[1] + shares[2]);
    return glm::length(at) < view_.range;
}

std::size_t LineCounts::most() const {
    std::size_t most = 0;
    for (const Face& face : faces_)
        most = std::max(most, *std::max_element(face.counts.begin(), face.counts.end()));
    return most;
}

} // namespace edgeshade::test
