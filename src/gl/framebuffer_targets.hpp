#pragma once

#include <GLES2/gl2.h>

namespace edgeshade::gl {

// Targets of glBindFramebuffer() that ES 2's header lacks. ES 3.0 and the extensions for
// multisampling use the same values.
constexpr GLenum readFramebuffer = 0x8CA8;
constexpr GLenum drawFramebuffer = 0x8CA9;

} // namespace edgeshade::gl
