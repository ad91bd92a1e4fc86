#include "src/rivals/planar/largest_planes.hpp"

#include "preprocess/base/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace edgeshade {
namespace {

/// Greatest distance of vertices from a plane, as a share of the diagonal of all surfaces; many
/// times the rounding of floats.
constexpr double planeTolerance = 1e-5;
/// Cosine of the greatest angle between normals: small triangles may lie near a plane that they
/// stand on.
constexpr double normalTolerance = 0.9997;
/// Steps per normal component, and tolerances per step of distance, by which triangles are sorted
/// before planes are distinguished. Costs alone: planes that a step divides are joined again.
constexpr double normalSteps = 256.0, distanceSteps = 16.0;
/// Number of planes to try, as a factor of those requested, and in addition: costs alone.
constexpr std::size_t triesPerPlane = 4, moreTries = 16;

struct Candidate {
    PlaneTriangle source;
    std::array<glm::dvec3, 3> corners; ///< relative to the middle of all surfaces
    glm::dvec3 normal;                 ///< of unit length, in the upper half of directions
    double area = 0.0;
    bool taken = false;
};

bool isReceiver(const Batch& batch, const Material& material) {
    return !batch.isAnimated() && material.alphaMode != AlphaMode::blend;
}

/// The same one of two opposite directions.
glm::dvec3 upper(const glm::dvec3& normal) {
    for (const glm::length_t axis : {1, 0, 2})
        if (normal[axis] != 0.0) return normal[axis] < 0.0 ? -normal : normal;
    return normal;
}

template <class Use>
void forEachReceiver(const Scene& scene, Use use) {
    for (std::size_t b = 0; b < scene.batches.size(); ++b) {
        const Batch& batch = scene.batches[b];
        const Geometry& geometry = *batch.geometry;
        for (const SurfaceGroup& group : geometry.groups) {
            if (!isReceiver(batch, scene.materials[group.material])) continue;
            for (std::uint32_t i = 0; i + 2 < group.indexCount; i += 3) {
                std::array<glm::dvec3, 3> corners;
                for (std::uint32_t c = 0; c < 3; ++c) {
                    const auto vertex = geometry.indices[group.firstIndex + i + c];
                    corners[c] = glm::dvec3(batch.worldFromBatch *
                                            glm::dvec4(geometry.positions[vertex], 1.0));
                }
                use(PlaneTriangle{b, group.firstIndex + i}, corners);
            }
        }
    }
}

/// Sorts triangles into planes.
class PlaneSearch {
  public:
    explicit PlaneSearch(const Scene& scene) {
        Box bounds;
        forEachReceiver(scene, [&](const PlaneTriangle&, const auto& corners) {
            for (const glm::dvec3& corner : corners)
                bounds.add(corner);
        });
        if (bounds.empty()) return;
        middle_ = bounds.center();
        tolerance_ = planeTolerance * bounds.diagonal();
        forEachReceiver(scene, [&](const PlaneTriangle& source, const auto& corners) {
            Candidate& of = triangles_.emplace_back(Candidate{source, corners, {}});
            for (glm::dvec3& corner : of.corners)
                corner -= middle_;
            const glm::dvec3 across =
                glm::cross(of.corners[1] - of.corners[0], of.corners[2] - of.corners[0]);
            const double twice = glm::length(across);
            of.area = 0.5 * twice;
            area_ += of.area;
            if (twice > 0.0)
                of.normal = upper(across / twice);
            else
                of.taken = true; // without area: it lies in any plane, and is invisible
        });
    }

    std::vector<SurfacePlane> largest(std::size_t count) {
        std::vector<SurfacePlane> planes;
        const std::vector<std::size_t> seeds = seedsOf(triesPerPlane * count + moreTries);
        for (const std::size_t seed : seeds)
            if (!triangles_[seed].taken) planes.push_back(planeAt(triangles_[seed]));
        std::ranges::stable_sort(planes, std::greater<>(), &SurfacePlane::area);
        if (planes.size() > count) planes.resize(count);
        for (SurfacePlane& of : planes) {
            of.plane.w -= glm::dot(glm::dvec3(of.plane), middle_);
            of.share = of.area / area_;
        }
        return planes;
    }

  private:
    using Cell = std::array<std::int64_t, 4>;

    Cell cellOf(const Candidate& of) const {
        Cell cell{};
        for (glm::length_t axis = 0; axis < 3; ++axis)
            cell[static_cast<std::size_t>(axis)] = std::llround(of.normal[axis] * normalSteps);
        cell[3] = std::llround(glm::dot(of.normal, of.corners[0]) / (distanceSteps * tolerance_));
        return cell;
    }

    /// The largest triangle of each of the cells with the most area, in descending order of area.
    std::vector<std::size_t> seedsOf(std::size_t count) const {
        struct Sum {
            double area = 0.0;
            std::size_t largest = 0;
        };
        std::map<Cell, Sum> sums;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (triangles_[i].taken) continue;
            Sum& sum = sums.try_emplace(cellOf(triangles_[i]), Sum{0.0, i}).first->second;
            sum.area += triangles_[i].area;
            if (triangles_[i].area > triangles_[sum.largest].area) sum.largest = i;
        }
        std::vector<Sum> sorted;
        for (const auto& [cell, sum] : sums)
            sorted.push_back(sum);
        std::ranges::stable_sort(sorted, std::greater<>(), &Sum::area);
        std::vector<std::size_t> seeds;
        for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i)
            seeds.push_back(sorted[i].largest);
        return seeds;
    }

    bool isIn(const Candidate& of, const glm::dvec3& normal, double height) const {
        if (of.taken || std::abs(glm::dot(of.normal, normal)) < normalTolerance) return false;
        return std::ranges::all_of(of.corners, [&](const glm::dvec3& corner) {
            return std::abs(glm::dot(normal, corner) - height) <= tolerance_;
        });
    }

    /// The area-weighted mean plane of the triangles near the seed's plane.
    std::optional<glm::dvec4> meanAround(const glm::dvec3& normal, double height) const {
        glm::dvec3 normals(0.0), places(0.0);
        double area = 0.0;
        for (const Candidate& of : triangles_) {
            if (!isIn(of, normal, height)) continue;
            normals += of.area * (glm::dot(of.normal, normal) < 0.0 ? -of.normal : of.normal);
            places += of.area / 3.0 * (of.corners[0] + of.corners[1] + of.corners[2]);
            area += of.area;
        }
        if (area == 0.0) return std::nullopt;
        const glm::dvec3 mean = glm::normalize(normals);
        return glm::dvec4(mean, glm::dot(mean, places / area));
    }

    double areaIn(const glm::dvec3& normal, double height) const {
        double area = 0.0;
        for (const Candidate& of : triangles_)
            if (isIn(of, normal, height)) area += of.area;
        return area;
    }

    /// Takes all triangles in the seed's plane, or in their mean plane if it holds more area.
    SurfacePlane planeAt(const Candidate& seed) {
        glm::dvec3 normal = seed.normal;
        double height = glm::dot(normal, seed.corners[0]);
        if (const auto mean = meanAround(normal, height))
            if (areaIn(glm::dvec3(*mean), mean->w) >= areaIn(normal, height)) {
                normal = glm::dvec3(*mean);
                height = mean->w;
            }
        SurfacePlane plane{glm::dvec4(normal, -height), tolerance_, 0.0, 0.0, {}};
        for (Candidate& of : triangles_) {
            if (!isIn(of, normal, height)) continue;
            of.taken = true;
            plane.area += of.area;
            plane.triangles.push_back(of.source);
        }
        return plane;
    }

    glm::dvec3 middle_{0.0};
    double tolerance_ = 0.0;
    double area_ = 0.0;
    std::vector<Candidate> triangles_;
};

} // namespace

std::vector<SurfacePlane> largestPlanes(const Scene& scene, std::size_t count) {
    return PlaneSearch(scene).largest(count);
}

} // namespace edgeshade
