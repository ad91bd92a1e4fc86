// Programs that the GL refuses: the sentence says which stage can't be compiled, or that linking
// fails.
#include "preprocess/base/error.hpp"
#include "src/gl/headless_context.hpp"
#include "src/gl/program.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr char vertex[] = "attribute vec4 a_position; void main() { gl_Position = a_position; }";
constexpr char fragment[] = "void main() { gl_FragColor = vec4(1.0); }";

std::string refusalOf(const char* vertexSource, const char* fragmentSource) {
    try {
        const gl::Program made(vertexSource, fragmentSource, {}, {"a_position"});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(Program, SaysWhatTheGlRefuses) {
    const gl::HeadlessContext context({8, 8});
    EXPECT_EQ(refusalOf(vertex, fragment), "");
    EXPECT_TRUE(refusalOf("void main() { gl_Position = nothing; }", fragment)
                    .starts_with("This GL can't compile a vertex shader"));
    EXPECT_TRUE(refusalOf(vertex, "void main() { gl_FragColor = nothing; }")
                    .starts_with("This GL can't compile a fragment shader"));
    EXPECT_TRUE(refusalOf(vertex, "varying mediump vec4 v_unset; void main() { gl_FragColor = "
                                  "v_unset; }")
                    .starts_with("This GL can't link a program"));
}

} // namespace edgeshade
