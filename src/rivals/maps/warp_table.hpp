#pragma once

#include "src/gl/objects.hpp"
#include "src/rivals/maps/map_warp.hpp"

namespace edgeshade {

/// A warp's nodes as a texture for shaders_es2/rivals/maps/warp.glsl: one texel per node, with two
/// bytes each for x and y, so that no GL needs float textures.
class WarpTable {
  public:
    WarpTable();

    /// Leaves no texture bound.
    void fill(const MapWarp& warp) const;

    gl::Name texture() const { return texture_.name(); }
    static constexpr std::size_t bytes() { return 4 * (MapWarp::cells + 1) * (MapWarp::cells + 1); }

  private:
    gl::Texture texture_;
};

} // namespace edgeshade
