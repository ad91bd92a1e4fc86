#pragma once

#include "src/viewer/view_state.hpp"

#include <map>
#include <memory>

namespace edgeshade::viewer {

/// Renderers by the settings that they draw: compiled once, and ready when a user switches back.
class Renderers {
  public:
    /// `base`: all settings that SideSettings doesn't have; its layout is used unchanged.
    Renderers(const RenderSettings& base, const gl::Capabilities& capabilities)
        : base_(base), capabilities_(capabilities) {}

    /// Throws Error(unavailable) if the GL can't draw with these settings, for example with a map
    /// that is too large.
    Renderer& of(const SideSettings& side, const ViewState& state);

    /// Frees the shadow maps and the masks of lower resolution of renderers that the state doesn't
    /// use.
    void dropUnusedTargets(const ViewState& state);

    const RenderSettings& base() const { return base_; }

    /// Number of renderers.
    std::size_t size() const { return renderers_.size(); }

    /// Size of all shadow maps that are kept.
    std::size_t mapBytes() const;
    /// Size of all masks of lower resolution.
    std::size_t maskBytes() const;

    /// Size of all potential silhouettes collected for lights.
    std::size_t volumeBytes() const;

  private:
    using Key = std::pair<SideSettings, Shading>;
    static Key keyOf(const SideSettings& side, Shading shading);

    RenderSettings base_;
    gl::Capabilities capabilities_;
    std::map<Key, std::unique_ptr<Renderer>> renderers_;
};

} // namespace edgeshade::viewer
