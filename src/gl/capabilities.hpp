#pragma once

#include "src/gl/entry_points.hpp"
#include "src/gl/framebuffer_flip.hpp"
#include "src/gl/instancing.hpp"
#include "src/gl/multisampling.hpp"
#include "src/gl/timer_queries.hpp"

#include <optional>
#include <string>

namespace edgeshade::gl {

/// How much of a context's abilities is used.
enum class Limits {
    device,     ///< all of them
    es2Minimum, ///< those of every OpenGL ES 2.0, see limited()
};

/// Mantissa bits that ES 2.0 guarantees for highp floats in the vertex stage (GLSL ES 1.00, section
/// 4.5.2).
inline constexpr int leastMantissaBits = 16;

/// Subpixel bits that ES 2.0 guarantees (OpenGL ES 2.0.25, table 6.18).
inline constexpr int leastSubpixelBits = 4;

/// The current context's identity and abilities.
struct Capabilities {
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string extensions; ///< space-separated
    int depthBits = 0;
    int stencilBits = 0;
    int samples = 0;
    int subpixelBits = 0; ///< vertices are snapped to a grid of 2^-subpixelBits pixels
    int vertexAttributes = 0;
    int textureUnits = 0; ///< of the fragment stage
    int varyingVectors = 0;
    int vertexUniformVectors = 0;
    int fragmentUniformVectors = 0;
    int largestTexture = 0;
    int vertexHighpMantissaBits = 0;   ///< float32 has 23
    int fragmentHighpMantissaBits = 0; ///< 0: the fragment stage has no highp
    Limits limits = Limits::device;
    std::optional<Instancing> instancing;
    std::optional<FramebufferFlip> framebufferFlip;
    std::optional<Multisampling> multisampling;
    std::optional<TimerQueries> timerQueries;
    bool parallelCompiling = false; ///< GL_KHR_parallel_shader_compile: Program::isCompleted()

    /// Whether the processor renders: Mesa's llvmpipe and softpipe, SwiftShader.
    bool isSoftware() const;

    bool has(const std::string& extension) const { return listsExtension(extensions, extension); }
};

/// Queries the current context. `lookUp` maps a GL function's name to its address or null.
Capabilities queryCapabilities(void* (*lookUp)(const char*));

/// The capabilities under limits. es2Minimum leaves version 2.0 without extensions: no instancing,
/// no 32-bit indices, no depth textures, no derivatives, no antialiasing by framebuffers and no
/// timer queries. There are 8 attributes, 8 texture units, 8 varying, 128 vertex and 16 fragment
/// uniform vectors; 16 bits of depth, 8 of stencil; 16 mantissa bits in the vertex stage. Textures
/// have up to 2048 texels a side, since the guaranteed 64 are too few for textures and shadow maps.
Capabilities limited(Capabilities capabilities, Limits limits);

} // namespace edgeshade::gl
