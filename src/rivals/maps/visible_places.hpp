#pragma once

#include "src/render/drawing/nearness_target.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// What is seen, as places in the world: a coarse picture of how near it is, read back. It has at
/// most 16,384 pixels.
class VisiblePlaces {
  public:
    explicit VisiblePlaces(const gl::Capabilities& capabilities) : target_(capabilities) {}

    /// `drawNearness`: Renderer's, of the view that it is given. The framebuffer stays bound and
    /// the scissor as it is; what else it draws with is changed. Throws Error(unavailable) if the
    /// GL can't draw so.
    std::vector<glm::dvec3> find(const FrameView& view,
                                 const std::function<void(const FrameView&)>& drawNearness);

    std::size_t bytes() const { return target_.bytes(); }

  private:
    NearnessTarget target_;
};

} // namespace edgeshade
