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

/// The answers of rays.
std::vector<Answer> answersTo(const Case& test) {
    return castMask(test.scene, standingBack(test.seen(), worldBounds(test.scene)), test.light,
                    maskWidth, maskHeight, test.near, test.castMasked);
}

std::vector<std::uint8_t> maskOf(const Case& test, const RenderSettings& settings,
                                 bool nearDiscard = true, bool culledCaps = true) {
    TestView view{test.camera, {test.light}, maskWidth, maskHeight, true};
    if (test.near > 0.0) view.depth.near = test.near;
    view.depth.slices = test.slices;
    view.nearDiscard = nearDiscard;
    view.culledCaps = culledCaps;
    view.frustum = test.seen();
    return drawScene(test.scene, view, settings, test.castMasked);
}

/// A case, and what rays see of it.
struct Judged {
    explicit Judged(const Case& of) : test(of), answers(answersTo(of)) {}

    const Case& test;
    std::vector<Answer> answers;
};

void expectNearlyRight(const Judged& of, ShadowMethod method, const char* by) {
    RenderSettings settings;
    settings.shadows = method;
    const Outcome outcome = compare(maskOf(of.test, settings), of.answers);
    // At contacts closer than float precision, points may be on either side.
    EXPECT_LE(outcome.wrongBeyondOnePixel, 1) << by << ":" << outcome.where;
    EXPECT_LE(outcome.wrong, maskWidth * maskHeight / 500) << by;
}

void expectLookedUpRight(const Judged& of) {
    expectNearlyRight(of, ShadowMethod::primitiveMap, "by a primitive map");
}

void expectRightByPoints(const Judged& of) {
    if (canAskPoints())
        expectNearlyRight(of, ShadowMethod::irregularZBuffer, "by an irregular z-buffer");
}

void expectRight(const Judged& of, MultiplicityMethod method) {
    for (const auto layout :
         {SidesLayout::instanced, SidesLayout::multiDraw, SidesLayout::notInstanced}) {
        RenderSettings settings;
        settings.multiplicity = method;
        settings.layout = layout;
        const Outcome outcome = compare(maskOf(of.test, settings), of.answers);
        EXPECT_EQ(outcome.wrongBeyondOnePixel, 0) << outcome.where;
        EXPECT_LE(outcome.wrong, maskWidth * maskHeight / 500);
        EXPECT_GT(outcome.shadow, 50) << "the case should have shadows";
    }
}

} // namespace

Outcome run(const Case& test, RenderSettings settings, bool nearDiscard, bool culledCaps) {
    return compare(maskOf(test, settings, nearDiscard, culledCaps), answersTo(test));
}

void expectRight(const Case& test) {
    const Judged judged(test);
    for (const auto method : {MultiplicityMethod::plane, MultiplicityMethod::referenceEdge,
                              MultiplicityMethod::threeEdge})
        expectRight(judged, method);
    if (testLimits() == gl::Limits::device) expectLookedUpRight(judged);
    expectRightByPoints(judged);
}

void expectLookedUpRight(const Case& test) {
    expectLookedUpRight(Judged(test));
}

void expectRight(const Case& test, MultiplicityMethod method) {
    expectRight(Judged(test), method);
}

} // namespace edgeshade::test
