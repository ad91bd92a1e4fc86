#pragma once

#include "src/gl/program.hpp"
#include "src/render/shadow_map/shadow_map_target.hpp"
#include "src/render/shadow_map/shadow_map_view.hpp"
#include "src/render/technique/shadow_technique.hpp"
#include "src/scene/gpu_scene.hpp"

#include <map>
#include <string>

namespace edgeshade {

/// Draws shadow maps (Williams 1978), the method that shadow volumes are measured against: six
/// faces of a cube around a point light, one parallel projection or several for a directional
/// light. One map for lamps and one for suns are kept, and drawn again only for another light,
/// where something has moved, or when cascades move by a texel.
///
/// Further kinds and filters of maps derive from it (Rivals::maps()).
class ShadowMapPass {
  public:
    /// `texelWidth`: texels of a texture, side by side, that a map's texel takes. Throws
    /// Error(unavailable) if the maps are larger than the GL allows.
    ShadowMapPass(const ShadowMapSettings& settings, const gl::Capabilities& capabilities,
                  int texelWidth = 1);
    virtual ~ShadowMapPass() = default;

    /// Looks at what the frame shows.
    virtual void beginFrame(const FrameStart&) {}

    /// Draws the light's map of all casters in its range, from both sides, for what `frame` shows.
    /// The framebuffer stays bound and the scissor as it is; viewport, depth, stencil and blending
    /// state are left changed. The map is valid until the next call.
    ShadowMapLookup draw(const GpuScene& scene, const FrameView& frame, const Light& light);

    /// Sets the bias of lookups from now on.
    void setBias(float texels) { settings_.biasTexels = texels; }

    /// The map that the light gets, for people: "up to 4 cascades of 2048 x 2048 texels, compared,
    /// 3 wide".
    std::string words(const Light& light) const;

    /// Bytes of all maps that were needed so far.
    virtual std::size_t bytes() const;
    /// Bytes of the map that lights of this light's kind share; 0 before one was drawn.
    virtual std::size_t bytesOf(const Light& light) const;

    /// Vertices that the last call of draw() sent through shaders: 0 where the map was kept.
    std::size_t vertexRuns() const { return vertexRuns_; }

  protected:
    /// One map, as it is drawn.
    struct MapTask {
        const GpuScene& scene;
        const Light& light;
        const ShadowMapView& view;
        const ShadowMapTarget& map;
    };

    virtual MapForm formOf(const Light& light) const;
    virtual ShadowMapView viewOf(const Light& light, const MapSubject& subject,
                                 const FrameView& frame, int depthBits);
    /// #defines of shadow_map.vert and .frag.
    virtual std::vector<std::string> casterDefines(const MapForm& form) const;
    /// #defines of shadow_map_lookup.glsl.
    virtual std::vector<std::string> receiverDefines(const MapForm& form) const;
    /// Draws all casters into a face that is bound and clear.
    virtual void drawFace(const MapTask& task, std::size_t face);
    /// Tells the program where the face shows casters.
    virtual void setProjection(const gl::Program& program, const MapTask& task, std::size_t face,
                               const glm::dmat4& mapFromObject) const;
    /// Comes after all faces are drawn.
    virtual void finish(const MapTask&) {}
    virtual const MapUniforms* further(const Light&) { return nullptr; }
    virtual std::string faceWords(const Light& light) const;
    virtual std::string filterWords() const { return "compared"; }

    /// In use.
    gl::Program& program(const MapForm& form, bool alphaTest);

    ShadowMapSettings settings_;
    gl::Capabilities capabilities_;
    std::size_t vertexRuns_ = 0;

  private:
    /// What a map shows.
    struct Drawn {
        std::shared_ptr<const int> scene; ///< GpuScene::identity; held, so that it stays unique
        ShadowMapView view;
        std::vector<std::pair<glm::dmat4, bool>> batches; ///< worldFromBatch, hidden
        bool cutoutsCast;
        double range; ///< of the light, out of which nothing is drawn

        bool operator==(const Drawn&) const = default;
    };
    /// A map that is kept: for lamps, or for suns.
    struct Kept {
        ShadowMapTarget target;
        std::vector<std::string> defines; ///< receiverDefines()
        std::optional<Drawn> drawn{};     ///< what the target holds
    };
    static MapSubject subjectOf(const GpuScene& scene, const Box& bounds);
    static Drawn drawnOf(const GpuScene& scene, const ShadowMapView& view, const Light& light);
    Kept& kept(const Light& light);
    void drawFaces(const MapTask& task);

    int texelWidth_;
    std::map<bool, Kept> kept_;                             ///< by MapForm::parallel
    std::map<std::pair<bool, bool>, gl::Program> programs_; ///< by MapForm::parallel, alphaTest
};

} // namespace edgeshade
