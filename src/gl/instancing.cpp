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
    instancing.divisor_ =
        reinterpret_cast<Divisor>(lookUp(("glVertexAttribDivisor" + *suffix).c_str()));
    instancing.drawArrays_ =
        reinterpret_cast<DrawArrays>(lookUp(("glDrawArraysInstanced" + *suffix).c_str()));
    instancing.drawElements_ =
        reinterpret_cast<DrawElements>(lookUp(("glDrawElementsInstanced" + *suffix).c_str()));
    if (!instancing.divisor_ || !instancing.drawArrays_ || !instancing.drawElements_)
        return std::nullopt;
    return instancing;
}

void Instancing::drawTriangles(int vertices, int instances) const {
    drawArrays_(GL_TRIANGLES, 0, vertices, instances);
}

void Instancing::drawIndexedTriangles(int indices, int instances) const {
    drawElements_(GL_TRIANGLES, indices, GL_UNSIGNED_SHORT, nullptr, instances);
}

} // namespace edgeshade::gl
