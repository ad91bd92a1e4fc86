#include "src/gl/instancing.hpp"

#include "src/gl/entry_points.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {
std::optional<Instancing> Instancing::find(const std::string& version,
                                           const std::string& extensions,
                                           void* (*lookUp)(const char*)) {
    const auto suffix = entryPointSuffix(version, extensions, "instanced_arrays");
    if (!suffix) return std::nullopt;
    Instancing instancing;
    const bool complete =
        takeEntryPoint(instancing.divisor_, lookUp, "glVertexAttribDivisor" + *suffix) &&
        takeEntryPoint(instancing.drawArrays_, lookUp, "glDrawArraysInstanced" + *suffix) &&
        takeEntryPoint(instancing.drawElements_, lookUp, "glDrawElementsInstanced" + *suffix);
    return complete ? std::optional(instancing) : std::nullopt;
}

void Instancing::drawTriangles(int vertices, int instances) const {
    drawArrays_(GL_TRIANGLES, 0, vertices, instances);
}

void Instancing::drawIndexedTriangles(int indices, int instances) const {
    drawElements_(GL_TRIANGLES, indices, GL_UNSIGNED_SHORT, nullptr, instances);
}

} // namespace edgeshade::gl
