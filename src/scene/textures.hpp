#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/scene/load.hpp"

#include <map>

namespace edgeshade {

/// The base colour textures of a scene's materials, on the GPU.
class Textures {
  public:
    /// Uploads what the materials use. Throws InputError, Error(unavailable).
    Textures(const LoadedScene& loaded, const gl::Capabilities& capabilities);

    /// The material's texture; a white one where it has none.
    gl::Name of(const Material& material) const;

    /// Whether the material has a texture of its own.
    bool has(const Material& material) const;

  private:
    using Key = std::pair<int, Sampler>; ///< image, how it is looked up
    gl::Texture white_;
    std::map<Key, gl::Texture> textures_;
};

} // namespace edgeshade
