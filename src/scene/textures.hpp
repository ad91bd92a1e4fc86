#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/scene/load.hpp"

#include <map>

namespace edgeshade {

/// The textures of a scene's materials, on the GPU.
class Textures {
  public:
    /// Uploads what the materials use. Throws InputError, Error(unavailable).
    Textures(const LoadedScene& loaded, const gl::Capabilities& capabilities);

    /// A white one where there is none.
    gl::Name of(const MaterialTexture& texture) const;

    /// Whether there is one.
    bool has(const MaterialTexture& texture) const;

  private:
    using Key = std::pair<int, Sampler>; ///< image, how it is looked up
    gl::Texture white_;
    std::map<Key, gl::Texture> textures_;
};

} // namespace edgeshade
