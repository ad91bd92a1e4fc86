// The state that each pass sets matches the table of docs/architecture.md.
#include "src/render/frame/pass_state.hpp"
#include "tests/support/headless.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace edgeshade {
namespace {

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

std::vector<int> colorMask() {
    std::array<GLboolean, 4> written{};
    glGetBooleanv(GL_COLOR_WRITEMASK, written.data());
    return {written.begin(), written.end()};
}

/// Sets state that differs from every pass's in everything that a pass sets.
void disorder() {
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glDepthMask(integer(GL_DEPTH_WRITEMASK) == 0);
    glDepthFunc(GL_NOTEQUAL);
    glBlendFuncSeparate(GL_SRC_COLOR, GL_DST_COLOR, GL_SRC_COLOR, GL_DST_COLOR);
    glStencilMask(0x0F);
    glStencilFunc(GL_GREATER, 7, 0x3C);
    glStencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
    for (const GLenum test : {GL_DEPTH_TEST, GL_BLEND, GL_STENCIL_TEST})
        if (glIsEnabled(test))
            glDisable(test);
        else
            glEnable(test);
}

void expectSet(const PassState& state) {
    disorder();
    set(state);
    const std::vector<int> written(state.color.begin(), state.color.end());
    EXPECT_EQ(colorMask(), written);
    EXPECT_EQ(integer(GL_DEPTH_WRITEMASK), state.depthWrites ? 1 : 0);
    EXPECT_EQ(glIsEnabled(GL_DEPTH_TEST), state.depth.has_value());
    if (state.depth) {
        EXPECT_EQ(integer(GL_DEPTH_FUNC), static_cast<GLint>(*state.depth));
    }
    EXPECT_EQ(glIsEnabled(GL_BLEND), state.blend.has_value());
    if (state.blend) {
        EXPECT_EQ(integer(GL_BLEND_SRC_RGB), static_cast<GLint>(state.blend->source));
        EXPECT_EQ(integer(GL_BLEND_DST_RGB), static_cast<GLint>(state.blend->target));
        EXPECT_EQ(integer(GL_BLEND_SRC_ALPHA), static_cast<GLint>(state.blend->alphaSource));
        EXPECT_EQ(integer(GL_BLEND_DST_ALPHA), static_cast<GLint>(state.blend->alphaTarget));
    }
    EXPECT_EQ(glIsEnabled(GL_STENCIL_TEST), state.stencil.has_value());
    if (!state.stencil) return;
    EXPECT_EQ(integer(GL_STENCIL_WRITEMASK) & 0xFF, 0xFF);
    EXPECT_EQ(integer(GL_STENCIL_FUNC), static_cast<GLint>(state.stencil->function));
    EXPECT_EQ(integer(GL_STENCIL_REF), 0);
    EXPECT_EQ(integer(GL_STENCIL_VALUE_MASK) & 0xFF, 0xFF);
    EXPECT_EQ(integer(GL_STENCIL_FAIL), GL_KEEP);
    EXPECT_EQ(integer(GL_STENCIL_PASS_DEPTH_FAIL), GL_KEEP);
    EXPECT_EQ(integer(GL_STENCIL_PASS_DEPTH_PASS), static_cast<GLint>(state.stencil->then));
}

TEST(PassState, IsSetWhateverWasBefore) {
    const gl::HeadlessContext context(test::testPicture(4, 4));
    for (int again = 0; again < 2; ++again) { // from both positions of each switch
        for (const PassState& state :
             {passes::surfaces, passes::counting, passes::ambientInShadow, passes::alpha,
              passes::addingLight(false, false), passes::addingLight(true, false),
              passes::addingLight(false, true), passes::addingLight(true, true),
              passes::seeThrough(false, false), passes::seeThrough(false, true),
              passes::seeThrough(true, true)})
            expectSet(state);
        disorder();
    }
}

TEST(PassState, OfThePassesIsTheTables) {
    EXPECT_TRUE(passes::surfaces.depthWrites);
    EXPECT_EQ(passes::surfaces.depth, GLenum{GL_LESS});
    EXPECT_FALSE(passes::surfaces.blend || passes::surfaces.stencil);
    EXPECT_EQ(passes::counting.color, (std::array{false, false, false, false}));
    EXPECT_FALSE(passes::counting.depthWrites);
    EXPECT_EQ(passes::counting.stencil->function, GLenum{GL_ALWAYS});
    EXPECT_EQ(passes::ambientInShadow.depth, GLenum{GL_EQUAL});
    EXPECT_EQ(passes::ambientInShadow.stencil->function, GLenum{GL_NOTEQUAL});
    EXPECT_EQ(passes::ambientInShadow.stencil->then, GLenum{GL_ZERO});
    for (const bool marked : {false, true})
        for (const bool replaces : {false, true}) {
            const PassState lit = passes::addingLight(marked, replaces);
            EXPECT_EQ(lit.depth, GLenum{GL_EQUAL});
            EXPECT_EQ(lit.stencil->function, GLenum{GL_EQUAL});
            EXPECT_EQ(lit.stencil->then, GLenum{GL_INCR});
            EXPECT_EQ(lit.blend->source, marked ? GLenum{GL_DST_ALPHA} : GLenum{GL_ONE});
            EXPECT_EQ(lit.blend->target, !replaces ? GLenum{GL_ONE}
                                         : marked  ? GLenum{GL_ONE_MINUS_DST_ALPHA}
                                                   : GLenum{GL_ZERO});
            EXPECT_EQ(lit.blend->alphaTarget, GLenum{GL_ONE});
        }
    EXPECT_EQ(passes::alpha.color, (std::array{false, false, false, true}));
}

} // namespace
} // namespace edgeshade
