#pragma once

#include "src/gl/program.hpp"
#include "src/scene/sides_layout.hpp"
#include "src/settings/choices.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// The program for the sides of opposite-vertex records. `extraDefines` and `extraAttributes` are
/// for tests.
gl::Program makeSidesProgram(MultiplicityMethod method, int maxMultiplicity, SidesLayout layout,
                             const std::vector<std::string>& extraDefines = {},
                             const std::vector<std::string>& extraAttributes = {});

/// Features of a program for caps beyond the published one.
struct CapsVariant {
    bool nearDiscard = false; ///< discard front caps where their triangles were clipped
    bool alphaTest = false;   ///< alpha-tested casters

    auto operator<=>(const CapsVariant&) const = default;
};

/// The program for the caps of opposite-vertex records.
gl::Program makeCapsProgram(MultiplicityMethod method, SidesLayout layout,
                            const CapsVariant& variant,
                            const std::vector<std::string>& extraDefines = {},
                            const std::vector<std::string>& extraAttributes = {});

} // namespace edgeshade
