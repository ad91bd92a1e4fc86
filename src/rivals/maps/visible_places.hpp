#pragma once

#include "src/render/drawing/nearness_target.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Finds visible places in the world: draws a coarse picture of nearness, and reads it back. It has
/// at most 16,384 pixels.
class VisiblePlaces {
  public:
    explicit VisiblePlaces(const gl::Capabilities& capabilities) : target_(capabilities) {}

    /// `drawNearness`: the renderer's, for the view that it receives. Keeps the framebuffer binding
    /// and the scissor; changes other drawing state. Throws Error(unavailable) if the GL can't draw
    /// such a picture.
    std::vector<glm::dvec3> find(const FrameView& view,
                                 const std::function<void(const FrameView&)>& drawNearness);

    std::size_t bytes() const { return target_.bytes(); }

  private:
    NearnessTarget target_;
};

} // namespace edgeshade
