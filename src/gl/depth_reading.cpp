#include "src/gl/depth_reading.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {

bool canReadDepth(const Capabilities& capabilities) {
    return capabilities.has("GL_NV_read_depth");
}

int readDepth(int width, int height, std::vector<std::uint32_t>& depths) {
    GLint sampled = 0, bits = 0;
    glGetIntegerv(GL_SAMPLE_BUFFERS, &sampled);
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    if (sampled != 0 || bits == 0) return 0;
    depths.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
    return bits;
}

} // namespace edgeshade::gl
