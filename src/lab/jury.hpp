#pragma once

#include "src/lab/compare_task.hpp"
#include "src/lab/studio.hpp"
#include "src/lab/verdicts.hpp"

#include <map>
#include <memory>

namespace edgeshade::lab {

/// Draws and judges contenders' pictures, view by view.
class Jury {
  public:
    /// `loaded` and `task` must outlive it.
    Jury(const LoadedScene& loaded, const CompareTask& task);

    /// Moves on to another view, and traces it once for all contenders.
    void see(const LabView& view) { see(view, task_.width, task_.height); }
    /// As above, at another size than the task's.
    void see(const LabView& view, int width, int height);

    /// Compares everything about a contender in this view, with ties and its mask.
    Comparison compare(Renderer& renderer, const Contender& contender);

    /// Counts wrong pixels in its image only, which is far quicker: pixels judged again by the
    /// oracle are kept for other contenders.
    WrongCounts countWrongImage(Renderer& renderer, const Contender& contender);

    const std::vector<std::uint8_t>& image() const { return pictures_.image; }
    const Studio& studio() const { return studio_; }
    /// How the last contender made its shadows, by light.
    const std::vector<LightMethod>& methods() const { return methods_; }

  private:
    /// A view with its oracle, shared by all contenders.
    struct JudgedView {
        FrameRequest request;
        FrameView frame; ///< view of the oracle's scene
        std::unique_ptr<Oracle> oracle;
        SettledAnswers answers;
    };

    /// Properties of pictures without shadows: slices and look.
    using Look = std::tuple<std::size_t, Shading, float, float>;

    /// A view's pictures without shadows, for one look.
    struct Unshadowed {
        Pictures::Unshadowed draw;
        Pictures::LitAs drawAll;                 ///< set if there are many lights
        std::unique_ptr<OraclePicture> expected; ///< created on first use
    };

    FrameView frameWith(const LoadedScene& drawn, std::optional<int> depthSlices,
                        std::optional<std::size_t> mostShadowed);
    FrameView frameFor(const Contender& contender);
    Unshadowed& unshadowedLike(const RenderSettings& settings, const FrameView& frame);
    void drawImage(Renderer& renderer, const LoadedScene& drawn, const FrameView& frame);

    const LoadedScene& loaded_;
    const CompareTask& task_;
    Studio studio_;
    AlphaLookup alpha_;
    JudgedView judged_;
    /// Frames of judged_, by scene and number of shadowed lights.
    std::map<std::pair<const LoadedScene*, std::optional<std::size_t>>, FrameView> frames_;
    std::map<Look, Unshadowed> unshadowed_; ///< pictures of judged_
    std::map<Look, std::shared_ptr<Renderer>> plain_;
    Pictures pictures_;
    std::vector<LightMethod> methods_;
};

} // namespace edgeshade::lab
