#pragma once

#include "src/gl/float_table.hpp"
#include "src/gl/program.hpp"
#include "src/shadow/plan/light_lists.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <functional>
#include <optional>

namespace edgeshade {

/// What surfaces look up of listed lights.
struct LightTableLookup {
    gl::Name texture = 0;
    glm::vec3 size{1.0f};  ///< see FloatTable
    glm::vec4 tiles{1.0f}; ///< see shaders_es2/light_table.glsl
    int longest = 1;       ///< turns of the loop: a power of 2 that no list is longer than
};

/// Lights without a shadow, and which of them each tile lists, on the GPU as
/// shaders_es2/light_table.glsl reads them. One slice's at a time.
class LightTable {
  public:
    explicit LightTable(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Whether the GL has textures of floats, and fragment shaders that reckon with all of their
    /// bits.
    static bool isPossible(const gl::Capabilities& capabilities);

    /// Uploads the lists of a view. `colorOf`: what a white Lambert surface sends back of a light,
    /// by its index in the view. Throws Error(unavailable) if they are more than a texture holds.
    LightTableLookup upload(const LightLists& lists, const FrameView& view,
                            const std::function<glm::vec3(std::size_t)>& colorOf);

    std::size_t bytes() const { return table_ ? table_->bytes() : 0; }

  private:
    gl::Capabilities capabilities_;
    std::optional<gl::FloatTable> table_;
    std::size_t texels_ = 0; ///< that it has
};

/// Binds the table to the texture unit.
void setLightTable(gl::Program& program, const LightTableLookup& table, int unit);

} // namespace edgeshade
