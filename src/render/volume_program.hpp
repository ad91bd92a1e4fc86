#pragma once

#include "src/gl/program.hpp"
#include "src/scene/batch_volumes.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// How a triangle's sign is found (docs/method.md, The closed chain).
enum class MultiplicityMethod {
    plane,         ///< its plane, stored once (docs/method.md, C1): adapted records hold these
    referenceEdge, ///< Milet 2020: one edge decides for the triangle
    threeEdge,     ///< Peciva 2013: three edges must agree
    singleEdge,    ///< Kim 2008: every edge for itself; not robust, the failing baseline
};

/// The records that have what the method needs: planes are in adapted ones, opposite vertices in
/// published ones.
inline VolumeLayout volumeLayoutOf(MultiplicityMethod method) {
    return method == MultiplicityMethod::plane ? VolumeLayout::adapted : VolumeLayout::published;
}

/// The program for sides, of published records. `extraDefines` and `extraAttributes` are for tests.
gl::Program makeSidesProgram(MultiplicityMethod method, int maxMultiplicity, SidesLayout layout,
                             const std::vector<std::string>& extraDefines = {},
                             const std::vector<std::string>& extraAttributes = {});

/// What a program for caps must do beyond the published one.
struct CapsVariant {
    bool nearDiscard = false; ///< cut front caps where their triangles were clipped
    bool alphaTest = false;   ///< casters with holes

    auto operator<=>(const CapsVariant&) const = default;
};

/// The program for caps, of published records.
gl::Program makeCapsProgram(MultiplicityMethod method, SidesLayout layout,
                            const CapsVariant& variant,
                            const std::vector<std::string>& extraDefines = {},
                            const std::vector<std::string>& extraAttributes = {});

} // namespace edgeshade
