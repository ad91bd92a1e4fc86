#pragma once

#include "src/render/accumulation/lit_counter.hpp"

#include <map>

namespace edgeshade {

/// Counts, for each of a picture's lights that has an extent, which of its points are seen from
/// where, all at once or some at a time while nothing moves.
class ExtendedLights {
  public:
    explicit ExtendedLights(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// The most points that one of the view's lights has which are drawn; 0: none has an extent.
    static std::size_t points(const FrameView& view);

    /// Nothing is counted yet.
    void restart() { counted_ = 0; }

    /// Goes on with up to `most` further points of each such light. Until restart() the view, the
    /// scene and what `renderer` draws must be the same. Throws Error.
    void advance(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                 const FrameView& view, std::size_t most, StageClock* clock = nullptr);

    /// Points of each light, so far.
    std::size_t counted() const { return counted_; }

    /// By light of that view, for Renderer::draw(), until the next call of anything here.
    std::vector<VisibilityLookup> visibility(const FrameView& view);

    /// What was counted for a light of the view that has an extent. Waits for the GL.
    LitCounts counts(std::size_t light) const { return counters_.at(light).read(); }

    std::size_t bytes() const;

  private:
    gl::Capabilities capabilities_;
    std::map<std::size_t, LitCounter> counters_; ///< by light
    std::size_t counted_ = 0;
};

/// Draws a whole frame, with all points of the lights that have an extent.
void drawWithExtents(Renderer& renderer, ExtendedLights& lights, GpuScene& scene,
                     const LoadedScene& loaded, const FrameView& view, StageClock* clock = nullptr);

} // namespace edgeshade
