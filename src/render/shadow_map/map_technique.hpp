#pragma once

#include "src/render/shadow_map/shadow_map_pass.hpp"
#include "src/render/shadow_map/visible_places.hpp"
#include "src/render/technique/shadow_technique.hpp"

#include <optional>

namespace edgeshade {

/// Surfaces look up shadow maps.
class MapTechnique : public ShadowTechnique {
  public:
    /// Throws Error(unavailable) if the maps are larger than the GL allows.
    MapTechnique(const ShadowMapSettings& settings, const gl::Capabilities& capabilities);

    void beginFrame(const FrameStart& start) override;
    bool drawsLookups() const override { return true; }
    std::size_t draw(const GpuScene& scene, const FrameView& view, const Light& light) override;
    const ShadowMapLookup* map() const override { return drawn_ ? &*drawn_ : nullptr; }

    void setBias(float texels) { pass_.setBias(texels); }
    /// Of the map of the light's kind, which lights of that kind share.
    std::size_t bytesOf(const Light& light) const { return pass_.bytesOf(light); }
    std::size_t bytes() const override { return pass_.bytes() + (places_ ? places_->bytes() : 0); }

  private:
    ShadowMapSettings settings_;
    ShadowMapPass pass_;
    std::optional<VisiblePlaces> places_; ///< where maps are warped
    std::vector<glm::dvec3> visible_;     ///< what this frame shows, where one is
    std::optional<ShadowMapLookup> drawn_;
};

} // namespace edgeshade
