#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"

#include <glm/glm.hpp>

namespace edgeshade::gl {

/// Numbers for a fragment shader to look up one by one: a texture of floats (GL_OES_texture_float)
/// in rows, each texel's numbers in (x, w) or all of (x, y, z, w).
class FloatTable {
  public:
    FloatTable() = default;
    /// Throws Error(unavailable) if they are more than the GL's largest texture holds, or it is out
    /// of memory.
    FloatTable(std::span<const glm::vec2> texels, const Capabilities& capabilities);
    FloatTable(std::span<const glm::vec4> texels, const Capabilities& capabilities);
    /// So many of four numbers each, to be filled: where hasWideTables(). Throws if they are too
    /// many; the GL's memory isn't asked for, which would wait for all that it draws.
    FloatTable(std::size_t texels, const Capabilities& capabilities);

    /// Whole rows from the given texel on, which begins one; the last one may be shorter. Binds no
    /// texture.
    void fill(std::size_t first, std::span<const glm::vec4> texels) const;

    Name texture() const { return texture_.name(); }
    /// (columns, 1 / columns, 1 / rows); columns are a power of two.
    const glm::vec3& size() const { return size_; }
    std::size_t bytes() const { return bytes_; }

  private:
    void allocate(std::size_t count, std::size_t channels, const Capabilities& capabilities);
    void fillRows(std::size_t first, const void* texels, std::size_t count) const;

    Texture texture_;
    std::size_t channels_ = 4, columns_ = 1;
    glm::vec3 size_{1.0f};
    std::size_t bytes_ = 0;
};

/// Whether fragment shaders can look up floats and reckon with all of their bits.
bool hasFloatTables(const Capabilities& capabilities);
/// The same of tables of four numbers a texel, which ES 3 has in its core.
bool hasWideTables(const Capabilities& capabilities);

} // namespace edgeshade::gl
