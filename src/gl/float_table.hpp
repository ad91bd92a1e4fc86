#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"

#include <glm/glm.hpp>

namespace edgeshade::gl {

/// Numbers that a fragment shader reads one texel at a time: a texture of floats
/// (GL_OES_texture_float) in rows. Each texel has two numbers in (x, w), or four in (x, y, z, w).
class FloatTable {
  public:
    FloatTable() = default;
    /// A table of `count` pairs, two to each of these. Throws Error(unavailable) if they exceed the
    /// GL's largest texture, or it is out of memory.
    FloatTable(std::span<const glm::vec4> pairs, std::size_t count,
               const Capabilities& capabilities);
    /// A table of texels of four numbers each. Throws likewise.
    FloatTable(std::span<const glm::vec4> texels, const Capabilities& capabilities);
    /// Allocates `texels` texels of four numbers each, for fill(), if hasWideTables(). Throws if
    /// they are too many. Doesn't check for lack of memory, as that would wait until the GL has
    /// finished drawing.
    FloatTable(std::size_t texels, const Capabilities& capabilities);

    /// Uploads whole rows from texel `first` on, which starts a row; the last row may be shorter.
    /// Leaves no texture bound.
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

/// Whether fragment shaders can sample floats and compute with all of their bits.
bool hasFloatTables(const Capabilities& capabilities);
/// Whether the same holds for tables of four numbers a texel, which are core in ES 3.
bool hasWideTables(const Capabilities& capabilities);

} // namespace edgeshade::gl
