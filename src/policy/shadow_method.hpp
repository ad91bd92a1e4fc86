#pragma once

namespace edgeshade {

/// The method that a user requests for all shadows.
enum class ShadowMethod {
    volumes,
    primitiveMap, ///< volumes for lights without a primitive map
    automatic,    ///< the method that ShadowPolicy expects to be cheapest for each light
    /// IrregularZBuffer: the processor tests each visible point for shadow.
    irregularZBuffer,
    map,
    planar, ///< projected onto the scene's largest planes, and nowhere else
    none,
};

} // namespace edgeshade
