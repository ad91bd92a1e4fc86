#include "src/gl/capabilities.hpp"

#include "src/gl/objects.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade::gl {
namespace {

std::string text(GLenum name) {
    const GLubyte* string = glGetString(name);
    return string ? reinterpret_cast<const char*>(string) : "";
}

/// Mantissa bits of the stage's highp; 0 without highp.
int highpMantissaBits(GLenum stage) {
    GLint range[2] = {}, mantissa = 0;
    glGetShaderPrecisionFormat(stage, GL_HIGH_FLOAT, range, &mantissa);
    return range[0] == 0 && range[1] == 0 ? 0 : mantissa;
}

} // namespace

bool Capabilities::isSoftware() const {
    const auto named = [&](const char* name) { return renderer.find(name) != std::string::npos; };
    return named("llvmpipe") || named("softpipe") || named("SwiftShader");
}

Capabilities queryCapabilities(void* (*lookUp)(const char*)) {
    Capabilities capabilities;
    capabilities.vendor = text(GL_VENDOR);
    capabilities.renderer = text(GL_RENDERER);
    capabilities.version = text(GL_VERSION);
    capabilities.extensions = text(GL_EXTENSIONS);
    capabilities.depthBits = integerOf(GL_DEPTH_BITS);
    capabilities.subpixelBits = std::max(integerOf(GL_SUBPIXEL_BITS), leastSubpixelBits);
    capabilities.stencilBits = integerOf(GL_STENCIL_BITS);
    capabilities.samples = integerOf(GL_SAMPLES);
    capabilities.vertexAttributes = integerOf(GL_MAX_VERTEX_ATTRIBS);
    capabilities.largestTexture = integerOf(GL_MAX_TEXTURE_SIZE);
    capabilities.textureUnits = integerOf(GL_MAX_TEXTURE_IMAGE_UNITS);
    capabilities.varyingVectors = integerOf(GL_MAX_VARYING_VECTORS);
    capabilities.vertexUniformVectors = integerOf(GL_MAX_VERTEX_UNIFORM_VECTORS);
    capabilities.fragmentUniformVectors = integerOf(GL_MAX_FRAGMENT_UNIFORM_VECTORS);
    capabilities.vertexHighpMantissaBits = highpMantissaBits(GL_VERTEX_SHADER);
    capabilities.fragmentHighpMantissaBits = highpMantissaBits(GL_FRAGMENT_SHADER);
    capabilities.instancing =
        Instancing::find(capabilities.version, capabilities.extensions, lookUp);
#ifndef __EMSCRIPTEN__ // pages draw into one colour attachment at a time
    capabilities.framebufferFlip = FramebufferFlip::find(capabilities.extensions, lookUp);
#endif
    capabilities.multisampling =
        Multisampling::find(capabilities.version, capabilities.extensions, lookUp);
    capabilities.timerQueries = TimerQueries::find(capabilities.extensions, lookUp);
    capabilities.parallelCompiling = capabilities.has("GL_KHR_parallel_shader_compile");
    return capabilities;
}

Capabilities limited(Capabilities capabilities, Limits limits) {
    if (limits == Limits::device) return capabilities;
    const auto lower = [](int& value, int most) { value = std::min(value, most); };
    capabilities.limits = limits;
    capabilities.version = "OpenGL ES 2.0, limited from " + capabilities.version;
    capabilities.extensions.clear();
    lower(capabilities.depthBits, 16);
    lower(capabilities.stencilBits, 8);
    capabilities.samples = 0;
    lower(capabilities.vertexAttributes, 8);
    lower(capabilities.textureUnits, 8);
    lower(capabilities.varyingVectors, 8);
    lower(capabilities.vertexUniformVectors, 128);
    lower(capabilities.fragmentUniformVectors, 16);
    lower(capabilities.largestTexture, 2048);
    lower(capabilities.vertexHighpMantissaBits, leastMantissaBits);
    lower(capabilities.fragmentHighpMantissaBits, leastMantissaBits);
    capabilities.instancing.reset();
    capabilities.framebufferFlip.reset();
    capabilities.multisampling.reset();
    capabilities.timerQueries.reset();
    capabilities.parallelCompiling = false;
    return capabilities;
}

} // namespace edgeshade::gl
