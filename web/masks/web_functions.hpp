#pragma once

namespace edgeshade::web {

/// The entry points beyond ES 2.0 that drawing uses, in the current WebGL 1 or 2 context; null for
/// all others.
void* webFunction(const char* name);

} // namespace edgeshade::web
