#pragma once

#include "src/gl/program.hpp"
#include "src/render/shadow_map/shadow_map_target.hpp"
#include "src/render/shadow_map/shadow_map_view.hpp"
#include "src/scene/gpu_scene.hpp"

#include <map>

namespace edgeshade {

/// Draws shadow maps (Williams 1978), the method that shadow volumes are measured against: six
/// faces of a cube around a point light, one parallel projection for a directional light. One map
/// of each kind is kept, and drawn anew only for another light or where something has moved.
class ShadowMapPass {
  public:
    /// Throws Error(unavailable) if the maps are larger than the GL allows.
    ShadowMapPass(const ShadowMapSettings& settings, const gl::Capabilities& capabilities);

    /// Draws the light's map of all casters, from both sides. `bounds`: the scene's in the world.
    /// The framebuffer stays bound and the scissor as it is; viewport, depth, stencil and blending
    /// state are left changed. The map is valid until the next call.
    ShadowMapLookup draw(const GpuScene& scene, const Box& bounds, const Light& light);

    /// Of lookups from now on.
    void setBias(float texels) { settings_.biasTexels = texels; }

    /// Of the maps that were needed so far.
    std::size_t bytes() const;

    /// Vertices that the last call of draw() sent through shaders: 0 where the map was kept.
    std::size_t vertexRuns() const { return vertexRuns_; }

  private:
    struct Variant {
        ShadowMapKind kind;
        bool alphaTest;

        auto operator<=>(const Variant&) const = default;
    };
    /// What a map shows.
    struct Subject {
        std::shared_ptr<const int> scene; ///< GpuScene::identity; held, so that it stays unique
        glm::dvec4 light{0.0};
        double range = 0.0;                               ///< the light's
        glm::dvec3 low{0.0}, high{0.0};                   ///< bounds
        std::vector<std::pair<glm::dmat4, bool>> batches; ///< worldFromBatch, hidden
        bool cutoutsCast;

        bool operator==(const Subject&) const = default;
    };
    static Subject subjectOf(const GpuScene& scene, const Box& bounds, const Light& light);
    const ShadowMapTarget& target(ShadowMapKind kind);
    void drawFaces(const GpuScene& scene, const ShadowMapView& view, const ShadowMapTarget& map);
    gl::Program& program(const Variant& variant);
    void drawCasters(const GpuScene& scene, const ShadowMapView& view,
                     const glm::dmat4& clipFromMap);
    void drawChunk(const GpuScene& scene, const SurfaceChunk& chunk, gl::Program& program);

    ShadowMapSettings settings_;
    gl::Capabilities capabilities_;
    std::map<ShadowMapKind, ShadowMapTarget> targets_;
    std::map<ShadowMapKind, Subject> drawn_; ///< what each target holds
    std::map<Variant, gl::Program> programs_;
    std::size_t vertexRuns_ = 0;
};

} // namespace edgeshade
