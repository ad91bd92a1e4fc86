#pragma once

#include <optional>
#include <string>

namespace edgeshade::gl {

/// Instanced drawing, which is only an extension in GLES 2.
class Instancing {
  public:
    /// Looks up the entry points: core names from ES 3.0 on, otherwise GL_EXT_instanced_arrays,
    /// GL_ANGLE_instanced_arrays or GL_NV_instanced_arrays with its draw call. Null if the context
    /// has none of them. `lookUp` maps a name to an entry point or null.
    static std::optional<Instancing> find(const std::string& version, const std::string& extensions,
                                          void* (*lookUp)(const char*));

    void divisor(unsigned attribute, unsigned value) const { divisor_(attribute, value); }
    void drawTriangles(int vertices, int instances) const;
    /// Draws by the first `indices` 16-bit indices of the bound element array.
    void drawIndexedTriangles(int indices, int instances) const;

  private:
    using Divisor = void (*)(unsigned, unsigned);
    using DrawArrays = void (*)(unsigned, int, int, int);
    using DrawElements = void (*)(unsigned, int, unsigned, const void*, int);

    Divisor divisor_ = nullptr;
    DrawArrays drawArrays_ = nullptr;
    DrawElements drawElements_ = nullptr;
};

} // namespace edgeshade::gl
