#include "src/viewer/renderers.hpp"

#include "src/settings/settings.hpp"

namespace edgeshade::viewer {

/// Leaves out settings without effect, so that sides that draw alike share a renderer.
Renderers::Key Renderers::keyOf(const SideSettings& side, Shading shading) {
    SideSettings effective;
    forEachSideSetting(
        [&](const auto& setting, auto& value, const auto& chosen) {
            if (holds(setting.matters, side)) value = chosen;
        },
        effective, side);
    return {effective, shading};
}

Renderer& Renderers::of(const SideSettings& side, const ViewState& state) {
    std::unique_ptr<Renderer>& renderer = renderers_[keyOf(side, state.shading)];
    if (!renderer) {
        RenderSettings settings = base_;
        setSide(settings, side);
        settings.shading = state.shading;
        renderer = std::make_unique<Renderer>(settings, capabilities_);
    }
    renderer->setAmbient(state.ambient);
    renderer->setExposure(state.exposure);
    renderer->setBackground(state.background);
    return *renderer;
}

void Renderers::dropUnusedTargets(const ViewState& state) {
    std::erase_if(renderers_, [&](const auto& entry) {
        const bool used = entry.first == keyOf(state.left, state.shading) ||
                          (state.split && entry.first == keyOf(state.right, state.shading));
        const bool hasTargets =
            entry.second &&
            entry.second->mapBytes() + entry.second->maskBytes() + entry.second->lightBytes() > 0;
        return !used && hasTargets;
    });
}

std::size_t Renderers::maskBytes() const {
    std::size_t total = 0;
    for (const auto& [key, renderer] : renderers_)
        if (renderer) total += renderer->maskBytes();
    return total;
}

std::size_t Renderers::mapBytes() const {
    std::size_t total = 0;
    for (const auto& [key, renderer] : renderers_)
        if (renderer) total += renderer->mapBytes();
    return total;
}

std::size_t Renderers::volumeBytes() const {
    std::size_t total = 0;
    for (const auto& [key, renderer] : renderers_)
        if (renderer && renderer->volumes()) total += renderer->volumes()->bytes();
    return total;
}

} // namespace edgeshade::viewer
