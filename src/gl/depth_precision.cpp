#include "src/gl/depth_precision.hpp"

#include <cmath>
#include <GLES2/gl2.h>

namespace edgeshade::gl {

void coarsenDepth(int bits, int wanted) {
    if (bits <= wanted) return;
    const float farthest = std::ldexp(1.0f, wanted - bits);
    glDepthRangef(0.0f, farthest);
    glClearDepthf(farthest);
}

} // namespace edgeshade::gl
