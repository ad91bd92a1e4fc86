#pragma once

#include "src/render/shadow_map/shadow_map_pass.hpp"

#include <memory>
#include <optional>

namespace edgeshade {

/// Surfaces sample shadow maps.
class MapTechnique : public ShadowTechnique {
  public:
    explicit MapTechnique(std::unique_ptr<ShadowMapPass> pass) : pass_(std::move(pass)) {}

    void beginFrame(const FrameStart& start) override {
        drawn_.reset();
        pass_->beginFrame(start);
    }
    bool drawsMap() const override { return true; }
    std::size_t draw(const GpuScene& scene, const FrameView& view, const Light& light) override {
        drawn_ = pass_->draw(scene, view, light);
        return pass_->vertexRuns();
    }
    const ShadowMapLookup* map() const override { return drawn_ ? &*drawn_ : nullptr; }
    void describe(const GpuScene&, const Light& light, LightMethod& method) const override {
        method.why = pass_->words(light);
        method.bytes = pass_->bytesOf(light);
    }

    void setBias(float texels) { pass_->setBias(texels); }
    std::size_t bytes() const override { return pass_->bytes(); }

  private:
    std::unique_ptr<ShadowMapPass> pass_;
    std::optional<ShadowMapLookup> drawn_;
};

} // namespace edgeshade
