#pragma once

namespace edgeshade {

/// How records reach the vertex shader (thesis, 6.2.6).
enum class SidesLayout {
    instanced, ///< one record per instance, all its sides in one draw
    multiDraw, ///< one record per instance, one draw per side, with the side's index as a uniform
    notInstanced, ///< a copy of the record for every vertex; needs no extension
};

} // namespace edgeshade
