#pragma once

#include "src/render/shadow_map/shadow_map_pass.hpp"
#include "src/rivals/maps/map_blur.hpp"
#include "src/rivals/maps/map_warper.hpp"

#include <optional>

namespace edgeshade {

/// Draws shadow maps as two paraboloids around lamps (Brabec et al. 2002), or warped for a sun's
/// visible geometry (Rosen 2012; Milet et al. 2015). Samples maps by Poisson taps, or as filtered
/// variance, exponential and moment maps.
class RivalMapPass : public ShadowMapPass, private MapUniforms {
  public:
    RivalMapPass(const ShadowMapSettings& settings, const gl::Capabilities& capabilities);

    void beginFrame(const FrameStart& start) override;
    std::size_t bytes() const override;
    std::size_t bytesOf(const Light& light) const override;

  protected:
    MapForm formOf(const Light& light) const override;
    ShadowMapView viewOf(const Light& light, const MapSubject& subject, const FrameView& frame,
                         int depthBits) override;
    std::vector<std::string> casterDefines(const MapForm& form) const override;
    std::vector<std::string> receiverDefines(const MapForm& form) const override;
    void drawFace(const MapTask& task, std::size_t face) override;
    void setProjection(const gl::Program& program, const MapTask& task, std::size_t face,
                       const glm::dmat4& mapFromObject) const override;
    void finish(const MapTask& task) override;
    const MapUniforms* further() const override { return this; }
    std::string faceWords(const Light& light) const override;
    std::string filterWords() const override;

  private:
    bool isParaboloid(const MapForm& form) const;
    bool isWarped(const MapForm& form) const { return warper_ && form.parallel; }
    double faceShare(const MapForm& form) const;
    void set(const gl::Program& program, int unit) const override;
    int units() const override { return isWarped(receivers_) ? 1 : 0; }

    std::optional<MapWarper> warper_; ///< set if suns' maps are warped
    std::optional<MapBlur> blur_;     ///< created when a map is first filtered
    MapForm receivers_;               ///< form of the map drawn last
};

} // namespace edgeshade
