#pragma once

#include "src/scene/batch_volumes.hpp"

namespace edgeshade {

/// How a triangle's sign is found (docs/method.md, The closed chain).
enum class MultiplicityMethod {
    plane,         ///< its plane, stored once (docs/method.md, C1): plane-pair records hold these
    referenceEdge, ///< Milet 2020: one edge decides for the triangle
    threeEdge,     ///< Peciva 2013: three edges must agree
    singleEdge,    ///< Kim 2008: every edge for itself; not robust, the failing baseline
    triangle,      ///< Sambeek 2007: every triangle for itself, without edges: brute force
};

/// The records that have what the method needs: planes are in adapted ones, opposite vertices in
/// published ones; brute force needs triangles alone.
inline VolumeLayout volumeLayoutOf(MultiplicityMethod method) {
    if (method == MultiplicityMethod::plane) return VolumeLayout::planePairs;
    return method == MultiplicityMethod::triangle ? VolumeLayout::triangles
                                                  : VolumeLayout::oppositeVertices;
}

} // namespace edgeshade
