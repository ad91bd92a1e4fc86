#include "src/rivals/synthetic/synthetic_layouts.hpp"

#include "src/render/volumes/plane_pair_volumes.hpp"
#include "src/rivals/published/record_passes.hpp"

#include <algorithm>

namespace edgeshade::bench {
namespace {

/// The opposite-vertex records (thesis, 6.2.6).
class OppositeVertexSubject : public SyntheticSubject {
  public:
    OppositeVertexSubject(const SyntheticMesh& mesh, int oppositeCount, MultiplicityMethod method,
                          SidesLayout layout, const gl::Capabilities& capabilities)
        : passes_(method, layout, capabilities.instancing, {"DEGENERATE"}) {
        const int maxMultiplicity =
            recordMultiplicityFor(static_cast<std::uint32_t>(oppositeCount));
        BatchShadow shadow;
        shadow.sides = buildSides(mesh.positions, mesh.edges, maxMultiplicity);
        recordsPerEdge_ = shadow.sides.recordCount() / mesh.edges.edges.size();
        buffers_ = uploadShadow(shadow, {}, layout);
        passes_.prepareSides(buffers_.maxMultiplicity);
        for (const RecordChunk& chunk : buffers_.sides)
            wholeChunks_.push_back(chunk.recordCount);
    }

    void draw(std::size_t edgeCount) override {
        std::size_t left = edgeCount * recordsPerEdge_;
        for (std::size_t i = 0; i < wholeChunks_.size(); ++i) {
            buffers_.sides[i].recordCount = std::min(left, wholeChunks_[i]);
            left -= buffers_.sides[i].recordCount;
        }
        const gl::Program& program = passes_.useSides(buffers_.maxMultiplicity);
        program.set("u_light", syntheticLight);
        program.set("u_clipFromObject", glm::mat4(1.0f));
        passes_.drawSides(buffers_);
    }

  private:
    RecordPasses passes_;
    ShadowBuffers buffers_;
    std::vector<std::size_t> wholeChunks_; ///< records
    std::size_t recordsPerEdge_ = 1;
};

/// The plane of a triangle; exact if the light is exactly in it.
glm::vec4 planeOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    return glm::vec4(glm::dvec4(normal, -glm::dot(normal, a)));
}

RenderSettings settingsFor(SidesLayout layout) {
    RenderSettings settings;
    settings.silhouette = SilhouetteChoice::all;
    settings.layout = layout;
    return settings;
}

/// Records of one or two planes (preprocess/volumes/plane_pair_data.hpp), without flat edges.
class PlanePairSubject : public SyntheticSubject {
  public:
    PlanePairSubject(const SyntheticMesh& mesh, SidesLayout layout,
                     const gl::Capabilities& capabilities)
        : volumes_(settingsFor(layout), capabilities, {}, {"DEGENERATE"}) {
        PlanePairShadow shadow;
        for (const Edge& edge : mesh.edges.edges)
            addRecords(mesh, edge, shadow);
        const std::size_t edges = mesh.edges.edges.size();
        pairsPerEdge_ = shadow.pairs.size() / edges;
        singlesPerEdge_ = shadow.singles.size() / edges;
        buffers_.planePairs = std::make_shared<PlanePairBuffers>(
            std::make_shared<PlanePairShadow>(std::move(shadow)), std::vector<glm::vec4>(), layout);
        buffers_.planePairs->uploadAllPairs();
        for (const VolumeDraw& draw : draws(1))
            volumes_.makeProgram(draw);
    }

    void draw(std::size_t edgeCount) override {
        const BatchPlan plan{.light = syntheticLight};
        const DrawnBatch batch{nullptr, buffers_, plan, glm::mat4(1.0f)};
        for (const VolumeDraw& draw : draws(edgeCount))
            volumes_.draw(draw, batch);
    }

  private:
    /// Draws all pairs as silhouettes of multiplicity two, and the single records.
    std::vector<VolumeDraw> draws(std::size_t edgeCount) const {
        std::vector<VolumeDraw> draws;
        const auto add = [&](VolumeDraw::Records records, std::size_t count, Times times) {
            if (count == 0) return;
            VolumeDraw& draw = draws.emplace_back();
            draw.records = records;
            draw.range.count = static_cast<std::uint32_t>(count);
            draw.verticesPerRecord = verticesPerQuad;
            draw.times = times;
        };
        add(VolumeDraw::Records::allPairs, edgeCount * pairsPerEdge_, Times::twice);
        add(VolumeDraw::Records::singles, edgeCount * singlesPerEdge_, Times::once);
        return draws;
    }

    /// Triangles in the light's plane are moved last, so that the planes of a pair cancel where
    /// they should.
    static void addRecords(const SyntheticMesh& mesh, const Edge& edge, PlanePairShadow& shadow) {
        const glm::vec3 &a = mesh.positions[edge.a], &b = mesh.positions[edge.b];
        std::vector<glm::vec4> planes;
        for (const Opposite& opposite : mesh.edges.oppositesOf(edge))
            planes.push_back(planeOf(a, b, mesh.positions[opposite.vertex]));
        std::stable_partition(planes.begin(), planes.end(),
                              [](const glm::vec4& plane) { return plane.w != 0.0f; });
        for (std::size_t i = 0; i + 1 < planes.size(); i += 2)
            shadow.pairs.push_back({a, b, planes[i], -planes[i + 1]});
        if (planes.size() % 2 == 1) shadow.singles.push_back({a, b, planes.back()});
    }

    PlanePairVolumes volumes_;
    BatchVolumes buffers_;
    std::size_t pairsPerEdge_ = 0;
    std::size_t singlesPerEdge_ = 0;
};

} // namespace

std::vector<SyntheticLayout> syntheticLayouts(MultiplicityMethod method,
                                              const gl::Capabilities& capabilities) {
    std::vector<SyntheticLayout> layouts;
    const auto addPlanePairs = [&](const std::string& name, SidesLayout layout) {
        layouts.push_back({name, [=](const SyntheticMesh& mesh, int) {
                               return std::make_unique<PlanePairSubject>(mesh, layout,
                                                                         capabilities);
                           }});
    };
    const auto addOppositeVertices = [&](const std::string& name, SidesLayout layout) {
        layouts.push_back({name, [=](const SyntheticMesh& mesh, int oppositeCount) {
                               return std::make_unique<OppositeVertexSubject>(
                                   mesh, oppositeCount, method, layout, capabilities);
                           }});
    };
    if (capabilities.instancing) {
        addPlanePairs("adapted", SidesLayout::instanced);
        addOppositeVertices("instanced", SidesLayout::instanced);
        addOppositeVertices("multi-draw", SidesLayout::multiDraw);
    }
    addPlanePairs("adapted not-instanced", SidesLayout::notInstanced);
    addOppositeVertices("not-instanced", SidesLayout::notInstanced);
    return layouts;
}

} // namespace edgeshade::bench
