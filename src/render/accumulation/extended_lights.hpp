#pragma once

#include "src/render/accumulation/lit_counter.hpp"

#include <map>

namespace edgeshade {

/// Counts which points of each light with an extent are visible from each pixel's surface, all at
/// once or some at a time while nothing moves.
class ExtendedLights {
  public:
    explicit ExtendedLights(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// The largest number of points that one of the view's drawn lights has; 0: none has an extent.
    static std::size_t points(const FrameView& view);

    /// Starts counting again from nothing.
    void restart() { counted_ = 0; }

    /// Counts up to `most` further points of each such light. Until restart() the view, the scene
    /// and the output of `renderer` must stay the same. Throws Error.
    void advance(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded,
                 const FrameView& view, std::size_t most, StageClock* clock = nullptr);

    /// Number of points counted so far for each light.
    std::size_t counted() const { return counted_; }

    /// The visibility of each of the view's lights, for Renderer::draw(). Valid until the next call
    /// of any member.
    std::vector<VisibilityLookup> visibility(const FrameView& view);

    /// The counts for a light of the view with an extent. Waits for the GL.
    LitCounts counts(std::size_t light) const { return counters_.at(light).read(); }

    std::size_t bytes() const;

  private:
    gl::Capabilities capabilities_;
    std::map<std::size_t, LitCounter> counters_; ///< by light
    std::size_t counted_ = 0;
};

/// Draws a whole frame with all points of the lights that have an extent.
void drawWithExtents(Renderer& renderer, ExtendedLights& lights, GpuScene& scene,
                     const LoadedScene& loaded, const FrameView& view, StageClock* clock = nullptr);

} // namespace edgeshade
