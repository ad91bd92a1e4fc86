#pragma once

#include "src/render/accumulation/extended_lights.hpp"
#include "src/shadow/layers/layer_search.hpp"
#include "src/viewer/counting_pace.hpp"
#include "src/viewer/seen_scene.hpp"
#include "src/viewer/view_state.hpp"

#include <array>

namespace edgeshade::viewer {

/// Everything that the counts of lights' points depend on.
struct CountedScene {
    SeenScene seen;
    std::vector<Light> lights;
    std::vector<bool> drawn; ///< whether each light is drawn, and its points are counted
    std::size_t lightSamples = 0;
    std::array<SideSettings, 2> sides; ///< equal where the picture isn't split
    bool cutouts = false;

    bool operator==(const CountedScene&) const = default;
};

/// Counts the points of lights with an extent, a few between two frames, while nothing moves, so
/// that shadows gradually become soft. A picture is worth drawing after 4, 16, 64 ... points and
/// after the last one; until the first of these, only the light's centre casts shadow.
class Convergence {
  public:
    explicit Convergence(const gl::Capabilities& capabilities)
        : sides_{ExtendedLights(capabilities), ExtendedLights(capabilities)} {}

    /// Sets the scene and its view. Restarts the count if either has changed.
    void see(const CountedScene& scene, const FrameView& view);

    /// Whether points are left to count.
    bool wantsMore() const { return counted_ < of_; }

    /// Continues. `renderers`: of the left side and, with a split, the right side; null where that
    /// side counts no points. `now`: seconds. Returns whether a better picture can be drawn. Throws
    /// Error.
    bool advance(std::array<Renderer*, 2> renderers, GpuScene& scene, const LoadedScene& loaded,
                 double now);

    /// Lookups for Renderer::draw() of the current view; empty: shadows are hard.
    std::vector<VisibilityLookup> visibility(std::size_t side);

    std::size_t shown() const { return shown_; } ///< points of each light in the last picture
    std::size_t of() const { return of_; }       ///< points in the end; 0: no light has an extent
    std::size_t bytes() const { return sides_[0].bytes() + sides_[1].bytes(); }

  private:
    bool areCountedByMaps(const Renderer& renderer, const GpuScene& scene) const;

    std::array<ExtendedLights, 2> sides_;
    std::array<bool, 2> counts_{};
    CountedScene scene_;
    std::optional<FrameView> view_;
    std::size_t counted_ = 0, shown_ = 0, of_ = 0;
    CountingPace pace_;
    LayerSearch layers_;
};

} // namespace edgeshade::viewer
