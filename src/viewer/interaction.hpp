#pragma once

#include "src/viewer/gestures.hpp"
#include "src/viewer/section_tool.hpp"
#include "src/viewer/stage.hpp"
#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// Sizes of grab areas, in window pixels (times Stage::pixelRatio in picture pixels).
inline constexpr double handleRadius = 9.0;
inline constexpr double grabReach = 16.0;
inline constexpr double splitReach = 6.0;

/// Changes a view's state by pointers and the wheel. The primary button orbits; the secondary or
/// middle button, or shift, pans; control moves the chosen light. A light's handle, a section's
/// plane or the split's line is dragged wherever it is grabbed. Two fingers pinch and pan.
class Interaction {
  public:
    // Each returns the resulting state.
    ViewState down(const Pointer& pointer, const ViewState& state, const Stage& stage);
    /// Empty if the pointer isn't down.
    std::optional<ViewState> move(const Pointer& pointer, const ViewState& state,
                                  const Stage& stage);
    void up(const Pointer& pointer);
    ViewState wheel(const glm::dvec2& pixel, double notches, const ViewState& state,
                    const Stage& stage) const;

  private:
    enum class Drag { none, orbit, pan, light, section, split };

    ViewState moved(const Motion& motion, const ViewState& state, const Stage& stage);

    Gestures gestures_;
    Drag drag_ = Drag::none;
    std::optional<LightDrag> light_;
    std::optional<SectionDrag> section_;
    glm::dvec3 held_{0.0}; ///< the surface point where a pan or a pinch began
};

/// Moves eye and pivot towards the point under the pixel (factor < 1) or away from it.
Camera zoomedTowards(const Camera& camera, const glm::dvec2& pixel, double factor,
                     const Stage& stage);

} // namespace edgeshade::viewer
