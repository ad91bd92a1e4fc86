#pragma once

namespace edgeshade::gl {

/// Whether the GL is a browser's. There, querying state that the browser doesn't cache (a scissor's
/// box, a depth range) waits until all drawing is done.
#ifdef __EMSCRIPTEN__
inline constexpr bool inBrowser = true;
#else
inline constexpr bool inBrowser = false;
#endif

} // namespace edgeshade::gl
