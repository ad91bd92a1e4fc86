#include "src/gl/instancing.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {
namespace {

/// Whether the space-separated list names the extension.
bool lists(const std::string& extensions, const std::string& name) {
    return (" " + extensions + " ").find(" " + name + " ") != std::string::npos;
}

/// The suffix of the entry points, or nothing where they are missing.
std::optional<std::string> entryPointSuffix(const std::string& version,
                                            const std::string& extensions) {
    const std::string prefix = "OpenGL ES ";
    if (version.starts_with(prefix) && version.size() > prefix.size() &&
        version[prefix.size()] >= '3')
        return "";
    for (const char* vendor : {"EXT", "ANGLE", "NV"})
        if (lists(extensions, std::string("GL_") + vendor + "_instanced_arrays")) return vendor;
    return std::nullopt;
}

} // namespace

std::optional<Instancing> Instancing::find(const std::string& version,
                                           const std::string& extensions,
                                           void* (*lookUp)(const char*)) {
    const auto suffix = entryPointSuffix(version, extensions);
    if (!suffix) return std::nullopt;
    Instancing instancing;
    instancing.divisor_ =
        reinterpret_cast<Divisor>(lookUp(("glVertexAttribDivisor" + *suffix).c_str()));
    instancing.drawArrays_ =
        reinterpret_cast<DrawArrays>(lookUp(("glDrawArraysInstanced" + *suffix).c_str()));
    if (!instancing.divisor_ || !instancing.drawArrays_) return std::nullopt;
    return instancing;
}

void Instancing::drawTriangles(int vertices, int instances) const {
    drawArrays_(GL_TRIANGLES, 0, vertices, instances);
}

} // namespace edgeshade::gl
