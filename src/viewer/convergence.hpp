#pragma once

#include "src/render/accumulation/extended_lights.hpp"
#include "src/viewer/counting_pace.hpp"
#include "src/viewer/seen_scene.hpp"
#include "src/viewer/view_state.hpp"

#include <array>

namespace edgeshade::viewer {

/// All that counts of lights' points depend on.
struct CountedScene {
    SeenScene seen;
    std::vector<Light> lights;
    std::vector<bool> drawn; ///< which of them, and that points are counted for
    std::size_t lightSamples = 0;
    std::array<SideSettings, 2> sides; ///< of one picture both are the same
    bool cutouts = false;

    bool operator==(const CountedScene&) const = default;
};

/// Counts the points of lights with an extent, a few between two frames, while nothing moves: by
/// and by shadows become soft. A picture is worth being drawn after 4 points, 16, 64 and so on, and
/// after the last one; before, lights are as hard as their centre makes them.
class Convergence {
  public:
    explicit Convergence(const gl::Capabilities& capabilities)
        : sides_{ExtendedLights(capabilities), ExtendedLights(capabilities)} {}

    /// What is seen now, drawn as `view`. Starts anew unless it is what was seen before.
    void see(const CountedScene& scene, const FrameView& view);

    /// Whether there are points to be counted.
    bool wantsMore() const { return counted_ < of_; }

    /// Goes on; `renderers`: of the left side and, where there is a split, of the right one, null:
    /// its shadows take none. `now`: seconds. Returns whether a better picture can be drawn. Throws
    /// Error.
    bool advance(std::array<Renderer*, 2> renderers, GpuScene& scene, const LoadedScene& loaded,
                 double now);

    /// For Renderer::draw() of what is seen now; empty: lights are hard.
    std::vector<VisibilityLookup> visibility(std::size_t side);

    std::size_t shown() const { return shown_; } ///< points of each light in the last picture
    std::size_t of() const { return of_; }       ///< 0: no light has an extent
    std::size_t bytes() const { return sides_[0].bytes() + sides_[1].bytes(); }

  private:
    bool areCountedByMaps(const Renderer& renderer, const GpuScene& scene) const;

    std::array<ExtendedLights, 2> sides_;
    std::array<bool, 2> counts_{};
    CountedScene scene_;
    std::optional<FrameView> view_;
    std::size_t counted_ = 0, shown_ = 0, of_ = 0;
    CountingPace pace_;
};

} // namespace edgeshade::viewer
