#include "src/hours/surfaces/patches.hpp"

#include "preprocess/base/vectors.hpp"
#include "preprocess/mesh/edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace edgeshade::hours {
namespace {

/// Rounding of a file's floats and of those that a batch keeps, as a share of coordinates.
constexpr double floatRounding = 4.0 / (1 << 24);
/// Sine of the slope below which a patch counts as level.
constexpr double levelSlope = 1e-3;

/// Chosen triangles of one batch with their neighbours.
class BatchMesh {
  public:
    /// `first`: index of the first of `triangles` among all that are chosen.
    BatchMesh(const Batch& batch, std::span<const WorldTriangle> triangles, std::uint32_t first,
              double flatness)
        : triangles_(triangles), first_(first), flatness_(flatness), linear_(batch.worldFromBatch) {
        std::vector<std::uint32_t> indices;
        indices.reserve(3 * triangles.size());
        for (const WorldTriangle& triangle : triangles)
            for (std::uint32_t corner = 0; corner < 3; ++corner)
                indices.push_back(batch.geometry->indices[triangle.firstIndex + corner]);
        mesh_ = weld(batch.geometry->positions, indices);
        edges_ = buildEdges(mesh_);
        findEdgesOfTriangles();
        double farthest = 0.0;
        for (const glm::vec3& position : mesh_.positions)
            farthest = std::max(farthest, largestComponent(glm::dvec3(position)));
        const double scale =
            std::max({glm::length(linear_[0]), glm::length(linear_[1]), glm::length(linear_[2])});
        // A far-off batch's positions are rounded once more, to doubles.
        rounding_ = floatRounding * farthest * scale +
                    1e-15 * largestComponent(glm::dvec3(batch.worldFromBatch[3]));
    }

    void addPatches(std::vector<Patch>& to) const {
        std::vector<std::uint32_t> bySize(mesh_.triangles.size());
        std::vector<double> areas(bySize.size());
        for (std::uint32_t t = 0; t < bySize.size(); ++t) {
            bySize[t] = t;
            areas[t] = areaOf(surface(t));
        }
        std::stable_sort(bySize.begin(), bySize.end(),
                         [&](std::uint32_t p, std::uint32_t q) { return areas[p] > areas[q]; });
        std::vector<std::uint8_t> taken(bySize.size(), 0);
        for (const std::uint32_t seed : bySize)
            if (taken[seed] == 0 && areas[seed] > 0.0) to.push_back(patchFrom(seed, areas, taken));
    }

  private:
    const WorldTriangle& surface(std::uint32_t t) const { return triangles_[mesh_.source[t]]; }

    void findEdgesOfTriangles() {
        edgesOf_.assign(mesh_.triangles.size(), {});
        std::vector<std::uint8_t> found(mesh_.triangles.size(), 0);
        for (std::uint32_t e = 0; e < edges_.edges.size(); ++e)
            for (const Opposite& opposite : edges_.oppositesOf(edges_.edges[e]))
                edgesOf_[opposite.triangle][found[opposite.triangle]++] = e;
    }

    Patch patchFrom(std::uint32_t seed, const std::vector<double>& areas,
                    std::vector<std::uint8_t>& taken) const {
        const WorldTriangle& model = surface(seed);
        Patch patch;
        patch.origin = model.a;
        patch.normal = normalOf(model) / (2.0 * areas[seed]);
        const double longest =
            std::max({glm::length(model.b - model.a), glm::length(model.c - model.b),
                      glm::length(model.a - model.c)});
        const double height = 2.0 * areas[seed] / longest;
        const auto fits = [&](std::uint32_t t) {
            const WorldTriangle& other = surface(t);
            if (other.node != model.node || other.material != model.material || !(areas[t] > 0.0) ||
                glm::dot(normalOf(other), patch.normal) <= 0.0)
                return false;
            const std::array corners = {other.a, other.b, other.c};
            return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
                const glm::dvec3 way = corner - patch.origin;
                const double allowed = rounding_ * (1.0 + glm::length(way) / height);
                return std::abs(glm::dot(way, patch.normal)) <= std::min(allowed, flatness_);
            });
        };
        std::vector<std::uint32_t> members = {seed};
        taken[seed] = 1;
        for (std::size_t next = 0; next < members.size(); ++next)
            forNeighbours(members[next], [&](std::uint32_t t) {
                if (taken[t] != 0 || !fits(t)) return;
                taken[t] = 1;
                members.push_back(t);
            });
        setAxes(patch, members);
        for (const std::uint32_t t : members)
            patch.triangles.push_back(first_ + mesh_.source[t]);
        return patch;
    }

    /// Calls use(triangle) for those across each edge that run through it the other way.
    template <class Use>
    void forNeighbours(std::uint32_t t, const Use& use) const {
        for (const std::uint32_t e : edgesOf_[t]) {
            const std::span<const Opposite> opposites = edges_.oppositesOf(edges_.edges[e]);
            const std::span<const std::uint8_t> forward = edges_.forwardOf(edges_.edges[e]);
            std::uint8_t own = 0;
            for (std::size_t i = 0; i < opposites.size(); ++i)
                if (opposites[i].triangle == t) own = forward[i];
            for (std::size_t i = 0; i < opposites.size(); ++i)
                if (forward[i] != own) use(opposites[i].triangle);
        }
    }

    void setAxes(Patch& patch, const std::vector<std::uint32_t>& members) const {
        const glm::dvec3 above(0.0, 1.0, 0.0);
        const glm::dvec3 level = glm::cross(above, patch.normal);
        patch.right = glm::length(level) > levelSlope ? glm::normalize(level)
                                                      : alongLongestBorder(patch.normal, members);
        patch.up = glm::cross(patch.normal, patch.right);
    }

    glm::dvec3 alongLongestBorder(const glm::dvec3& normal,
                                  const std::vector<std::uint32_t>& members) const {
        std::map<std::uint32_t, int> uses; // by edge
        for (const std::uint32_t t : members)
            for (const std::uint32_t e : edgesOf_[t])
                ++uses[e];
        glm::dvec3 longest(0.0);
        for (const auto& [edge, count] : uses) {
            if (count > 1) continue;
            const glm::dvec3 side = linear_ * (glm::dvec3(mesh_.positions[edges_.edges[edge].b]) -
                                               glm::dvec3(mesh_.positions[edges_.edges[edge].a]));
            if (glm::length(side) > glm::length(longest)) longest = side;
        }
        glm::dvec3 along = longest - glm::dot(longest, normal) * normal;
        if (!(glm::length(along) > 0.0)) along = glm::cross(normal, glm::dvec3(0.0, 0.0, 1.0));
        along = glm::normalize(along);
        return along.x + 1e-9 * along.z < 0.0 ? -along : along;
    }

    std::span<const WorldTriangle> triangles_;
    std::uint32_t first_;
    double flatness_, rounding_ = 0.0;
    glm::dmat3 linear_;
    WeldedMesh mesh_; ///< of triangles_, in their order
    EdgeList edges_;
    std::vector<std::array<std::uint32_t, 3>> edgesOf_; ///< by triangle of mesh_
};

} // namespace

std::vector<Patch> patchesOf(const Scene& scene, std::span<const WorldTriangle> triangles,
                             double flatness) {
    std::vector<Patch> patches;
    for (std::size_t first = 0; first < triangles.size();) {
        std::size_t end = first;
        while (end < triangles.size() && triangles[end].batch == triangles[first].batch)
            ++end;
        BatchMesh(scene.batches[triangles[first].batch], triangles.subspan(first, end - first),
                  static_cast<std::uint32_t>(first), flatness)
            .addPatches(patches);
        first = end;
    }
    return patches;
}

} // namespace edgeshade::hours
