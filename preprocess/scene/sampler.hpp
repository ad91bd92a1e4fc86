#pragma once

#include <compare>

namespace edgeshade {

/// How texels of a texture are looked up, in GL's enums; glTF's default, or what this program takes
/// where an asset leaves it open.
struct Sampler {
    int wrapS = 10497;    ///< REPEAT
    int wrapT = 10497;    ///< REPEAT
    int minFilter = 9987; ///< LINEAR_MIPMAP_LINEAR
    int magFilter = 9729; ///< LINEAR

    /// Whether smaller copies of the texture are looked up.
    bool takesMipmaps() const { return minFilter != 9728 && minFilter != 9729; }

    auto operator<=>(const Sampler&) const = default;
};

} // namespace edgeshade
