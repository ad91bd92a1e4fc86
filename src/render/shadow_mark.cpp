#include "src/render/shadow_mark.hpp"

#include "shaders_es2.hpp"
#include "src/render/attributes.hpp"

#include <array>

namespace edgeshade {

ShadowMark::ShadowMark() : program_(shaders::fill_vert, shaders::fill_frag, {}, {"a_corner"}) {
    constexpr std::array<float, 6> corners = {-1.0f, -1.0f, 3.0f, -1.0f, -1.0f, 3.0f};
    triangle_ = gl::vertexBuffer<float>(corners);
}

void ShadowMark::clear() {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

void ShadowMark::markCounted() {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    drawCounted();
}

void ShadowMark::darkenCounted() {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_DST_ALPHA);
    drawCounted();
    glDisable(GL_BLEND);
}

void ShadowMark::drawCounted() {
    glDisable(GL_DEPTH_TEST);
    glStencilFunc(GL_NOTEQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    program_.use();
    {
        AttributeBinding binding(nullptr);
        binding.add(triangle_, 2, GL_FLOAT, false, 2 * sizeof(float), 0, false);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glEnable(GL_DEPTH_TEST);
}

} // namespace edgeshade
