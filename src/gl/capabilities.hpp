#pragma once

#include "src/gl/instancing.hpp"
#include "src/gl/timer_queries.hpp"

#include <optional>
#include <string>

namespace edgeshade::gl {

/// What the current context is and can do.
struct Capabilities {
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string extensions; ///< space-separated
    int depthBits = 0;
    int stencilBits = 0;
    int samples = 0;
    int vertexAttributes = 0;
    int largestTexture = 0;
    int vertexHighpMantissaBits = 0;
    std::optional<Instancing> instancing;
    std::optional<TimerQueries> timerQueries;

    /// Whether the processor draws: Mesa's llvmpipe and softpipe, SwiftShader.
    bool isSoftware() const;

    bool has(const std::string& extension) const {
        return (" " + extensions + " ").find(" " + extension + " ") != std::string::npos;
    }
};

/// Asks the current context. `lookUp` maps a GL function's name to its address or null.
Capabilities queryCapabilities(void* (*lookUp)(const char*));

} // namespace edgeshade::gl
