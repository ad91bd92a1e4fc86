#pragma once

#include "src/viewer/gestures.hpp"
#include "src/viewer/stage.hpp"
#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// Sizes of what can be grabbed, in window pixels (times Stage::pixelRatio in the picture's).
inline constexpr double handleRadius = 9.0;
inline constexpr double grabReach = 16.0;
inline constexpr double splitReach = 6.0;

/// What pointers and the wheel do to a view's state. Dragging: the primary button orbits, the
/// secondary one, the middle one or shift pans, control moves the chosen light; a light's handle or
/// the split's line is dragged where it is grabbed. Two fingers pinch and pan.
class Interaction {
  public:
    // Each returns the state that comes of it.
    ViewState down(const Pointer& pointer, const ViewState& state, const Stage& stage);
    /// Nothing where the pointer isn't down.
    std::optional<ViewState> move(const Pointer& pointer, const ViewState& state,
                                  const Stage& stage);
    void up(const Pointer& pointer);
    ViewState wheel(const glm::dvec2& pixel, double notches, const ViewState& state,
                    const Stage& stage) const;

  private:
    enum class Drag { none, orbit, pan, light, split };

    ViewState moved(const Motion& motion, const ViewState& state, const Stage& stage);

    Gestures gestures_;
    Drag drag_ = Drag::none;
    std::optional<LightDrag> light_;
    glm::dvec3 held_{0.0}; ///< the surface point that a pan or a pinch began on
};

/// Eye and pivot come nearer to what is seen at the pixel (factor < 1), or go away.
Camera zoomedTowards(const Camera& camera, const glm::dvec2& pixel, double factor,
                     const Stage& stage);

} // namespace edgeshade::viewer
