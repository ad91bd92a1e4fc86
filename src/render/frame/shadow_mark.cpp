#include "src/render/frame/shadow_mark.hpp"

#include "shaders_es2.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

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

void ShadowMark::addValue(float value) {
    beginPrograms();
    value_->use().set("u_value", value);
    glDisable(GL_DEPTH_TEST);
    value_->draw();
    glEnable(GL_DEPTH_TEST);
}

void ShadowMark::beginPrograms() {
    if (!value_) value_.emplace(shaders::fill_frag, std::vector<std::string>{"VALUE"});
}

void ShadowMark::forEachProgram(const gl::ProgramVisitor& visit) const {
    picture_.forEachProgram(visit);
    if (value_) value_->forEachProgram(visit);
}

void ShadowMark::drawCounted() {
    glDisable(GL_DEPTH_TEST);
    glStencilFunc(GL_NOTEQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    picture_.draw();
    glEnable(GL_DEPTH_TEST);
}

} // namespace edgeshade
