#include "src/gl/scissor.hpp"

#include "src/gl/platform.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade::gl {

PixelRectangle scissored(int width, int height) {
    const PixelRectangle whole{0, 0, width, height};
    if (glIsEnabled(GL_SCISSOR_TEST) != GL_TRUE) return whole;
    GLint box[4] = {};
    glGetIntegerv(GL_SCISSOR_BOX, box);
    return intersection(whole, {box[0], box[1], box[2], box[3]});
}

ScissorScope::ScissorScope(const std::optional<PixelRectangle>& rectangle)
    : restricts_(rectangle.has_value()) {
    if (!restricts_) return;
    enabled_ = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
    if (enabled_ || !inBrowser) glGetIntegerv(GL_SCISSOR_BOX, box_);
    glEnable(GL_SCISSOR_TEST);
    glScissor(rectangle->x, rectangle->y, std::max(0, rectangle->width),
              std::max(0, rectangle->height));
}

ScissorScope::~ScissorScope() {
    if (!restricts_) return;
    if (enabled_ || !inBrowser) glScissor(box_[0], box_[1], box_[2], box_[3]);
    if (!enabled_) glDisable(GL_SCISSOR_TEST);
}

} // namespace edgeshade::gl
