#include "tests/support/mask_case.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

Outcome compare(const std::vector<std::uint8_t>& mask, const std::vector<Answer>& answers) {
    Outcome outcome;
    for (int y = 0; y < maskHeight; ++y)
        for (int x = 0; x < maskWidth; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * maskWidth + x;
            const Answer drawn = mask[4 * i + 3] == 0 ? Answer::nothing
                                 : mask[4 * i] == 0   ? Answer::shadow
                                                      : Answer::lit;
            outcome.lit += answers[i] == Answer::lit;
            outcome.shadow += answers[i] == Answer::shadow;
            if (drawn == answers[i]) continue;
            ++outcome.wrong;
            if (!isFlat(answers, maskWidth, maskHeight, x, y)) continue;
            if (++outcome.wrongBeyondOnePixel <= 8)
                outcome.where += " (" + std::to_string(x) + ", " + std::to_string(y) + ") " +
                                 (drawn == Answer::nothing  ? "not drawn"
                                  : drawn == Answer::shadow ? "dark"
                                                            : "lit");
        }
    return outcome;
}

} // namespace

Outcome run(const Case& test, RenderSettings settings, bool nearDiscard, bool culledCaps) {
    TestView view{test.camera, {test.light}, maskWidth, maskHeight, true};
    if (test.near > 0.0) view.depth.near = test.near;
    view.depth.slices = test.slices;
    view.nearDiscard = nearDiscard;
    view.culledCaps = culledCaps;
    view.frustum = test.seen();
    return compare(drawScene(test.scene, view, settings, test.castMasked),
                   castMask(test.scene, standingBack(test.seen(), worldBounds(test.scene)),
                            test.light, maskWidth, maskHeight, test.near, test.castMasked));
}

namespace {

void expectNearlyRight(const Case& test, ShadowMethod method, const char* by) {
    RenderSettings settings;
    settings.shadows = method;
    const Outcome outcome = run(test, settings);
    // At contacts closer than float precision, points may be on either side.
    EXPECT_LE(outcome.wrongBeyondOnePixel, 1) << by << ":" << outcome.where;
    EXPECT_LE(outcome.wrong, maskWidth * maskHeight / 500) << by;
}

} // namespace

void expectRight(const Case& test) {
    for (const auto method : {MultiplicityMethod::plane, MultiplicityMethod::referenceEdge,
                              MultiplicityMethod::threeEdge})
        expectRight(test, method);
    if (testLimits() == gl::Limits::device) expectLookedUpRight(test);
    expectRightByPoints(test);
}

void expectLookedUpRight(const Case& test) {
    expectNearlyRight(test, ShadowMethod::primitiveMap, "by a primitive map");
}

void expectRightByPoints(const Case& test) {
    if (canAskPoints())
        expectNearlyRight(test, ShadowMethod::irregularZBuffer, "by an irregular z-buffer");
}

void expectRight(const Case& test, MultiplicityMethod method) {
    for (const auto layout :
         {SidesLayout::instanced, SidesLayout::multiDraw, SidesLayout::notInstanced}) {
        RenderSettings settings;
        settings.multiplicity = method;
        settings.layout = layout;
        const Outcome outcome = run(test, settings);
        EXPECT_EQ(outcome.wrongBeyondOnePixel, 0) << outcome.where;
        EXPECT_LE(outcome.wrong, maskWidth * maskHeight / 500);
        EXPECT_GT(outcome.shadow, 50) << "the case should have shadows";
    }
}

} // namespace edgeshade::test
