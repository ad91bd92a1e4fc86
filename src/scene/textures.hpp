#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/scene/load.hpp"

#include <map>
#include <memory>

namespace edgeshade {

/// The textures of a scene's materials, on the GPU. Copies share them.
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
    std::shared_ptr<const gl::Texture> white_;
    std::shared_ptr<std::map<Key, gl::Texture>> textures_;
};

} // namespace edgeshade
