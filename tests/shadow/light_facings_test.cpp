// Facings that follow a light (docs/method.md, C48): those of every place are the ones that a look
// from there alone finds.
#include "src/shadow/silhouette/light_facings.hpp"

#include "tests/support/small_soups.hpp"
#include "tests/support/soup_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;
using test::shadowOf;

glm::vec4 anyLight(Random& random) {
    const bool directional = random.below(3) == 0;
    return {glm::vec3(random.inCube() * random.magnitude(-2, 3)), directional ? 0.0f : 1.0f};
}

/// The light moved towards or away from some plane, to where rounding decides that plane's side.
glm::vec4 besidePlane(const PlanePairShadow& shadow, const LightBall& ball, int mantissaBits,
                      Random& random) {
    const auto caps = static_cast<int>(shadow.caps.size());
    const glm::dvec4 plane(shadow.caps[static_cast<std::size_t>(random.below(caps))].plane);
    const glm::dvec4 light(ball.center), terms = glm::abs(plane * light);
    const double share = dotRounding(mantissaBits);
    const double bound =
        ball.reach * (1.0 + 2.0 * share) + share * (terms.x + terms.y + terms.z + terms.w);
    const double side = (random.below(2) ? 1.0 : -1.0) * bound * random.uniform(0.0, 4.0);
    return {glm::vec3(glm::dvec3(light) - (glm::dot(plane, light) - side) * glm::dvec3(plane)),
            ball.center.w};
}

/// The next place of a light: as it was, a step of any length farther, beside a plane, or
/// elsewhere.
glm::vec4 nextPlace(const PlanePairShadow& shadow, const LightBall& ball, int mantissaBits,
                    Random& random) {
    switch (random.below(20)) {
    case 0:
        return anyLight(random);
    case 1:
        return ball.center;
    case 2:
    case 3:
    case 4:
        return besidePlane(shadow, ball, mantissaBits, random);
    default:
        return ball.center + glm::vec4(glm::vec3(random.inCube() * random.magnitude(-7, -1)), 0.0f);
    }
}

/// Counts what looks along a way do, run by run.
struct Looks {
    std::size_t runs = 0, skipped = 0, changed = 0;

    /// `before`: the facings of the last look; empty if there was none.
    void add(const FollowedFacings& followed, const std::vector<std::int8_t>& before) {
        for (std::size_t run = 0; run < followed.foundAt.size(); ++run) {
            ++runs;
            skipped += followed.foundAt[run] != followed.look;
            if (followed.changedAt[run] == followed.look) {
                ++changed;
                continue;
            }
            ASSERT_FALSE(before.empty());
            const auto first = static_cast<std::ptrdiff_t>(run * FollowedFacings::run);
            const auto end = first + static_cast<std::ptrdiff_t>(FollowedFacings::run);
            ASSERT_TRUE(std::equal(before.begin() + first, before.begin() + end,
                                   followed.facings.begin() + first));
        }
    }
};

void expectSame(const LightFacings& facings, const LightBall& ball, int mantissaBits,
                const FollowedFacings& followed) {
    std::vector<std::int8_t> found;
    facings.find(ball, mantissaBits, found);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), followed.facings.begin()));
}

TEST(FollowedFacings, AreThoseOfEachPlaceAlone) {
    Random random(53);
    Looks looks;
    for (int mesh = 0; mesh < 300; ++mesh) {
        const PlanePairShadow shadow = shadowOf(test::randomSoup(random, 20 + random.below(200)));
        if (shadow.caps.empty()) continue;
        const LightFacings facings(shadow);
        const int mantissaBits = mesh % 3 == 0 ? 10 : 23;
        FollowedFacings followed;
        LightBall ball{anyLight(random)};
        for (int place = 0; place < 200; ++place) {
            SCOPED_TRACE(testing::Message() << "mesh " << mesh << ", place " << place);
            if (random.below(4) == 0)
                ball.reach = static_cast<float>(random.below(2) * random.magnitude(-7, -2));
            ball.center = nextPlace(shadow, ball, mantissaBits, random);
            const std::vector<std::int8_t> before = followed.facings;
            facings.follow(ball, mantissaBits, followed);
            expectSame(facings, ball, mantissaBits, followed);
            looks.add(followed, before);
        }
    }
    EXPECT_GT(looks.skipped, looks.runs / 10);
    EXPECT_LT(looks.changed, looks.runs / 2);
}

TEST(FollowedFacings, AreFoundAnewAfterALightThatIsNoNumber) {
    const PlanePairShadow shadow = shadowOf(test::cube());
    const LightFacings facings(shadow);
    FollowedFacings followed;
    for (const glm::vec4& light :
         {glm::vec4(1, 2, 3, 1), glm::vec4(NAN, 0, 0, 1), glm::vec4(1, 2, 3, 1),
          glm::vec4(INFINITY, 0, 0, 0), glm::vec4(3e38f, 3e38f, 0, 0),
          glm::vec4(-1.03f, 2.11f, -2.97f, 0)}) {
        facings.follow({light}, 23, followed);
        expectSame(facings, {light}, 23, followed);
    }
    facings.follow({glm::vec4(-1.03f, 2.11f, -2.97f, 0)}, 23, followed);
    EXPECT_LT(followed.foundAt[0], followed.look) << "a new way begins after it";
}

} // namespace
} // namespace edgeshade
