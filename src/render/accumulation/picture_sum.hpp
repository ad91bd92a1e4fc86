#pragma once

#include "src/gl/color_target.hpp"
#include "src/render/drawing/whole_picture.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade {

/// Adds up pictures exactly, byte by byte. The alpha sum counts the pictures whose alpha is not 0.
/// Framebuffers have 8 bits a channel in WebGL 1, so two textures hold the low and high bytes of
/// 16-bit sums. Changes the framebuffer binding, the viewport and the drawing state.
class PictureSum {
  public:
    /// The largest sum that a channel holds.
    static constexpr std::uint32_t most = 65535;

    /// Starts from nothing, for pictures of this size. `part`: the only pixels to add up; the
    /// others are undefined. Throws Error(unavailable) if the GL can't.
    void begin(int width, int height, const std::optional<PixelRectangle>& part = {});

    /// Adds a texture of that size with 8 bits a channel.
    void add(gl::Name picture);

    /// Begins to make the programs, which add() makes otherwise.
    void beginPrograms();
    void forEachProgram(const gl::ProgramVisitor& visit) const;

    /// Returns a texture of the first channel's sum as a share of `largest`, for VisibilityLookup.
    /// Valid until the next call, or until the sum is destroyed.
    gl::Name share(std::uint32_t largest);

    /// Draws the sums as shares of `largest`, as colours, into that framebuffer.
    void show(gl::Name framebuffer, std::uint32_t largest) const;

    /// Draws into that framebuffer with a shader that takes u_low, u_high, u_texel and u_scale as
    /// sum_share.frag does. Its textures use units 2 and above.
    void draw(const WholePicture& by, gl::Name framebuffer, std::uint32_t largest) const;

    /// The RGBA sums of one pixel; rows are numbered top to bottom. Waits for the GL.
    std::array<std::uint16_t, 4> at(const glm::ivec2& pixel) const;

    /// The RGBA sums, rows top to bottom. Waits for the GL.
    std::vector<std::uint16_t> read() const;

    glm::ivec2 size() const { return size_; }
    std::size_t bytes() const;

  private:
    struct Halves {
        gl::ColorTarget low, high;
    };
    struct Programs {
        WholePicture low, high, share, picture;
    };

    glm::ivec2 size_{0};
    std::optional<PixelRectangle> part_;
    Halves sums_, next_;
    gl::ColorTarget share_; ///< created on first use
    std::optional<Programs> programs_;
};

} // namespace edgeshade
