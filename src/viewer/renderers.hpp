#pragma once

#include "src/viewer/view_state.hpp"

#include <map>
#include <memory>

namespace edgeshade::viewer {

/// Renderers by the settings that they draw: compiled once, at hand when a user switches back.
class Renderers {
  public:
    /// `base`: all settings that SideSettings doesn't have; its layout is used as it is.
    Renderers(const RenderSettings& base, const gl::Capabilities& capabilities)
        : base_(base), capabilities_(capabilities) {}

    /// Throws Error(unavailable) if the GL can't, as for a map that is too large.
    Renderer& of(const SideSettings& side, const ViewState& state);

    /// Gives back the shadow maps, and masks of lower resolution, of renderers that the state
    /// doesn't use.
    void dropUnusedTargets(const ViewState& state);

    const RenderSettings& base() const { return base_; }

    /// How many are at hand.
    std::size_t size() const { return renderers_.size(); }

    /// Of all shadow maps that are kept.
    std::size_t mapBytes() const;
    /// Of all masks of lower resolution.
    std::size_t maskBytes() const;

    /// Of all potential silhouettes that are gathered for lights.
    std::size_t volumeBytes() const;

  private:
    using Key = std::tuple<ShadowMethod, int, MultiplicityMethod, int, MapKind, int, MapFilter, int,
                           WarpGrid, Shading>;
    static Key keyOf(const SideSettings& side, Shading shading);

    RenderSettings base_;
    gl::Capabilities capabilities_;
    std::map<Key, std::unique_ptr<Renderer>> renderers_;
};

} // namespace edgeshade::viewer
