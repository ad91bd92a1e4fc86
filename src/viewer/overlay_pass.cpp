#include "src/viewer/overlay_pass.hpp"

#include "shaders_es2.hpp"
#include "src/render/drawing/attributes.hpp"

#include <cstddef>

namespace edgeshade::viewer {

OverlayPass::OverlayPass()
    : program_(shaders::overlay_vert, shaders::overlay_frag, {}, {"a_position", "a_color"}) {}

void OverlayPass::draw(const OverlayTriangles& triangles, int width, int height) {
    if (triangles.empty()) return;
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    program_.use();
    program_.set("u_pictureSize", glm::vec4(width, height, 0.0f, 0.0f));
    const gl::Buffer buffer = gl::vertexBuffer<OverlayVertex>(triangles);
    {
        AttributeBinding binding(nullptr);
        binding.add(buffer, 2, GL_FLOAT, false, sizeof(OverlayVertex),
                    offsetof(OverlayVertex, position), false);
        binding.add(buffer, 4, GL_UNSIGNED_BYTE, true, sizeof(OverlayVertex),
                    offsetof(OverlayVertex, color), false);
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
    }
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace edgeshade::viewer
