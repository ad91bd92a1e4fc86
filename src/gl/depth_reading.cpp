#include "src/gl/depth_reading.hpp"

#include <array>
#include <cmath>
#include <GLES2/gl2.h>

namespace edgeshade::gl {
namespace {

/// Makes depths of a part of the buffer's range those of all of it. Returns the bits that are left.
int spread(std::vector<std::uint32_t>& depths, float near, float far, int bits) {
    constexpr double most = 4294967295.0;
    const double size = static_cast<double>(far) - static_cast<double>(near);
    const int left = bits + static_cast<int>(std::floor(std::log2(std::abs(size))));
    const double halfStep = std::ldexp(0.5, -left);
    for (std::uint32_t& depth : depths) {
        const double at = (depth / most - static_cast<double>(near)) / size;
        depth = at > 1.0 - halfStep ? 0xFFFFFFFFu
                : at > 0.0          ? static_cast<std::uint32_t>(at * most)
                                    : 0u;
    }
    return left;
}

} // namespace

bool canReadDepth(const Capabilities& capabilities) {
    return capabilities.has("GL_NV_read_depth");
}

int readDepth(const PixelRectangle& of, std::vector<std::uint32_t>& depths) {
    GLint sampled = 0, bits = 0;
    glGetIntegerv(GL_SAMPLE_BUFFERS, &sampled);
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    if (sampled != 0 || bits == 0) return 0;
    depths.resize(static_cast<std::size_t>(of.width) * static_cast<std::size_t>(of.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(of.x, of.y, of.width, of.height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                 depths.data());
    std::array<float, 2> range{};
    glGetFloatv(GL_DEPTH_RANGE, range.data());
    if (range[0] == range[1]) return 0;
    return range[0] == 0.0f && range[1] == 1.0f ? bits : spread(depths, range[0], range[1], bits);
}

} // namespace edgeshade::gl
