#include "src/gl/capabilities.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {
namespace {

std::string text(GLenum name) {
    const GLubyte* string = glGetString(name);
    return string ? reinterpret_cast<const char*>(string) : "";
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
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
    capabilities.depthBits = integer(GL_DEPTH_BITS);
    capabilities.stencilBits = integer(GL_STENCIL_BITS);
    capabilities.samples = integer(GL_SAMPLES);
    capabilities.vertexAttributes = integer(GL_MAX_VERTEX_ATTRIBS);
    capabilities.largestTexture = integer(GL_MAX_TEXTURE_SIZE);
    GLint range[2] = {}, mantissa = 0;
    glGetShaderPrecisionFormat(GL_VERTEX_SHADER, GL_HIGH_FLOAT, range, &mantissa);
    capabilities.vertexHighpMantissaBits = mantissa;
    capabilities.instancing =
        Instancing::find(capabilities.version, capabilities.extensions, lookUp);
    capabilities.timerQueries = TimerQueries::find(capabilities.extensions, lookUp);
    return capabilities;
}

} // namespace edgeshade::gl
