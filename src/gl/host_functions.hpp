#pragma once

#include <string>

namespace edgeshade::gl {

/// Functions beyond ES 2.0 used to save a host's state, where the context has them.
struct HostFunctions {
    bool es3 = false;
    void (*genVertexArrays)(int, unsigned*) = nullptr; ///< null, or all three are available
    void (*deleteVertexArrays)(int, const unsigned*) = nullptr;
    void (*bindVertexArray)(unsigned) = nullptr;
    void (*divisor)(unsigned, unsigned) = nullptr;
    void (*bindSampler)(unsigned, unsigned) = nullptr;

    bool hasVertexArrays() const { return bindVertexArray != nullptr; }

    /// `version`, `extensions`: the context's. `lookUp` maps a name to an entry point or null.
    static HostFunctions find(const std::string& version, const std::string& extensions,
                              void* (*lookUp)(const char*));
};

} // namespace edgeshade::gl
