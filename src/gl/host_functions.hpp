#pragma once

#include <string>

namespace edgeshade::gl {

/// Functions beyond ES 2.0 that saving a host's state takes, where the context has them.
struct HostFunctions {
    bool es3 = false;
    void (*genVertexArrays)(int, unsigned*) = nullptr; ///< with the next two, or none of them
    void (*deleteVertexArrays)(int, const unsigned*) = nullptr;
    void (*bindVertexArray)(unsigned) = nullptr;
    void (*divisor)(unsigned, unsigned) = nullptr;
    void (*bindSampler)(unsigned, unsigned) = nullptr;

    bool hasVertexArrays() const { return bindVertexArray != nullptr; }

    /// `version`, `extensions`: of the context. `lookUp` maps a name to an entry point or null.
    static HostFunctions find(const std::string& version, const std::string& extensions,
                              void* (*lookUp)(const char*));
};

} // namespace edgeshade::gl
