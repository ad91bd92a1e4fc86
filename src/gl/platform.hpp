#pragma once

namespace edgeshade::gl {

/// Whether the GL is a browser's. Asking it for state that the browser doesn't keep itself (a
/// scissor's box, a depth range) waits for all that is being drawn.
#ifdef __EMSCRIPTEN__
inline constexpr bool inBrowser = true;
#else
inline constexpr bool inBrowser = false;
#endif

} // namespace edgeshade::gl
