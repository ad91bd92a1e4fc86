#include "preprocess/mesh/patch_growth.hpp"

#include "preprocess/mesh/components.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace edgeshade {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;

/// The triangles across a triangle's edges that may be crossed, up to three.
using Neighbours = std::array<std::uint32_t, 3>;

std::vector<Neighbours> neighboursIn(const WeldedMesh& mesh, const EdgeList& edges) {
    std::vector<Neighbours> neighbours(mesh.triangles.size(), {none, none, none});
    const auto add = [&](std::uint32_t triangle, std::uint32_t neighbour) {
        *std::find(neighbours[triangle].begin(), neighbours[triangle].end(), none) = neighbour;
    };
    for (const Edge& edge : edges.edges) {
        if (edge.oppositeCount != 2) continue;
        const auto opposites = edges.oppositesOf(edge);
        const std::uint32_t p = opposites[0].triangle, q = opposites[1].triangle;
        if (directionIn(mesh.triangles[p], edge) == directionIn(mesh.triangles[q], edge)) continue;
        add(p, q);
        add(q, p);
    }
    return neighbours;
}

/// Triangles grouped by patch, ascending in each.
class Patches {
  public:
    Patches(std::span<const glm::dvec3> normals, std::span<const std::uint32_t> models)
        : first_(models.size() + 1, 0), triangles_(models.size()), areas_(models.size(), 0.0) {
        for (std::uint32_t t = 0; t < models.size(); ++t) {
            ++first_[models[t] + 1];
            areas_[models[t]] += glm::length(normals[t]);
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t t = 0; t < models.size(); ++t)
            triangles_[next[models[t]]++] = t;
    }

    std::span<const std::uint32_t> of(std::uint32_t model) const {
        return std::span(triangles_).subspan(first_[model], first_[model + 1] - first_[model]);
    }

    /// All models, in order of falling patch area.
    std::vector<std::uint32_t> bySize() const {
        std::vector<std::uint32_t> models;
        for (std::uint32_t t = 0; t < areas_.size(); ++t)
            if (first_[t + 1] > first_[t]) models.push_back(t);
        std::stable_sort(models.begin(), models.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return areas_[a] > areas_[b]; });
        return models;
    }

  private:
    std::vector<std::uint32_t> first_; ///< by model
    std::vector<std::uint32_t> triangles_;
    std::vector<double> areas_; ///< twice the area, by model
};

} // namespace

void growPatches(const WeldedMesh& mesh, const EdgeList& edges, std::span<const glm::dvec3> normals,
                 double degrees, std::vector<std::uint32_t>& models) {
    const double leastCosine = std::cos(glm::radians(degrees));
    const auto areAlike = [&](std::uint32_t p, std::uint32_t q) {
        const double lengths = glm::length(normals[p]) * glm::length(normals[q]);
        return lengths > 0.0 && glm::dot(normals[p], normals[q]) >= leastCosine * lengths;
    };
    const std::vector<Neighbours> neighbours = neighboursIn(mesh, edges);
    const Patches patches(normals, models);
    const std::vector<std::uint32_t> exact = models;
    std::vector<char> taken(models.size(), 0); // by model
    std::vector<std::uint32_t> joined;         // models of the growing patch
    for (const std::uint32_t seed : patches.bySize()) {
        if (taken[seed]) continue;
        taken[seed] = 1;
        joined = {seed};
        for (std::size_t i = 0; i < joined.size(); ++i)
            for (const std::uint32_t triangle : patches.of(joined[i])) {
                models[triangle] = seed;
                for (const std::uint32_t neighbour : neighbours[triangle]) {
                    if (neighbour == none) break;
                    const std::uint32_t model = exact[neighbour];
                    if (taken[model] || !areAlike(seed, model) || !areAlike(joined[i], model))
                        continue;
                    taken[model] = 1;
                    joined.push_back(model);
                }
            }
    }
}

} // namespace edgeshade
