#pragma once

namespace edgeshade {

/// What a user asks all shadows to be made by.
enum class ShadowMethod {
    volumes,
    primitiveMap, ///< and volumes for lights that have none
    automatic,    ///< whatever ShadowPolicy finds cheapest, light by light
    /// An IrregularZBuffer: the processor asks of each visible point whether it is in shadow.
    irregularZBuffer,
    map,
    planar, ///< projected onto the scene's largest planes, and nowhere else
    none,
};

} // namespace edgeshade
