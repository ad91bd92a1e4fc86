#pragma once

namespace edgeshade {

/// How records reach the vertex shader (thesis, 6.2.6).
enum class SidesLayout {
    instanced,    ///< a record an instance, all its sides in one draw
    multiDraw,    ///< a record an instance, one draw a side, the side's index a uniform
    notInstanced, ///< a copy of the record for every vertex; needs no extension
};

} // namespace edgeshade
