#pragma once

#include "src/gl/headless_context.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/light_methods.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "src/scene/load.hpp"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade::lab {

/// Scenes on the GPU in one context, by their records.
class Studio {
  public:
    Studio(int width, int height, gl::Limits limits) : context_({width, height, 0, limits}) {}

    /// A renderer for this studio's context.
    Renderer rendererFor(const RenderSettings& settings) const {
        return Renderer(settings, context_.capabilities());
    }

    std::vector<std::uint8_t> draw(Renderer& renderer, const LoadedScene& loaded,
                                   const FrameView& view,
                                   std::span<const VisibilityLookup> visibility = {}) {
        const auto records = renderer.settings().records();
        GpuScene& scene = sceneFor(loaded, records);
        prepareScene(scene, loaded, view, renderer);
        renderer.draw(scene, view, nullptr, visibility);
        methods_ = lightMethods(scene, view, renderer);
        gl::requireNoError("drawing for comparison");
        return context_.readPixels(view.width, view.height);
    }

    /// How the shadows of the last picture were made, by light.
    const std::vector<LightMethod>& methods() const { return methods_; }

    const gl::Capabilities& capabilities() const { return context_.capabilities(); }
    SidesLayout bestLayout() const { return edgeshade::bestLayout(context_.capabilities()); }
    int subpixelBits() const { return context_.capabilities().subpixelBits; }

    /// The uploaded scene; uploads it on first use.
    GpuScene& sceneFor(const LoadedScene& loaded, std::optional<VolumeRecords> records) {
        const auto key = std::pair(&loaded, records);
        auto found = scenes_.find(key);
        if (found == scenes_.end())
            found =
                scenes_.emplace(key, uploadScene(loaded, records, context_.capabilities())).first;
        return found->second;
    }

  private:
    std::vector<LightMethod> methods_;
    gl::HeadlessContext context_;
    std::map<std::pair<const LoadedScene*, std::optional<VolumeRecords>>, GpuScene> scenes_;
};

} // namespace edgeshade::lab
