#include "src/render/accumulation/picture_sum.hpp"

#include "preprocess/base/error.hpp"
#include "shaders_es2.hpp"
#include "src/gl/scissor.hpp"

#include <GLES2/gl2.h>
#include <utility>

namespace edgeshade {
namespace {

void unbind(int units) {
    for (int unit = units - 1; unit >= 0; --unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, 0);
    }
}

/// Binds and sets up a framebuffer in which bytes are written unchanged.
void drawPlainlyInto(gl::Name framebuffer, const glm::ivec2& size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void clear(const gl::ColorTarget& target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glClear(GL_COLOR_BUFFER_BIT);
}

void readBytes(const gl::ColorTarget& target, const glm::ivec2& from, const glm::ivec2& size,
               std::uint8_t* bytes) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glReadPixels(from.x, from.y, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
}

} // namespace

void PictureSum::begin(int width, int height, const std::optional<PixelRectangle>& part) {
    part_ = part;
    if (size_ != glm::ivec2(width, height)) {
        size_ = glm::ivec2(0); // in case the GL refuses below
        for (Halves* halves : {&sums_, &next_})
            *halves = {gl::ColorTarget(width, height), gl::ColorTarget(width, height)};
        share_ = {};
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw Error(ExitStatus::unavailable,
                        "This GL can't draw into a texture, which adding up pictures needs.");
        size_ = {width, height};
    }
    drawPlainlyInto(sums_.low.framebuffer.name(), size_);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    const gl::ScissorScope cut(part_);
    clear(sums_.low);
    clear(sums_.high);
    glEnable(GL_DITHER);
}

void PictureSum::beginPrograms() {
    if (programs_) return;
    programs_.emplace(Programs{
        WholePicture(shaders::add_bytes_frag), WholePicture(shaders::add_bytes_frag, {"HIGH"}),
        WholePicture(shaders::sum_share_frag), WholePicture(shaders::sum_share_frag, {"PICTURE"})});
}

void PictureSum::forEachProgram(const gl::ProgramVisitor& visit) const {
    if (!programs_) return;
    for (const WholePicture* of :
         {&programs_->low, &programs_->high, &programs_->share, &programs_->picture})
        of->forEachProgram(visit);
}

void PictureSum::add(gl::Name picture) {
    beginPrograms();
    const auto draw = [&](const WholePicture& by, const gl::ColorTarget& into) {
        drawPlainlyInto(into.framebuffer.name(), size_);
        const gl::ScissorScope cut(part_);
        const gl::Program& program = by.use();
        program.setTexture("u_added", 0, picture);
        program.setTexture("u_low", 1, sums_.low.texture.name());
        if (&by == &programs_->high) program.setTexture("u_high", 2, sums_.high.texture.name());
        program.set("u_texel", 1.0f / glm::vec2(size_));
        by.draw();
    };
    draw(programs_->low, next_.low);
    draw(programs_->high, next_.high);
    unbind(3);
    glEnable(GL_DITHER);
    std::swap(sums_, next_);
}

void PictureSum::draw(const WholePicture& by, gl::Name framebuffer, std::uint32_t largest) const {
    drawPlainlyInto(framebuffer, size_);
    const gl::ScissorScope cut(part_);
    const gl::Program& program = by.use();
    program.setTexture("u_low", 0, sums_.low.texture.name());
    program.setTexture("u_high", 1, sums_.high.texture.name());
    program.set("u_texel", 1.0f / glm::vec2(size_));
    program.set("u_scale", 255.0f / static_cast<float>(largest));
    by.draw();
    unbind(2);
    glEnable(GL_DITHER);
}

gl::Name PictureSum::share(std::uint32_t largest) {
    if (share_.texture.name() == 0) share_ = gl::ColorTarget(size_.x, size_.y);
    draw(programs_->share, share_.framebuffer.name(), largest);
    return share_.texture.name();
}

void PictureSum::show(gl::Name framebuffer, std::uint32_t largest) const {
    draw(programs_->picture, framebuffer, largest);
}

std::array<std::uint16_t, 4> PictureSum::at(const glm::ivec2& pixel) const {
    const glm::ivec2 from(pixel.x, size_.y - 1 - pixel.y); // the GL's rows run upwards
    std::array<std::uint8_t, 4> low{}, high{};
    readBytes(sums_.low, from, {1, 1}, low.data());
    readBytes(sums_.high, from, {1, 1}, high.data());
    std::array<std::uint16_t, 4> sums{};
    for (std::size_t i = 0; i < 4; ++i)
        sums[i] = static_cast<std::uint16_t>(low[i] | high[i] << 8);
    return sums;
}

std::vector<std::uint16_t> PictureSum::read() const {
    std::vector<std::uint8_t> low(4 * static_cast<std::size_t>(size_.x) *
                                  static_cast<std::size_t>(size_.y));
    std::vector<std::uint8_t> high(low.size());
    readBytes(sums_.low, {0, 0}, size_, low.data());
    readBytes(sums_.high, {0, 0}, size_, high.data());
    std::vector<std::uint16_t> sums(low.size());
    const std::size_t row = 4 * static_cast<std::size_t>(size_.x);
    for (std::size_t i = 0; i < sums.size(); ++i) { // the GL's rows run upwards
        const std::size_t from = (static_cast<std::size_t>(size_.y) - 1 - i / row) * row + i % row;
        sums[i] = static_cast<std::uint16_t>(low[from] | high[from] << 8);
    }
    return sums;
}

std::size_t PictureSum::bytes() const {
    const std::size_t pictures = share_.texture.name() == 0 ? 4 : 5;
    return pictures * 4 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
}

} // namespace edgeshade
