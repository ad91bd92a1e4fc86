#pragma once

#include "src/hours/positions.hpp"
#include "src/render/accumulation/lit_counter.hpp"
#include "src/viewer/counting_pace.hpp"
#include "src/viewer/seen_scene.hpp"
#include "src/viewer/sun_state.hpp"

#include <optional>

namespace edgeshade::viewer {

/// How far the hours of sun are counted.
struct SunHours {
    std::size_t counted = 0; ///< of the day's sun positions
    std::size_t of = 0;      ///< 0: the sun doesn't rise that day
    int step = 10;           ///< minutes that each stands for
};

/// Counts, for each pixel, the sun positions of a day that see its surface, a few between two
/// frames, and shows them as colours: what `edgeshade sunhours` counts (docs/sunhours.md).
class SunHoursCount {
  public:
    explicit SunHoursCount(const gl::Capabilities& capabilities) : counter_(capabilities) {}

    /// What is seen now, drawn as `view`, and the day. Starts anew unless they are what they were;
    /// the time of the day makes no difference.
    void see(const SeenScene& seen, const FrameView& view, const SunState& sun, int step);

    bool wantsMore() const { return counted_ < positions_.size(); }
    /// Whether there are hours to be shown.
    bool isComplete() const { return !positions_.empty() && !wantsMore(); }

    /// Goes on by some positions. `renderer`: of exact volumes; `now`: seconds. Returns whether all
    /// are counted. Throws Error.
    bool advance(Renderer& renderer, GpuScene& scene, const LoadedScene& loaded, double now);

    /// Draws what was counted into the framebuffer that is bound, before `background` (sRGB).
    void draw(const glm::vec3& background);

    /// Once all are counted: how many of them see a pixel, rows down; nothing: no surface is there.
    /// Waits for the GL.
    std::optional<std::uint32_t> at(const glm::ivec2& pixel) const;

    SunHours progress() const { return {counted_, positions_.size(), step_}; }
    std::size_t bytes() const { return counter_.bytes(); }

  private:
    /// By a row of colours.
    struct Drawing {
        Drawing();
        WholePicture picture;
        gl::Texture colors;
    };

    LitCounter counter_;
    CountingPace pace_;
    SeenScene seen_;
    std::optional<FrameView> view_;
    SunState day_; ///< at its start
    int step_ = 0;
    std::vector<hours::Position> positions_;
    std::size_t counted_ = 0;
    std::optional<Drawing> drawing_; ///< once it is asked for
};

} // namespace edgeshade::viewer
