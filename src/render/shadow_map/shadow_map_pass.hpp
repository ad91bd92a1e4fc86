#pragma once

#include "src/gl/program_variants.hpp"
#include "src/render/shadow_map/shadow_map_target.hpp"
#include "src/render/shadow_map/shadow_map_view.hpp"
#include "src/render/technique/shadow_technique.hpp"
#include "src/scene/gpu_scene.hpp"

#include <map>
#include <string>

namespace edgeshade {

/// Draws shadow maps (Williams 1978), the baseline for shadow volumes: six faces of a cube around a
/// point light, one parallel projection or several for a directional light. It keeps one map for
/// lamps and one for suns, and draws a map again only for another light, or when something has
/// moved, or when cascades move by a texel.
///
/// Other kinds and filters of maps derive from this class (Rivals::maps()).
class ShadowMapPass {
  public:
    /// `texelWidth`: number of adjacent texture texels that one map texel takes. Throws
    /// Error(unavailable) if the maps are larger than the GL allows.
    ShadowMapPass(const ShadowMapSettings& settings, const gl::Capabilities& capabilities,
                  int texelWidth = 1);
    virtual ~ShadowMapPass() = default;

    /// Looks at what the frame shows.
    virtual void beginFrame(const FrameStart&) {}

    /// Draws the light's map of all casters in its range, from both sides, for what `frame` shows.
    /// Keeps the framebuffer binding and the scissor; changes the viewport and the depth, stencil
    /// and blending state. The map is valid until the next call.
    ShadowMapLookup draw(const GpuScene& scene, const FrameView& frame, const Light& light);

    /// Sets the bias for further lookups.
    void setBias(float texels) { settings_.biasTexels = texels; }

    /// Describes the light's map: "up to 4 cascades of 2048 x 2048 texels, compared, 3 wide".
    std::string words(const Light& light) const;

    /// Bytes of all maps that were needed so far.
    virtual std::size_t bytes() const;
    /// Bytes of the shadow map that lights of this kind share; 0 before it is first drawn.
    virtual std::size_t bytesOf(const Light& light) const;

    /// Vertices shaded by the last call of draw(): 0 if it kept the map.
    std::size_t vertexRuns() const { return vertexRuns_; }

  protected:
    /// One map to draw.
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
    /// Draws all casters into a face that is bound and cleared.
    virtual void drawFace(const MapTask& task, std::size_t face);
    /// Sets the program's projection for the face.
    virtual void setProjection(const gl::Program& program, const MapTask& task, std::size_t face,
                               const glm::dmat4& mapFromObject) const;
    /// Runs after all faces are drawn.
    virtual void finish(const MapTask&) {}
    virtual const MapUniforms* further() const { return nullptr; }
    virtual std::string faceWords(const Light& light) const;
    virtual std::string filterWords() const { return "compared"; }

    /// Returns the program, in use.
    const gl::Program& program(const MapForm& form, bool alphaTest);

    ShadowMapSettings settings_;
    gl::Capabilities capabilities_;
    std::size_t vertexRuns_ = 0;

  private:
    /// Everything that a map's contents depend on.
    struct Drawn {
        std::shared_ptr<const int> scene; ///< GpuScene::identity; held, so that it stays unique
        ShadowMapView view;
        std::vector<std::pair<glm::dmat4, bool>> batches; ///< worldFromBatch, hidden
        bool cutoutsCast;
        double range; ///< the light's range, beyond which nothing is drawn

        bool operator==(const Drawn&) const = default;
    };
    /// A kept map: the one for lamps, or the one for suns.
    struct Kept {
        ShadowMapTarget target;
        std::vector<std::string> defines; ///< receiverDefines()
        std::optional<Drawn> drawn{};     ///< the target's contents
    };
    static MapSubject subjectOf(const GpuScene& scene, const Box& bounds);
    static Drawn drawnOf(const GpuScene& scene, const ShadowMapView& view, const Light& light);
    Kept& kept(const Light& light);
    void drawFaces(const MapTask& task);

    int texelWidth_;
    std::map<bool, Kept> kept_;                           ///< by MapForm::parallel
    gl::ProgramVariants<std::pair<bool, bool>> programs_; ///< by MapForm::parallel, alphaTest
};

} // namespace edgeshade
