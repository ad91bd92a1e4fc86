// prepareToDraw() makes all programs that the first draw takes.
#include "tests/engine/masks_in_a_host.hpp"

#include <GLES2/gl2.h>
#include <gtest/gtest.h>
#include <string>

namespace {

std::string linked; ///< how the stages of the programs that were linked begin

} // namespace

/// Stands before the GL's own.
extern "C" GL_APICALL void GL_APIENTRY glLinkProgram(GLuint program) {
    GLuint stages[2];
    glGetAttachedShaders(program, 2, nullptr, stages);
    for (const GLuint stage : stages) {
        char source[400];
        glGetShaderSource(stage, sizeof source, nullptr, source);
        linked += std::string(source) + "\n---\n";
    }
    reinterpret_cast<void (*)(GLuint)>(edgeshade::test::eglLookUp("glLinkProgram"))(program);
}

namespace edgeshade {
namespace {

using namespace test;

const Camera corner{{5, 4, 6}, {0, 0.5, 0}, 50.0};

TEST(PreparedPrograms, AreAllThatTheFirstDrawTakes) {
    const Scene block = SceneBuilder().box({-0.5f, 0.0f, -0.5f}, {0.5f, 0.5f, 0.5f}).scene();
    const Scene sheet = SceneBuilder().floor(0.4f, 1.0f).scene();
    for (const Light& light : {spot(), sun({0.5, 1, -0.3}), pointLight({0.3, 4, 0.7})})
        for (const Scene* of : {&block, &sheet})
            for (const bool doubleSided : {false, true}) {
                const gl::HeadlessContext context({hostWidth, hostHeight});
                ShadowMasks masks(eglLookUp);
                const MaskLight asked = hostLight(light);
                MaskMesh mesh = meshOf(geometryOf(*of));
                mesh.doubleSided = doubleSided;
                const PreparedMesh prepared(mesh);
                masks.expect(prepared);
                linked.clear();
                EXPECT_TRUE(masks.prepareToDraw(viewOf(corner), {&asked, 1}));
                EXPECT_NE(linked, "");
                masks.add(PreparedMesh(meshOf(geometryOf(block))));
                masks.add(prepared);
                linked.clear();
                masks.draw(viewOf(corner), {&asked, 1});
                EXPECT_EQ(linked, "") << light.position.w << (of == &sheet ? " sheet" : " block")
                                      << (doubleSided ? ", both sides" : "");
            }
}

} // namespace
} // namespace edgeshade
