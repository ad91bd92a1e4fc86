#pragma once

#include "src/hours/positions.hpp"
#include "src/render/accumulation/lit_counter.hpp"
#include "src/viewer/counting_pace.hpp"
#include "src/viewer/seen_scene.hpp"
#include "src/viewer/sun_state.hpp"

#include <optional>

namespace edgeshade::viewer {

/// Progress of counting the hours of sunlight.
struct SunHours {
    std::size_t counted = 0; ///< of the day's sun positions
    std::size_t of = 0;      ///< 0: the sun doesn't rise on that day
    int step = 10;           ///< minutes that each position stands for
};

/// Counts, for each pixel, the sun positions of a day from which its surface is lit, a few between
/// two frames, and shows the counts as colours. `edgeshade sunhours` counts the same
/// (docs/sunhours.md).
class SunHoursCount {
  public:
    explicit SunHoursCount(const gl::Capabilities& capabilities) : counter_(capabilities) {}

    /// Sets the scene, its view and the day. Restarts unless they are unchanged; the time of day
    /// doesn't matter.
    void see(const SeenScene& seen, const FrameView& view, const SunState& sun, int step);

    bool wantsMore() const { return counted_ < positions_.size(); }
    /// Whether the hours can be shown.
    bool isComplete() const { return !positions_.empty() && !wantsMore(); }

    /// Counts some more positions. `renderer`: for exact volumes; `now`: seconds. Returns whether
    /// all are counted. Throws Error.
    bool advance(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded, double now);

    /// Draws the counts into the bound framebuffer, over `background` (sRGB).
    void draw(const glm::vec3& background);

    /// After all are counted: the number of positions that light a pixel, y down; empty where there
    /// is no surface. Waits for the GL.
    std::optional<std::uint32_t> at(const glm::ivec2& pixel) const;

    SunHours progress() const { return {counted_, positions_.size(), step_}; }
    std::size_t bytes() const { return counter_.bytes(); }

  private:
    /// Draws counts by a row of colours.
    struct Drawing {
        Drawing();
        WholePicture picture;
        gl::Texture colors;
    };

    LitCounter counter_;
    CountingPace pace_;
    SeenScene seen_;
    std::optional<FrameView> view_;
    SunState day_; ///< the start of the day
    int step_ = 0;
    std::vector<hours::Position> positions_;
    std::size_t counted_ = 0;
    std::optional<Drawing> drawing_; ///< created at the first draw()
};

} // namespace edgeshade::viewer
