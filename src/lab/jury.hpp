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
    /// Both must outlive it.
    Jury(const LoadedScene& loaded, const CompareTask& task);

    /// Moves on to another view: traces it once for all contenders.
    void see(const LabView& view) { see(view, task_.width, task_.height); }
    /// In a smaller picture than the task's.
    void see(const LabView& view, int width, int height);

    /// All that there is to say of a contender in this view, ties and its mask included.
    Comparison compare(Renderer& renderer, const Contender& contender);

    /// What is wrong in its image and nothing else, which takes far less: what the oracle is asked
    /// again about a pixel is kept for other contenders.
    WrongCounts countWrongImage(Renderer& renderer, const Contender& contender);

    const std::vector<std::uint8_t>& image() const { return pictures_.image; }
    const Studio& studio() const { return studio_; }
    /// How the last contender's shadows were made, light by light.
    const std::vector<LightMethod>& methods() const { return methods_; }

  private:
    /// One view with its oracle, which all contenders share.
    struct JudgedView {
        FrameRequest request;
        FrameView frame; ///< of the oracle's scene
        std::unique_ptr<Oracle> oracle;
        SettledAnswers answers;
    };

    /// What the pictures without shadows are drawn with: slices and look.
    using Look = std::tuple<std::size_t, Shading, float, float>;

    /// The program's pictures of one look without shadows, of the view.
    struct Unshadowed {
        Pictures::Unshadowed draw;
        Pictures::LitAs drawAll;                 ///< where there are many lights
        std::unique_ptr<OraclePicture> expected; ///< made when first asked for
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
    /// Of judged_, by the scene and how many lights have shadows.
    std::map<std::pair<const LoadedScene*, std::optional<std::size_t>>, FrameView> frames_;
    std::map<Look, Unshadowed> unshadowed_; ///< of judged_
    std::map<Look, std::shared_ptr<Renderer>> plain_;
    Pictures pictures_;
    std::vector<LightMethod> methods_;
};

} // namespace edgeshade::lab
