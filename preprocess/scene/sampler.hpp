#pragma once

#include <compare>

namespace edgeshade {

/// How a texture is sampled, in GL's enums. The defaults are glTF's, or this program's choice where
/// an asset leaves it open.
struct Sampler {
    int wrapS = 10497;    ///< REPEAT
    int wrapT = 10497;    ///< REPEAT
    int minFilter = 9987; ///< LINEAR_MIPMAP_LINEAR
    int magFilter = 9729; ///< LINEAR

    /// Whether sampling uses mipmaps.
    bool takesMipmaps() const { return minFilter != 9728 && minFilter != 9729; }

    auto operator<=>(const Sampler&) const = default;
};

} // namespace edgeshade
