#include "src/bench/synthetic_layouts.hpp"

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
    return layouts;
}

} // namespace edgeshade::bench
