#pragma once

#include "src/gl/objects.hpp"
#include "src/rivals/maps/map_warp.hpp"

namespace edgeshade {

/// A warp's nodes as a texture that shaders_es2/rivals/maps/warp.glsl looks up: a texel a node, two
/// bytes each of its x and y, so that no GL needs floats for it.
class WarpTable {
  public:
    WarpTable();

    /// Binds no texture.
    void fill(const MapWarp& warp) const;

    gl::Name texture() const { return texture_.name(); }
    static constexpr std::size_t bytes() { return 4 * (MapWarp::cells + 1) * (MapWarp::cells + 1); }

  private:
    gl::Texture texture_;
};

} // namespace edgeshade
