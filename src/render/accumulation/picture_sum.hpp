#pragma once

#include "src/gl/color_target.hpp"
#include "src/render/drawing/whole_picture.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade {

/// Pictures added up byte by byte, exactly, and of alpha how many of them have some, where a
/// framebuffer has 8 bits a channel as WebGL 1's have: sums of 16 bits, in two textures for their
/// low and high bytes. Changes the framebuffer binding, the viewport and the state of drawing.
class PictureSum {
  public:
    /// The largest sum a channel can have.
    static constexpr std::uint32_t most = 65535;

    /// Nothing yet, for pictures of this size. Throws Error(unavailable) if the GL can't.
    void begin(int width, int height);

    /// Adds a texture of that size, of 8 bits a channel.
    void add(gl::Name picture);

    /// Makes a texture of the share that the first channel is of `largest`, for VisibilityLookup.
    /// It stays until the next call, or the sum is gone.
    gl::Name share(std::uint32_t largest);

    /// Draws the sums' shares of `largest` as colours into that framebuffer.
    void show(gl::Name framebuffer, std::uint32_t largest) const;

    /// Draws into that framebuffer by a shader that takes u_low, u_high, u_texel and u_scale as
    /// sum_share.frag does, with textures on the units from 2 on.
    void draw(const WholePicture& by, gl::Name framebuffer, std::uint32_t largest) const;

    /// The sums, RGBA, of one pixel, rows top to bottom. Waits for the GL.
    std::array<std::uint16_t, 4> at(const glm::ivec2& pixel) const;

    /// The sums, RGBA, rows top to bottom. Waits for the GL.
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
    Halves sums_, next_;
    gl::ColorTarget share_; ///< once it is asked for
    std::optional<Programs> programs_;
};

} // namespace edgeshade
