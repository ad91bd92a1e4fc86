#pragma once

#include "src/scene/batch_volumes.hpp"

namespace edgeshade {

/// How a triangle's sign is found (docs/method.md, The closed chain).
enum class MultiplicityMethod {
    plane,         ///< from its plane, stored once (docs/method.md, C1): plane-pair records hold
                   ///< planes
    referenceEdge, ///< Milet 2020: one edge decides for the triangle
    threeEdge,     ///< Peciva 2013: three edges must agree
    singleEdge,    ///< Kim 2008: every edge for itself; not robust, the failing baseline
    triangle,      ///< Sambeek 2007: every triangle for itself, without edges: brute force
};

/// The records with the data that the method needs: adapted records have planes, published ones
/// opposite vertices; brute force needs only triangles.
inline VolumeLayout volumeLayoutOf(MultiplicityMethod method) {
    if (method == MultiplicityMethod::plane) return VolumeLayout::planePairs;
    return method == MultiplicityMethod::triangle ? VolumeLayout::triangles
                                                  : VolumeLayout::oppositeVertices;
}

} // namespace edgeshade
