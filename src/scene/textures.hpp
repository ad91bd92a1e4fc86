#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/scene/load.hpp"

#include <map>

namespace edgeshade {

/// The textures of a scene's materials, on the GPU.
class Textures {
  public:
    /// Uploads the textures that the materials use. Throws InputError, Error(unavailable).
    Textures(const LoadedScene& loaded, const gl::Capabilities& capabilities);

    /// Its GL name, or that of a white texture if it is missing.
    gl::Name of(const MaterialTexture& texture) const;

    /// Whether the texture exists.
    bool has(const MaterialTexture& texture) const;

  private:
    using Key = std::pair<int, Sampler>; ///< image and sampler
    gl::Texture white_;
    std::map<Key, gl::Texture> textures_;
};

} // namespace edgeshade
