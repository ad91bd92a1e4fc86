#include "src/bench/synthetic_layouts.hpp"

#include "src/render/adapted_volumes.hpp"
#include "src/render/sides_pass.hpp"

#include <algorithm>

namespace edgeshade::bench {
namespace {

/// The published records (thesis, 6.2.6).
class PublishedSubject : public SyntheticSubject {
  public:
    PublishedSubject(const SyntheticMesh& mesh, int oppositeCount, MultiplicityMethod method,
                     SidesLayout layout, const gl::Capabilities& capabilities)
        : pass_(method, layout, capabilities.instancing, {"DEGENERATE"}) {
        const int maxMultiplicity =
            recordMultiplicityFor(static_cast<std::uint32_t>(oppositeCount));
        BatchShadow shadow;
        shadow.sides = buildSides(mesh.positions, mesh.edges, maxMultiplicity);
        recordsPerEdge_ = shadow.sides.recordCount() / mesh.edges.edges.size();
        buffers_ = uploadShadow(shadow, {}, layout);
        for (const RecordChunk& chunk : buffers_.sides)
            wholeChunks_.push_back(chunk.recordCount);
    }

    void draw(std::size_t edgeCount) override {
        std::size_t left = edgeCount * recordsPerEdge_;
        for (std::size_t i = 0; i < wholeChunks_.size(); ++i) {
            buffers_.sides[i].recordCount = std::min(left, wholeChunks_[i]);
            left -= buffers_.sides[i].recordCount;
        }
        pass_.draw(buffers_, syntheticLight, glm::mat4(1.0f));
    }

  private:
    SidesPass pass_;
    ShadowBuffers buffers_;
    std::vector<std::size_t> wholeChunks_; ///< records
    std::size_t recordsPerEdge_ = 1;
};

/// The plane through an edge and an opposite vertex, as that triangle is wound.
glm::vec4 planeThrough(const SyntheticMesh& mesh, const Edge& edge, const Opposite& opposite) {
    const glm::dvec3 a(mesh.positions[edge.a]), b(mesh.positions[edge.b]);
    const glm::dvec3 normal = glm::cross(b - a, glm::dvec3(mesh.positions[opposite.vertex]) - a);
    return glm::vec4(glm::dvec4(normal, -glm::dot(normal, a)));
}

/// The records that an edge takes when those of its triangles that cancel are paired up: all run
/// the same way, so the second plane of a pair is negated.
void appendRecords(const SyntheticMesh& mesh, const Edge& edge, AdaptedShadow& shadow) {
    std::vector<glm::vec4> planes;
    for (const Opposite& opposite : mesh.edges.oppositesOf(edge))
        planes.push_back(planeThrough(mesh, edge, opposite));
    const auto side = [](const glm::vec4& plane) { return glm::dot(plane, syntheticLight); };
    // Both sides in turn, then what lies in the plane of edge and light.
    std::stable_sort(planes.begin(), planes.end(), [&](const glm::vec4& p, const glm::vec4& q) {
        return (side(p) == 0.0f) < (side(q) == 0.0f);
    });
    const glm::vec3 &a = mesh.positions[edge.a], &b = mesh.positions[edge.b];
    for (std::size_t i = 0; i + 1 < planes.size(); i += 2)
        shadow.pairs.push_back({a, b, planes[i], -planes[i + 1]});
    if (planes.size() % 2 == 1) shadow.singles.push_back({a, b, planes.back()});
}

/// Adapted records: at most two planes each.
class AdaptedSubject : public SyntheticSubject {
  public:
    AdaptedSubject(const SyntheticMesh& mesh, int oppositeCount, SidesLayout layout,
                   const gl::Capabilities& capabilities)
        : volumes_(layout, capabilities.instancing, {"DEGENERATE"}),
          pairsPerEdge_(static_cast<std::uint32_t>(oppositeCount / 2)),
          singlesPerEdge_(static_cast<std::uint32_t>(oppositeCount % 2)) {
        auto shadow = std::make_shared<AdaptedShadow>();
        for (const Edge& edge : mesh.edges.edges)
            appendRecords(mesh, edge, *shadow);
        shadow->clusters.resize(1);
        shadow_ = shadow;
        buffers_.emplace(shadow, std::vector<glm::vec4>(), layout);
    }

    void draw(std::size_t edgeCount) override {
        const auto edges = static_cast<std::uint32_t>(edgeCount);
        shadow_->clusters[0].pairs = {0, edges * pairsPerEdge_};
        shadow_->clusters[0].singles = {0, edges * singlesPerEdge_};
        volumes_.drawSides(*buffers_, {{0, 1}, Counted::all, false, false, false}, syntheticLight,
                           glm::mat4(1.0f));
    }

  private:
    AdaptedVolumes volumes_;
    std::uint32_t pairsPerEdge_, singlesPerEdge_;
    std::shared_ptr<AdaptedShadow> shadow_;
    std::optional<AdaptedBuffers> buffers_;
};

} // namespace

std::vector<SyntheticLayout> syntheticLayouts(MultiplicityMethod method,
                                              const gl::Capabilities& capabilities) {
    std::vector<SyntheticLayout> layouts;
    const auto addPublished = [&](const std::string& name, SidesLayout layout) {
        layouts.push_back({name, [=](const SyntheticMesh& mesh, int oppositeCount) {
                               return std::make_unique<PublishedSubject>(
                                   mesh, oppositeCount, method, layout, capabilities);
                           }});
    };
    if (capabilities.instancing) {
        addPublished("instanced", SidesLayout::instanced);
        addPublished("multi-draw", SidesLayout::multiDraw);
    }
    addPublished("not-instanced", SidesLayout::notInstanced);
    const auto addAdapted = [&](const std::string& name, SidesLayout layout) {
        layouts.push_back({name, [=](const SyntheticMesh& mesh, int oppositeCount) {
                               return std::make_unique<AdaptedSubject>(mesh, oppositeCount, layout,
                                                                       capabilities);
                           }});
    };
    if (capabilities.instancing) addAdapted("adapted", SidesLayout::instanced);
    addAdapted("adapted, not instanced", SidesLayout::notInstanced);
    return layouts;
}

} // namespace edgeshade::bench
