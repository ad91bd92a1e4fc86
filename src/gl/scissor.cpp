#include "src/gl/scissor.hpp"

#include "src/gl/platform.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade::gl {
namespace {

PixelRectangle scissorBox() {
    GLint box[4] = {};
    glGetIntegerv(GL_SCISSOR_BOX, box);
    return {box[0], box[1], box[2], box[3]};
}

void scissor(const PixelRectangle& box) {
    glScissor(box.x, box.y, std::max(0, box.width), std::max(0, box.height));
}

} // namespace

PixelRectangle scissored(int width, int height) {
    const PixelRectangle whole{0, 0, width, height};
    if (glIsEnabled(GL_SCISSOR_TEST) != GL_TRUE) return whole;
    return intersection(whole, scissorBox());
}

ScissorScope::ScissorScope(const std::optional<PixelRectangle>& rectangle,
                           const std::optional<PixelRectangle>& around)
    : restricts_(rectangle.has_value()) {
    if (!restricts_) return;
    enabled_ = around || glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
    if (around)
        box_ = *around;
    else if (enabled_ || !inBrowser)
        box_ = scissorBox();
    glEnable(GL_SCISSOR_TEST);
    scissor(*rectangle);
}

ScissorScope::~ScissorScope() {
    if (!restricts_) return;
    if (enabled_ || !inBrowser) scissor(box_);
    if (!enabled_) glDisable(GL_SCISSOR_TEST);
}

} // namespace edgeshade::gl
