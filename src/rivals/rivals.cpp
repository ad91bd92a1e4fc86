#include "src/rivals/rivals.hpp"

#include "src/render/technique/rivals.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/rivals/brute_force/triangle_volumes.hpp"
#include "src/rivals/maps/rival_map_pass.hpp"
#include "src/rivals/planar/planar_technique.hpp"
#include "src/rivals/published/opposite_vertex_volumes.hpp"
#include "src/rivals/published/record_sources.hpp"

namespace edgeshade {
namespace {

class AllRivals : public Rivals {
  public:
    const RecordSource* records(VolumeLayout layout) const override {
        if (layout == VolumeLayout::oppositeVertices) return oppositeVertices_.get();
        return layout == VolumeLayout::triangles ? triangles_.get() : nullptr;
    }

    std::unique_ptr<VolumeRenderer>
    volumes(const RenderSettings& settings, const gl::Capabilities& capabilities,
            const std::optional<VolumeTints>& tints) const override {
        switch (volumeLayoutOf(settings.multiplicity)) {
        case VolumeLayout::oppositeVertices:
            return std::make_unique<OppositeVertexVolumes>(settings.multiplicity, settings.layout,
                                                           capabilities.instancing, tints);
        case VolumeLayout::triangles:
            return std::make_unique<TriangleVolumes>(settings.count, settings.layout,
                                                     capabilities.instancing, tints);
        default:
            return nullptr;
        }
    }

    std::unique_ptr<ShadowMapPass> maps(const RenderSettings& settings,
                                        const gl::Capabilities& capabilities) const override {
        return std::make_unique<RivalMapPass>(settings.map, capabilities);
    }

    std::unique_ptr<ShadowTechnique> planar(const RenderSettings& settings) const override {
        return std::make_unique<PlanarTechnique>(settings.planes);
    }

  private:
    std::unique_ptr<RecordSource> oppositeVertices_ = oppositeVertexSource();
    std::unique_ptr<RecordSource> triangles_ = triangleSource();
};

} // namespace

const Rivals& allRivals() {
    static const AllRivals rivals;
    return rivals;
}

} // namespace edgeshade
