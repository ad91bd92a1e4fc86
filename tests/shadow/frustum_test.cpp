// Frusta from other engines' matrices: what they show, and which are refused.

#include "src/shadow/view/frustum.hpp"

#include "preprocess/base/error.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>

namespace edgeshade {
namespace {

/// Normalised device x and y.
glm::dvec2 projected(const glm::dmat4& clipFromWorld, const glm::dvec3& point) {
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(point, 1.0);
    return glm::dvec2(clip) / clip.w;
}

void expectSamePicture(const glm::dmat4& view, const glm::dmat4& projection) {
    const Frustum frustum = frustumOf(view, projection);
    const glm::dmat4 ours = clipFromView(frustum, 0.1, 100.0) * frustum.viewFromWorld;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-5.0, 5.0);
    int seen = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 point(uniform(random), uniform(random), uniform(random));
        if ((view * glm::dvec4(point, 1.0)).z > -0.1) continue;
        ++seen;
        const glm::dvec2 wanted = projected(projection * view, point);
        EXPECT_LT(glm::distance(projected(ours, point), wanted),
                  1e-9 * (1.0 + glm::length(wanted)));
    }
    EXPECT_GT(seen, 100);
}

std::string refusalOf(const glm::dmat4& view, const glm::dmat4& projection) {
    try {
        frustumOf(view, projection);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::usage);
        return error.what();
    }
    return "";
}

const glm::dmat4 rolled = glm::rotate(glm::dmat4(1.0), 0.4, {0, 0, 1}) *
                          glm::lookAt(glm::dvec3(4, 3, 6), glm::dvec3(0), glm::dvec3(0, 1, 0));

TEST(Frustum, ShowsWhatAnotherEnginesMatricesDo) {
    expectSamePicture(rolled, glm::perspective(0.8, 1.6, 0.1, 50.0));
    expectSamePicture(rolled, glm::infinitePerspective(1.2, 0.7, 0.01));
    expectSamePicture(rolled, glm::frustum(-0.03, 0.11, -0.08, -0.01, 0.1, 20.0)); // off-axis
    expectSamePicture(rolled, glm::ortho(-3.0, 1.0, 0.5, 2.0, 0.1, 30.0));
    const glm::dmat4 larger = glm::scale(glm::dmat4(1.0), glm::dvec3(7.0)) * rolled;
    expectSamePicture(larger, glm::perspective(0.8, 1.6, 0.1, 50.0));
    expectSamePicture(larger, glm::ortho(-3.0, 1.0, 0.5, 2.0, 0.1, 300.0));
}

TEST(Frustum, KnowsWhereItsRaysComeFrom) {
    const Frustum eye = frustumOf(rolled, glm::perspective(0.8, 1.6, 0.1, 50.0));
    EXPECT_LT(glm::distance(eye.eye(), glm::dvec4(4, 3, 6, 1)), 1e-12);
    EXPECT_LT(glm::distance(eye.forward(), -glm::normalize(glm::dvec3(4, 3, 6))), 1e-12);
    const Frustum parallel = frustumOf(rolled, glm::ortho(-1.0, 1.0, -1.0, 1.0));
    EXPECT_LT(glm::distance(parallel.eye(), glm::dvec4(glm::normalize(glm::dvec3(4, 3, 6)), 0)),
              1e-12);
}

TEST(Frustum, RefusesMatricesThatAreNoneWithASentence) {
    const glm::dmat4 lens = glm::perspective(0.8, 1.6, 0.1, 50.0);
    EXPECT_NE(refusalOf(glm::scale(rolled, glm::dvec3(1, 2, 1)), lens).find("shears or scales"),
              std::string::npos);
    EXPECT_NE(refusalOf(glm::scale(rolled, glm::dvec3(1, 1, -1)), lens).find("mirrors"),
              std::string::npos);
    EXPECT_NE(refusalOf(glm::dmat4(0.0), lens).find("last row"), std::string::npos);
    EXPECT_NE(refusalOf(glm::transpose(rolled), lens).find("last row"), std::string::npos);
    glm::dmat4 infinite = rolled;
    infinite[1][1] = INFINITY;
    EXPECT_NE(refusalOf(infinite, lens).find("not finite"), std::string::npos);
    EXPECT_NE(refusalOf(rolled, glm::dmat4(0.0)).find("projection"), std::string::npos);
    EXPECT_NE(refusalOf(rolled, glm::rotate(lens, 0.3, {0, 0, 1})).find("rotates"),
              std::string::npos);
    EXPECT_NE(
        refusalOf(rolled, glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)) * lens).find("mirrors"),
        std::string::npos);
    EXPECT_NE(refusalOf(rolled, glm::rotate(lens, 0.3, {1, 0, 0})).find("last row"),
              std::string::npos);
}

TEST(Frustum, StandsBackFarEnoughAndShowsTheSame) {
    Box box;
    box.add({-3, -2, -8});
    box.add({5, 2, 9});
    const Frustum frustum = frustumOf(rolled, glm::ortho(-3.0, 1.0, 0.5, 2.0));
    const Frustum back = standingBack(frustum, box);
    EXPECT_LT(depthOf(frustum, box.corner(5)), 0.0);
    for (int i = 0; i < 8; ++i) {
        EXPECT_GT(depthOf(back, box.corner(i)), 0.0);
        EXPECT_LT(
            glm::distance(
                projected(clipFromView(frustum, 0.1, 50.0) * frustum.viewFromWorld, box.corner(i)),
                projected(clipFromView(back, 0.1, 50.0) * back.viewFromWorld, box.corner(i))),
            1e-12);
    }
    const Frustum eye = frustumOf(rolled, glm::perspective(0.8, 1.6, 0.1, 50.0));
    EXPECT_EQ(standingBack(eye, box).viewFromWorld, eye.viewFromWorld);
}

} // namespace
} // namespace edgeshade
