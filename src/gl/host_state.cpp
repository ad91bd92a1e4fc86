#include "src/gl/host_state.hpp"

#include "src/gl/framebuffer_targets.hpp"
#include "src/gl/objects.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::gl {
namespace {

// Constants of ES 3 that ES 2's header lacks.
constexpr GLenum vertexArrayBinding = 0x85B5, vertexDivisor = 0x88FE, samplerBinding = 0x8919,
                 readFramebufferBinding = 0x8CAA, packBuffer = 0x88EB, packBufferBinding = 0x88ED,
                 unpackBuffer = 0x88EC, unpackBufferBinding = 0x88EF;
constexpr GLenum switches[] = {GL_BLEND,
                               GL_CULL_FACE,
                               GL_DEPTH_TEST,
                               GL_DITHER,
                               GL_SCISSOR_TEST,
                               GL_STENCIL_TEST,
                               GL_SAMPLE_COVERAGE,
                               GL_SAMPLE_ALPHA_TO_COVERAGE,
                               GL_POLYGON_OFFSET_FILL};
constexpr GLenum es3Switches[] = {
#ifndef __EMSCRIPTEN__
    0x8D69, // PRIMITIVE_RESTART_FIXED_INDEX, which WebGL 2 has always on
#endif
    0x8C89}; // RASTERIZER_DISCARD
constexpr GLenum storage[] = {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT};
constexpr GLenum es3Storage[] = {
    0x0CF2, 0x0CF3, 0x0CF4, 0x806D, 0x806E, // UNPACK_: ROW_LENGTH, SKIP_ROWS, SKIP_PIXELS, images
    0x0D02, 0x0D03, 0x0D04};                // PACK_: ROW_LENGTH, SKIP_ROWS, SKIP_PIXELS

GLenum word(int value) {
    return static_cast<GLenum>(value);
}

void set(GLenum name, bool on) {
    on ? glEnable(name) : glDisable(name);
}

} // namespace

OwnArrays::OwnArrays(const HostFunctions& functions) : functions_(functions) {
    if (functions_.hasVertexArrays()) functions_.genVertexArrays(1, &name_);
}

OwnArrays::~OwnArrays() {
    if (name_ != 0) functions_.deleteVertexArrays(1, &name_);
}

HostState::HostState(const HostFunctions& functions, const OwnArrays& arrays)
    : functions_(functions) {
    // The limit is for a lost context, which returns errors forever.
    for (int i = 0; i < 16; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        if (error_ == 0) error_ = error;
    }
    for (const GLenum name : switches)
        switches_.emplace_back(name, glIsEnabled(name) == GL_TRUE);
    for (const GLenum name : storage)
        storage_.emplace_back(name, integerOf(name));
    if (functions_.es3) {
        for (const GLenum name : es3Switches)
            switches_.emplace_back(name, glIsEnabled(name) == GL_TRUE);
        for (const GLenum name : es3Storage)
            storage_.emplace_back(name, integerOf(name));
        packBuffer_ = integerOf(packBufferBinding);
        unpackBuffer_ = integerOf(unpackBufferBinding);
        readFramebuffer_ = integerOf(readFramebufferBinding);
    }
    framebuffer_ = integerOf(GL_FRAMEBUFFER_BINDING);
    renderbuffer_ = integerOf(GL_RENDERBUFFER_BINDING);
    program_ = integerOf(GL_CURRENT_PROGRAM);
    arrayBuffer_ = integerOf(GL_ARRAY_BUFFER_BINDING);
    activeTexture_ = integerOf(GL_ACTIVE_TEXTURE);
    units_.resize(static_cast<std::size_t>(integerOf(GL_MAX_TEXTURE_IMAGE_UNITS)));
    for (std::size_t i = 0; i < units_.size(); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        units_[i].texture = integerOf(GL_TEXTURE_BINDING_2D);
        if (functions_.bindSampler) units_[i].sampler = integerOf(samplerBinding);
    }
    blendSource_ = integerOf(GL_BLEND_SRC_RGB);
    blendTarget_ = integerOf(GL_BLEND_DST_RGB);
    blendSourceAlpha_ = integerOf(GL_BLEND_SRC_ALPHA);
    blendTargetAlpha_ = integerOf(GL_BLEND_DST_ALPHA);
    blendEquation_ = integerOf(GL_BLEND_EQUATION_RGB);
    blendEquationAlpha_ = integerOf(GL_BLEND_EQUATION_ALPHA);
    cullFace_ = integerOf(GL_CULL_FACE_MODE);
    frontFace_ = integerOf(GL_FRONT_FACE);
    depthFunction_ = integerOf(GL_DEPTH_FUNC);
    stencilClear_ = integerOf(GL_STENCIL_CLEAR_VALUE);
    front_ = stencilOf(false);
    back_ = stencilOf(true);
    glGetIntegerv(GL_VIEWPORT, viewport_.data());
    glGetIntegerv(GL_SCISSOR_BOX, scissor_.data());
    glGetBooleanv(GL_COLOR_WRITEMASK, colorMask_.data());
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, clearColor_.data());
    glGetFloatv(GL_DEPTH_RANGE, depthRange_.data());
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &depthClear_);
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offsetFactor_);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offsetUnits_);
    saveArrays();
    if (functions_.hasVertexArrays()) functions_.bindVertexArray(arrays.name());
    setDrawingDefaults(functions_);
}

HostState::~HostState() {
    restoreArrays();
    for (const auto& [name, on] : switches_)
        set(name, on);
    for (const auto& [name, value] : storage_)
        glPixelStorei(name, value);
    if (functions_.es3) {
        glBindBuffer(packBuffer, word(packBuffer_));
        glBindBuffer(unpackBuffer, word(unpackBuffer_));
        glBindFramebuffer(drawFramebuffer, word(framebuffer_));
        glBindFramebuffer(readFramebuffer, word(readFramebuffer_));
    } else {
        glBindFramebuffer(GL_FRAMEBUFFER, word(framebuffer_));
    }
    glBindRenderbuffer(GL_RENDERBUFFER, word(renderbuffer_));
    glUseProgram(word(program_));
    for (std::size_t i = 0; i < units_.size(); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_2D, word(units_[i].texture));
        if (functions_.bindSampler)
            functions_.bindSampler(static_cast<unsigned>(i), word(units_[i].sampler));
    }
    glActiveTexture(word(activeTexture_));
    glBlendFuncSeparate(word(blendSource_), word(blendTarget_), word(blendSourceAlpha_),
                        word(blendTargetAlpha_));
    glBlendEquationSeparate(word(blendEquation_), word(blendEquationAlpha_));
    glCullFace(word(cullFace_));
    glFrontFace(word(frontFace_));
    glDepthFunc(word(depthFunction_));
    glClearStencil(stencilClear_);
    restoreStencil(GL_FRONT, front_);
    restoreStencil(GL_BACK, back_);
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glScissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
    glColorMask(colorMask_[0], colorMask_[1], colorMask_[2], colorMask_[3]);
    glDepthMask(depthMask_);
    glClearColor(clearColor_[0], clearColor_[1], clearColor_[2], clearColor_[3]);
    glDepthRangef(depthRange_[0], depthRange_[1]);
    glClearDepthf(depthClear_);
    glPolygonOffset(offsetFactor_, offsetUnits_);
}

void HostState::saveArrays() {
    if (functions_.hasVertexArrays()) {
        vertexArray_ = integerOf(vertexArrayBinding);
        return;
    }
    elementBuffer_ = integerOf(GL_ELEMENT_ARRAY_BUFFER_BINDING);
    attributes_.resize(static_cast<std::size_t>(integerOf(GL_MAX_VERTEX_ATTRIBS)));
    for (std::size_t i = 0; i < attributes_.size(); ++i) {
        Attribute& of = attributes_[i];
        const auto index = static_cast<GLuint>(i);
        glGetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &of.enabled);
        glGetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_SIZE, &of.size);
        glGetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_STRIDE, &of.stride);
        glGetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_TYPE, &of.type);
        glGetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, &of.normalized);
        glGetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &of.buffer);
        glGetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &of.pointer);
        if (functions_.divisor) {
            glGetVertexAttribiv(index, vertexDivisor, &of.divisor);
            functions_.divisor(index, 0);
        }
        glDisableVertexAttribArray(index);
    }
}

void HostState::restoreArrays() const {
    if (functions_.hasVertexArrays()) functions_.bindVertexArray(word(vertexArray_));
    for (std::size_t i = 0; i < attributes_.size(); ++i) {
        const Attribute& of = attributes_[i];
        const auto index = static_cast<GLuint>(i);
        glBindBuffer(GL_ARRAY_BUFFER, word(of.buffer));
        glVertexAttribPointer(index, of.size, word(of.type), of.normalized ? GL_TRUE : GL_FALSE,
                              of.stride, of.pointer);
        if (functions_.divisor) functions_.divisor(index, word(of.divisor));
        of.enabled ? glEnableVertexAttribArray(index) : glDisableVertexAttribArray(index);
    }
    if (!functions_.hasVertexArrays()) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, word(elementBuffer_));
    glBindBuffer(GL_ARRAY_BUFFER, word(arrayBuffer_));
}

void setDrawingDefaults(const HostFunctions& functions) {
    for (const GLenum name : switches)
        set(name, name == GL_DITHER);
    for (const GLenum name : storage)
        glPixelStorei(name, 4);
    if (functions.es3) {
        for (const GLenum name : es3Switches)
            glDisable(name);
        for (const GLenum name : es3Storage)
            glPixelStorei(name, 0);
        glBindBuffer(packBuffer, 0);
        glBindBuffer(unpackBuffer, 0);
    }
    const int units = functions.bindSampler ? integerOf(GL_MAX_TEXTURE_IMAGE_UNITS) : 0;
    for (int i = 0; i < units; ++i)
        functions.bindSampler(static_cast<unsigned>(i), 0);
    glBlendEquation(GL_FUNC_ADD);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glDepthRangef(0.0f, 1.0f);
    glClearDepthf(1.0f);
    glPolygonOffset(0.0f, 0.0f);
    glStencilMask(0xFF);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
}

HostState::StencilFace HostState::stencilOf(bool back) const {
    if (back)
        return {integerOf(GL_STENCIL_BACK_FUNC),
                integerOf(GL_STENCIL_BACK_REF),
                integerOf(GL_STENCIL_BACK_VALUE_MASK),
                integerOf(GL_STENCIL_BACK_FAIL),
                integerOf(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                integerOf(GL_STENCIL_BACK_PASS_DEPTH_PASS),
                integerOf(GL_STENCIL_BACK_WRITEMASK)};
    return {integerOf(GL_STENCIL_FUNC),
            integerOf(GL_STENCIL_REF),
            integerOf(GL_STENCIL_VALUE_MASK),
            integerOf(GL_STENCIL_FAIL),
            integerOf(GL_STENCIL_PASS_DEPTH_FAIL),
            integerOf(GL_STENCIL_PASS_DEPTH_PASS),
            integerOf(GL_STENCIL_WRITEMASK)};
}

void HostState::restoreStencil(unsigned face, const StencilFace& stencil) const {
    glStencilFuncSeparate(face, word(stencil.function), stencil.reference, word(stencil.readMask));
    glStencilOpSeparate(face, word(stencil.fail), word(stencil.depthFail), word(stencil.pass));
    glStencilMaskSeparate(face, word(stencil.writeMask));
}

} // namespace edgeshade::gl
