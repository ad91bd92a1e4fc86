// All state that the host has set is unchanged after the masks were drawn, and the masks are the
// same as in a fresh context, with and without vertex array objects.
#include "src/gl/host_functions.hpp"
#include "tests/engine/masks_in_a_host.hpp"

#include <GLES2/gl2.h>
#include <gtest/gtest.h>
#include <map>

namespace edgeshade {
namespace {

using namespace test;

constexpr GLenum asked[] = {GL_ACTIVE_TEXTURE,
                            GL_ARRAY_BUFFER_BINDING,
                            GL_BLEND,
                            GL_BLEND_COLOR,
                            GL_BLEND_DST_ALPHA,
                            GL_BLEND_DST_RGB,
                            GL_BLEND_EQUATION_ALPHA,
                            GL_BLEND_EQUATION_RGB,
                            GL_BLEND_SRC_ALPHA,
                            GL_BLEND_SRC_RGB,
                            GL_COLOR_CLEAR_VALUE,
                            GL_COLOR_WRITEMASK,
                            GL_CULL_FACE,
                            GL_CULL_FACE_MODE,
                            GL_CURRENT_PROGRAM,
                            GL_DEPTH_CLEAR_VALUE,
                            GL_DEPTH_FUNC,
                            GL_DEPTH_RANGE,
                            GL_DEPTH_TEST,
                            GL_DEPTH_WRITEMASK,
                            GL_DITHER,
                            GL_ELEMENT_ARRAY_BUFFER_BINDING,
                            GL_FRAMEBUFFER_BINDING,
                            GL_FRONT_FACE,
                            GL_GENERATE_MIPMAP_HINT,
                            GL_LINE_WIDTH,
                            GL_PACK_ALIGNMENT,
                            GL_POLYGON_OFFSET_FACTOR,
                            GL_POLYGON_OFFSET_FILL,
                            GL_POLYGON_OFFSET_UNITS,
                            GL_RENDERBUFFER_BINDING,
                            GL_SAMPLE_ALPHA_TO_COVERAGE,
                            GL_SAMPLE_COVERAGE,
                            GL_SAMPLE_COVERAGE_INVERT,
                            GL_SAMPLE_COVERAGE_VALUE,
                            GL_SCISSOR_BOX,
                            GL_SCISSOR_TEST,
                            GL_STENCIL_BACK_FAIL,
                            GL_STENCIL_BACK_FUNC,
                            GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                            GL_STENCIL_BACK_PASS_DEPTH_PASS,
                            GL_STENCIL_BACK_REF,
                            GL_STENCIL_BACK_VALUE_MASK,
                            GL_STENCIL_BACK_WRITEMASK,
                            GL_STENCIL_CLEAR_VALUE,
                            GL_STENCIL_FAIL,
                            GL_STENCIL_FUNC,
                            GL_STENCIL_PASS_DEPTH_FAIL,
                            GL_STENCIL_PASS_DEPTH_PASS,
                            GL_STENCIL_REF,
                            GL_STENCIL_TEST,
                            GL_STENCIL_VALUE_MASK,
                            GL_STENCIL_WRITEMASK,
                            GL_UNPACK_ALIGNMENT,
                            GL_VIEWPORT};
// State of ES 3: vertex array, samplers, framebuffers, pixel buffers, rows of pixels, two switches.
constexpr GLenum es3Asked[] = {0x85B5, 0x8CAA, 0x88ED, 0x88EF, 0x0CF2, 0x0CF3,
                               0x0CF4, 0x0D02, 0x0D03, 0x0D04, 0x8C89, 0x8D69};

using State = std::map<std::string, std::vector<float>>;

bool isEs3() {
    return std::string(reinterpret_cast<const char*>(glGetString(GL_VERSION)))
        .starts_with("OpenGL ES 3");
}

State stateNow() {
    State state;
    const auto ask = [&](GLenum name) {
        std::vector<float> values(4, 0.0f);
        glGetFloatv(name, values.data());
        state["state " + std::to_string(name)] = values;
    };
    for (const GLenum name : asked)
        ask(name);
    for (std::size_t i = 0; isEs3() && i < std::size(es3Asked); ++i)
        ask(es3Asked[i]);
    GLint active = 0, units = 0, attributes = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    for (GLint i = 0; i < units; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        for (const GLenum name : {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_CUBE_MAP, 0x8919}) {
            if (name == 0x8919 && !isEs3()) continue;
            GLint value = 0;
            glGetIntegerv(name, &value);
            state["unit " + std::to_string(i) + " " + std::to_string(name)] = {
                static_cast<float>(value)};
        }
    }
    glActiveTexture(static_cast<GLenum>(active));
    glGetIntegerv(GL_MAX_VERTEX_ATTRIBS, &attributes);
    for (GLint i = 0; i < attributes; ++i) {
        std::vector<float>& of = state["attribute " + std::to_string(i)];
        for (const GLenum name :
             {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE,
              GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_TYPE,
              GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING}) {
            GLint value = 0;
            glGetVertexAttribiv(static_cast<GLuint>(i), name, &value);
            of.push_back(static_cast<float>(value));
        }
        of.resize(of.size() + 4);
        glGetVertexAttribfv(static_cast<GLuint>(i), GL_CURRENT_VERTEX_ATTRIB, &of[of.size() - 4]);
        void* pointer = nullptr;
        glGetVertexAttribPointerv(static_cast<GLuint>(i), GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
        of.push_back(static_cast<float>(reinterpret_cast<std::uintptr_t>(pointer)));
    }
    return state;
}

/// Sets everything differently than in a fresh context.
void setOddly(const gl::HostFunctions& functions) {
    for (const GLenum name : {GL_BLEND, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL, GL_SCISSOR_TEST,
                              GL_STENCIL_TEST, GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE})
        glEnable(name);
    glDisable(GL_DITHER);
    glBlendColor(0.1f, 0.2f, 0.3f, 0.4f);
    glBlendFuncSeparate(GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA, GL_ZERO, GL_DST_ALPHA);
    glBlendEquationSeparate(GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT);
    glClearColor(0.5f, 0.25f, 0.75f, 1.0f);
    glClearDepthf(0.5f);
    glClearStencil(7);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glCullFace(GL_FRONT);
    glFrontFace(GL_CW);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    glDepthRangef(0.25f, 0.75f);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
    glPolygonOffset(3.0f, 5.0f);
    glSampleCoverage(0.5f, GL_TRUE);
    glScissor(3, 4, 5, 6);
    glViewport(7, 8, 9, 10);
    glStencilFuncSeparate(GL_FRONT, GL_LESS, 3, 0x0F);
    glStencilFuncSeparate(GL_BACK, GL_NEVER, 5, 0xF0);
    glStencilOpSeparate(GL_FRONT, GL_INVERT, GL_INCR, GL_DECR);
    glStencilOpSeparate(GL_BACK, GL_ZERO, GL_REPLACE, GL_INCR_WRAP);
    glStencilMaskSeparate(GL_FRONT, 0x3C);
    glStencilMaskSeparate(GL_BACK, 0xC3);
    GLuint buffers[3], textures[3], renderbuffer = 0;
    glGenBuffers(3, buffers);
    glGenTextures(3, textures);
    glGenRenderbuffers(1, &renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    if (functions.hasVertexArrays()) {
        GLuint arrays = 0;
        functions.genVertexArrays(1, &arrays);
        functions.bindVertexArray(arrays);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    for (GLuint i = 0; i < 4; ++i) {
        glVertexAttribPointer(i, 3, GL_SHORT, GL_TRUE, 12,
                              reinterpret_cast<const void*>(std::uintptr_t{4} * i));
        glVertexAttrib4f(i, 0.1f, 0.2f, 0.3f, 0.4f);
        if (i % 2 == 0) glEnableVertexAttribArray(i);
    }
    if (functions.divisor) functions.divisor(1, 2);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[2]);
    for (GLenum i = 0; i < 3; ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D, textures[i]);
    }
    glActiveTexture(GL_TEXTURE5);
    if (isEs3()) {
        glPixelStorei(0x0CF2, 3); // UNPACK_ROW_LENGTH
        glPixelStorei(0x0D04, 2); // PACK_SKIP_PIXELS
        glEnable(0x8C89);         // RASTERIZER_DISCARD
        glEnable(0x8D69);         // PRIMITIVE_RESTART_FIXED_INDEX
    }
}

class HostStates : public testing::TestWithParam<ShadowMasks::LookUp> {};

} // namespace

TEST_P(HostStates, AreLeftAsTheyWere) {
    const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};
    const Light light = pointLight({0.3, 4, 0.7});
    const Scene scene = yard().scene();
    const std::vector<std::uint8_t> expected = renderedMask(scene, corner, light);
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const gl::Capabilities& has = context.capabilities();
    setOddly(gl::HostFunctions::find(has.version, has.extensions, eglLookUp));
    const State before = stateNow();
    ASSERT_EQ(glGetError(), 0u);
    const MaskLight asked[] = {hostLight(sun({0.5, 1, -0.3})), hostLight(light)};
    std::vector<std::uint8_t> mask;
    {
        ShadowMasks masks(GetParam());
        EXPECT_EQ(stateNow(), before) << "after making it";
        masks.add(meshOf(*scene.batches.front().geometry));
        for (int frame = 0; frame < 2; ++frame) {
            masks.draw(viewOf(corner), asked);
            EXPECT_EQ(stateNow(), before) << "after drawing";
        }
        LookupWork work = masks.lookupWork(asked[0]);
        work.finish();
        const auto lookup = masks.addLookup(work);
        masks.uploadLookup(lookup);
        EXPECT_EQ(stateNow(), before) << "after a map was uploaded";
        masks.removeLookup(lookup);
        EXPECT_EQ(stateNow(), before) << "after it was removed";
        EXPECT_EQ(glGetError(), 0u);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        if (isEs3()) glPixelStorei(0x0D04, 0);
        mask = readMask(masks, 1);
        if (isEs3()) glPixelStorei(0x0D04, 2);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
    }
    EXPECT_EQ(stateNow(), before) << "after it is gone";
    EXPECT_EQ(mask, expected);
}

TEST_P(HostStates, AreLeftByAlphaTestsWithAHostsTexture) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    const gl::Capabilities& has = context.capabilities();
    const std::vector<std::uint8_t> texels = {255, 0, 0, 255, 0, 255, 0, 0};
    const gl::Texture texture = gl::makeTexture(texels, 2, 1, {33071, 33071, 9728, 9728});
    setOddly(gl::HostFunctions::find(has.version, has.extensions, eglLookUp));
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glActiveTexture(GL_TEXTURE0);
    const State before = stateNow();
    const MaskLight light = hostLight(sun({0.5, 1, -0.3}));
    const Scene scene = yard().scene();
    MaskMesh mesh = meshOf(*scene.batches.front().geometry);
    mesh.alphaTested = true;
    {
        ShadowMasks masks(GetParam());
        masks.setAlpha(masks.add(mesh), {.texture = texture.name()});
        EXPECT_EQ(stateNow(), before);
        masks.draw(viewOf({{5, 4, 6}, {0, 0.5, 0}, 50.0}), {&light, 1});
        EXPECT_EQ(stateNow(), before);
        EXPECT_EQ(glGetError(), 0u);
    }
    EXPECT_EQ(stateNow(), before);
    glActiveTexture(GL_TEXTURE1);
    for (const auto& [name, value] : {std::pair{GL_TEXTURE_MIN_FILTER, 9728},
                                      {GL_TEXTURE_MAG_FILTER, 9728},
                                      {GL_TEXTURE_WRAP_S, 33071},
                                      {GL_TEXTURE_WRAP_T, 33071}}) {
        GLint now = 0;
        glGetTexParameteriv(GL_TEXTURE_2D, static_cast<GLenum>(name), &now);
        EXPECT_EQ(now, value) << name;
    }
    EXPECT_TRUE(glIsTexture(texture.name()));
}

INSTANTIATE_TEST_SUITE_P(Arrays, HostStates, testing::Values(eglLookUp, lookUpWithoutArrays));

TEST(HostErrors, AreTold) {
    const gl::HeadlessContext context({hostWidth, hostHeight});
    ShadowMasks masks(eglLookUp);
    glEnable(0xFFFF);
    const MaskLight light;
    masks.draw(viewOf({{5, 4, 6}, {0, 0.5, 0}, 50.0}), {&light, 1});
    EXPECT_EQ(masks.cost().hostError, static_cast<unsigned>(GL_INVALID_ENUM));
}

} // namespace edgeshade
