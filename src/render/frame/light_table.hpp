#pragma once

#include "src/gl/float_table.hpp"
#include "src/gl/program.hpp"
#include "src/shadow/plan/light_lists.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <functional>
#include <optional>

namespace edgeshade {

/// The table of listed lights, as surfaces sample it.
struct LightTableLookup {
    gl::Name texture = 0;
    glm::vec3 size{1.0f};  ///< see FloatTable
    glm::vec4 tiles{1.0f}; ///< see shaders_es2/light_table.glsl
    int longest = 1;       ///< turns of the loop: a power of 2, at least the longest list's length
};

/// Lights without a shadow and each tile's list of them, on the GPU, as
/// shaders_es2/light_table.glsl reads them. Holds one slice at a time.
class LightTable {
  public:
    explicit LightTable(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    /// Whether the GL has float textures and fragment shaders with full float precision.
    static bool isPossible(const gl::Capabilities& capabilities);

    /// Uploads the lists of a view. `colorOf`: light that a white Lambert surface reflects from a
    /// light, by its index in the view. Throws Error(unavailable) if a texture can't hold the
    /// lists.
    LightTableLookup upload(const LightLists& lists, const FrameView& view,
                            const std::function<glm::vec3(std::size_t)>& colorOf);

    std::size_t bytes() const { return table_ ? table_->bytes() : 0; }

  private:
    gl::Capabilities capabilities_;
    std::optional<gl::FloatTable> table_;
    std::size_t texels_ = 0; ///< capacity in texels
};

/// Binds the table to the texture unit.
void setLightTable(const gl::Program& program, const LightTableLookup& table, int unit);

} // namespace edgeshade
