#pragma once

// Faults that the program meets when faulty_gl.cpp is preloaded; both sides include this.

namespace edgeshade::test {

/// Environment variable: the fault, as one of the words below, with ":N" after a word that counts
/// from 1.
inline constexpr const char* faultVariable = "EDGESHADE_TEST_GL_FAULT";

/// Environment variable: a file that gets a line "NAME COUNT" for each kind of object still alive
/// when the program ends.
inline constexpr const char* leakVariable = "EDGESHADE_TEST_GL_LEAKS";

namespace fault {
inline constexpr const char* noConfig = "no-config";   ///< EGL offers no picture with a stencil
inline constexpr const char* noContext = "no-context"; ///< EGL creates no context
inline constexpr const char* noSurface = "no-surface"; ///< EGL has no memory for the picture
inline constexpr const char* noCurrent = "no-current"; ///< EGL can't make the context current
inline constexpr const char* noStencil = "no-stencil"; ///< the picture has no stencil
inline constexpr const char* noDepth = "no-depth";     ///< the picture has no depth
inline constexpr const char* noExtensions = "no-extensions"; ///< ES 2.0 and nothing else
inline constexpr const char* noCompile = "no-compile";       ///< :N the Nth shader is refused
inline constexpr const char* noLink = "no-link";             ///< :N the Nth program is refused
inline constexpr const char* noMemory = "no-memory";         ///< :N the Nth buffer, texture or
                                                             ///< renderbuffer has no memory
inline constexpr const char* noTarget = "no-target";         ///< no framebuffer object is complete
inline constexpr const char* lost = "lost"; ///< :N the context is lost at the Nth draw
inline constexpr const char* lostSilently = "lost-silently"; ///< the same, without errors: only the
                                                             ///< reset status reports it
} // namespace fault

} // namespace edgeshade::test
