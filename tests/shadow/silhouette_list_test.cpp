// Lists of potential silhouettes (docs/method.md, C24): a record that is left out must have
// multiplicity 0 for every light of the ball.
#include "src/shadow/silhouette/plane_lanes.hpp"
#include "src/shadow/silhouette/potential_silhouettes.hpp"
#include "src/shadow/silhouette/silhouette_list.hpp"

#include "tests/support/plane_pair_chain.hpp"
#include "tests/support/rounded_arithmetic.hpp"
#include "tests/support/small_soups.hpp"
#include "tests/support/soup_shadow.hpp"

#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade {
namespace {

using test::Random;
using test::shadowOf;
using test::Soup;

SilhouetteList listFor(const PlanePairShadow& shadow, const LightBall& ball,
                       int mantissaBits = 23) {
    SilhouetteList proposal;
    ListMemory memory;
    listSilhouettes(shadow, LightFacings(shadow), ball, mantissaBits, proposal,
                    std::numeric_limits<double>::infinity(), memory);
    return proposal;
}

/// The planes of a list's uncertain pairs.
PlaneLanes planesOf(const PlanePairShadow& shadow, const SilhouetteList& list) {
    PlaneLanes planes;
    std::vector<std::uint8_t> taken;
    planes.gather(shadow, list.uncertain, taken);
    return planes;
}

/// A ball around or near the casters. Its centre is often on planes, edges and vertices, or a few
/// units in the last place beside them; its radius is any, or 0.
LightBall ballFor(const PlanePairShadow& shadow, Random& random) {
    const CapRecord& cap =
        shadow.caps[static_cast<std::size_t>(random.below(static_cast<int>(shadow.caps.size())))];
    const glm::dvec3 a(cap.a), b(cap.b), c(cap.c);
    const double size = std::max({glm::length(b - a), glm::length(c - a), 1e-30});
    const bool directional = random.below(3) == 0;
    glm::dvec3 at = directional ? glm::dvec3(0.0) : a;
    if (random.below(3) == 0) {
        at += random.inCube() * size * random.magnitude(-2, 4);
    } else {
        const double s = random.below(3) == 0 ? 0.0 : random.uniform(-2, 2);
        const double t = random.below(3) == 0 ? 0.0 : random.uniform(-2, 2);
        at += s * (b - a) + t * (c - a);
    }
    if (directional && glm::length(at) > 0.0 && random.below(2)) at = glm::normalize(at);
    LightBall ball;
    ball.center = glm::vec4(test::nudged(random, glm::vec3(at)), directional ? 0.0f : 1.0f);
    if (random.below(3) > 0)
        ball.radius = static_cast<float>(random.magnitude(-9, 1) *
                                         (directional ? glm::length(at) + 1e-6 : size));
    return ball;
}

/// A light of the ball, half of the time on its surface.
glm::vec4 lightIn(const LightBall& ball, Random& random) {
    for (int tries = 0; ball.radius > 0.0f && tries < 20; ++tries) {
        glm::dvec3 way = glm::normalize(random.inCube());
        if (random.below(2)) way *= random.uniform(0, 1);
        const glm::vec4 light(
            glm::vec3(glm::dvec3(ball.center) + way * (double(ball.radius) * (1.0 - 1e-6))),
            ball.center.w);
        if (ball.holds(light)) return light;
    }
    return ball.center;
}

/// A list's records of one cluster, in order.
class Listed {
  public:
    Listed(const PairList& list, std::size_t cluster)
        : list_(list), next_(list.ofCluster[cluster].first), end_(list.ofCluster[cluster].end()) {}

    bool takes(std::uint32_t pair) {
        if (isAtEnd() || list_.pairs[next_] != pair) return false;
        ++next_;
        return true;
    }
    bool isAtEnd() const { return next_ == end_; }

  private:
    const PairList& list_;
    std::uint32_t next_, end_;
};

/// Number of silhouettes that a proposal leaves out, for every way of counting that the cluster
/// allows, and of pairs that it wrongly marks as certain.
std::size_t missed(const PlanePairShadow& shadow, const SilhouetteList& proposal,
                   const glm::vec4& light, std::size_t& checked) {
    std::size_t wrong = 0;
    for (std::size_t c = 0; c < shadow.clusters.size(); ++c) {
        const ShadowCluster& cluster = shadow.clusters[c];
        Listed certain(proposal.certain, c), uncertain(proposal.uncertain, c);
        for (std::uint32_t i = cluster.pairs.first; i < cluster.pairs.end(); ++i) {
            const PairRecord& pair = shadow.pairs[i];
            if (certain.takes(i)) {
                wrong += std::abs(test::multiplicityOf(pair, light, test::countAll)) != 2;
                continue;
            }
            if (uncertain.takes(i)) continue;
            ++checked;
            wrong += test::multiplicityOf(pair, light, test::countAll) != 0;
            if (!cluster.closed) continue;
            wrong += test::multiplicityOf(pair, light, test::countLightFacing) != 0;
            wrong += test::multiplicityOf(pair, light, test::countFacingAway) != 0;
        }
        EXPECT_TRUE(certain.isAtEnd() && uncertain.isAtEnd()) << "the lists are out of order";
    }
    return wrong;
}

} // namespace

TEST(SilhouetteList, LeavesOutNoSilhouetteForAnyLightOfTheBall) {
    constexpr std::size_t leftOut = 100'000'000;
    Random random(17);
    std::size_t checked = 0, wrong = 0, all = 0, inNoPlane = 0;
    while (checked < leftOut) {
        const PlanePairShadow shadow = shadowOf(test::randomSoup(random, 20 + random.below(40)));
        if (shadow.pairs.empty()) continue;
        for (int ball = 0; ball < 20; ++ball) {
            const LightBall lights = ballFor(shadow, random);
            const SilhouetteList proposal = listFor(shadow, lights);
            const PlaneLanes planes = planesOf(shadow, proposal);
            for (int i = 0; i < 50; ++i) {
                const glm::vec4 light = lightIn(lights, random);
                wrong += missed(shadow, proposal, light, checked);
                all += shadow.pairs.size();
                if (planes.mayHold(light, 0.0f, 23)) continue;
                ++inNoPlane;
                wrong +=
                    std::any_of(shadow.pairs.begin(), shadow.pairs.end(), [&](const auto& pair) {
                        return std::abs(test::multiplicityOf(pair, light, test::countAll)) == 1;
                    });
            }
        }
    }
    std::cout << all << " records and lights, " << checked << " of them left out\n";
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(inNoPlane, 10'000u);
}

/// The lights of a ball on a device with 16 mantissa bits: the multiplicities that it would
/// compute.
template <rounded_arithmetic::Rounding rounding>
std::size_t missedWith16Bits(std::uint64_t seed, std::size_t leftOut) {
    using Shaders = rounded_arithmetic::Shaders<rounding>;
    Random random(seed);
    std::size_t checked = 0, wrong = 0;
    while (checked < leftOut) {
        const PlanePairShadow shadow = shadowOf(test::randomSoup(random, 20 + random.below(40)));
        if (shadow.pairs.empty()) continue;
        for (int i = 0; i < 20; ++i) {
            const LightBall ball = ballFor(shadow, random);
            const SilhouetteList proposal = listFor(shadow, ball, 16);
            const glm::vec4 lightAt = lightIn(ball, random);
            const typename Shaders::vec4 light(lightAt);
            std::vector<bool> certain(shadow.pairs.size()), uncertain(shadow.pairs.size());
            for (const std::uint32_t pair : proposal.certain.pairs)
                certain[pair] = true;
            for (const std::uint32_t pair : proposal.uncertain.pairs)
                uncertain[pair] = true;
            for (std::size_t p = 0; p < certain.size(); ++p) {
                if (uncertain[p]) continue;
                ++checked;
                typename Shaders::Plane shader;
                const auto side = [&](const glm::vec4& plane) {
                    return shader.planeSide(typename Shaders::vec4(plane), light, 0.0f).value();
                };
                const auto side0 = side(shadow.pairs[p].plane0);
                const auto side1 = side(shadow.pairs[p].plane1);
                wrong += certain[p] ? side0 == 0 || side0 + side1 != 0 : side0 != side1;
            }
            if (planesOf(shadow, proposal).mayHold(lightAt, 0.0f, 16)) continue;
            for (const std::uint32_t p : proposal.uncertain.pairs) {
                typename Shaders::Plane shader;
                for (const glm::vec4& plane : {shadow.pairs[p].plane0, shadow.pairs[p].plane1})
                    wrong +=
                        shader.planeSide(typename Shaders::vec4(plane), light, 0.0f).value() == 0;
            }
        }
    }
    return wrong;
}

/// As PlaneLanes::mayHold(), plane by plane.
bool mayBeInOne(const PlanePairShadow& shadow, const PairList& list, const glm::vec4& light,
                float reach, int mantissaBits) {
    const float share = static_cast<float>(dotRounding(mantissaBits));
    return std::any_of(list.pairs.begin(), list.pairs.end(), [&](std::uint32_t pair) {
        for (const glm::vec4& plane : {shadow.pairs[pair].plane0, shadow.pairs[pair].plane1}) {
            const glm::vec4 terms = plane * light, sizes = glm::abs(terms);
            const float side = terms.x + terms.y + terms.z + terms.w;
            const float size = sizes.x + sizes.y + sizes.z + sizes.w;
            if (!(std::abs(side) >
                  reach * (1.0f + share) + dotUnderflow(mantissaBits) + share * size))
                return true;
        }
        return false;
    });
}

TEST(PlaneLanes, HoldALightWhereASinglePlaneMay) {
    Random random(41);
    std::size_t in = 0, beside = 0;
    for (int i = 0; i < 3000; ++i) {
        const PlanePairShadow shadow = shadowOf(test::randomSoup(random, 3 + random.below(80)));
        PairList list;
        for (std::uint32_t pair = 0; pair < shadow.pairs.size(); ++pair)
            if (random.below(3) == 0) list.pairs.push_back(pair);
        SilhouetteList lists;
        lists.uncertain = list;
        const PlaneLanes planes = planesOf(shadow, lists);
        for (int l = 0; l < 20; ++l) {
            glm::vec4 light(glm::vec3(10.0 * random.inCube()), random.below(2));
            if (random.below(10) == 0) light *= 1e38f; // overflows
            if (random.below(10) == 0) light *= 1e-38f;
            if (!list.pairs.empty() && random.below(3) == 0)
                light = glm::vec4(shadow.pairs[list.pairs.front()].a, 1.0f);
            const float reach =
                random.below(2) ? 0.0f : static_cast<float>(random.magnitude(-6, 0));
            const int bits = random.below(2) ? 23 : 16;
            const bool wanted = mayBeInOne(shadow, list, light, reach, bits);
            ASSERT_EQ(planes.mayHold(light, reach, bits), wanted) << i << ", light " << l;
            ++(wanted ? in : beside);
        }
    }
    EXPECT_GT(in, 1000u);
    EXPECT_GT(beside, 1000u);
}

TEST(SilhouetteList, LeavesOutNoSilhouetteOnADeviceOf16Bits) {
    using rounded_arithmetic::Rounding;
    EXPECT_EQ(missedWith16Bits<Rounding::nearest>(18, 1'000'000), 0u);
    EXPECT_EQ(missedWith16Bits<Rounding::towardsZero>(19, 1'000'000), 0u);
    EXPECT_EQ(missedWith16Bits<Rounding::down>(20, 1'000'000), 0u);
}

TEST(SilhouetteList, OfALightAtRestIsNextToWhatItMust) {
    // A closed ball: exactly the records with a multiplicity are listed.
    Soup ball;
    constexpr int rings = 40, sectors = 80;
    for (int r = 0; r <= rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const double a = 3.14159265358979 * r / rings, b = 6.28318530717959 * s / sectors;
            ball.positions.emplace_back(std::sin(a) * std::cos(b), std::cos(a),
                                        std::sin(a) * std::sin(b));
        }
    for (std::uint32_t r = 0; r < rings; ++r)
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const std::uint32_t p = r * sectors + s, q = r * sectors + (s + 1) % sectors;
            ball.indices.insert(ball.indices.end(), {p, q, p + sectors});
            ball.indices.insert(ball.indices.end(), {q, q + sectors, p + sectors});
        }
    const PlanePairShadow shadow = shadowOf(ball);
    const glm::vec4 light(3, 2, 1, 1);
    std::size_t silhouettes = 0;
    for (const PairRecord& pair : shadow.pairs)
        silhouettes += test::multiplicityOf(pair, light, test::countAll) != 0;
    const std::size_t listed = listFor(shadow, {light, 0.0f}).size();
    EXPECT_EQ(listed, silhouettes);
    EXPECT_LT(10 * listed, shadow.pairs.size());
    const std::size_t ofBall = listFor(shadow, {light, 0.05f}).size();
    EXPECT_GT(ofBall, listed);
    EXPECT_LT(5 * ofBall, shadow.pairs.size());
}

TEST(SilhouetteList, KeepsMoreWhereFloatsHaveFewerBits) {
    const PlanePairShadow shadow = shadowOf(test::cube());
    // Next to the plane of a face, nearer than 16 bits can resolve.
    const LightBall ball{{0.5f, 1.00001f, 3.0f, 1.0f}, 0.0f};
    EXPECT_GT(listFor(shadow, ball, 16).size(), listFor(shadow, ball, 23).size());
}

TEST(SilhouetteList, OfWhatIsNotFiniteLeavesNothingOut) {
    const PlanePairShadow shadow = shadowOf(test::cube());
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float value : {infinity, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_EQ(listFor(shadow, {{value, value, -value, 1}, 0.0f}).size(), shadow.pairs.size());
}

TEST(PotentialSilhouettes, ForgetRecordsOfAPoseThatHasPassed) {
    const auto scene = std::make_shared<const int>(0);
    const glm::vec4 light(0, 5, 0, 1);
    PotentialSilhouettes silhouettes(23);
    auto shadow = std::make_shared<const PlanePairShadow>(shadowOf(test::cube()));
    for (int frame = 0; frame < 3; ++frame) {
        silhouettes.beginFrame(scene);
        EXPECT_GT(silhouettes.of({shadow}, light)->size(), 0u);
    }
    EXPECT_EQ(silhouettes.made(), 1u) << "nothing moved";
    const std::weak_ptr<const PlanePairShadow> passed = shadow;
    shadow = std::make_shared<const PlanePairShadow>(shadowOf(test::cube()));
    EXPECT_FALSE(passed.expired());
    silhouettes.beginFrame(scene);
    EXPECT_TRUE(passed.expired()) << "else every pose of the last frames stays in memory";
    silhouettes.of({shadow}, light);
    EXPECT_EQ(silhouettes.made(), 2u);
}

TEST(PotentialSilhouettes, ListNoMoreThanAFrameMay) {
    const glm::vec4 light(0, 5, 0, 1);
    const auto shadow = std::make_shared<const PlanePairShadow>(shadowOf(test::cube()));
    const auto other = std::make_shared<const PlanePairShadow>(shadowOf(test::cube()));
    PotentialSilhouettes silhouettes(23);
    const std::size_t records = shadow->pairs.size() + shadow->caps.size();
    silhouettes.beginFrame(nullptr, records);
    EXPECT_GT(silhouettes.of({shadow}, light)->size(), 0u);
    EXPECT_EQ(silhouettes.of({other}, light), nullptr);
    EXPECT_EQ(silhouettes.made(), 1u);
    silhouettes.beginFrame(nullptr, 1);
    EXPECT_GT(silhouettes.of({shadow}, light)->size(), 0u);
    EXPECT_GT(silhouettes.of({other}, light)->size(), 0u) << "those that are kept don't count";
    EXPECT_EQ(silhouettes.made(), 2u);
    silhouettes.beginFrame(nullptr, 0);
    EXPECT_EQ(silhouettes.of({shadow}, light), nullptr);
    silhouettes.beginFrame(nullptr);
    EXPECT_GT(silhouettes.of({shadow}, light)->size(), 0u);
    EXPECT_EQ(silhouettes.made(), 2u);
}

TEST(LightTrack, MakesNothingAnewForALightAtRest) {
    LightTrack track;
    const glm::vec4 light(1, 2, 3, 1);
    EXPECT_TRUE(track.follow(light));
    for (int i = 0; i < 5; ++i)
        EXPECT_FALSE(track.follow(light));
    EXPECT_EQ(track.ball().radius, 0.0f);
    EXPECT_TRUE(track.ball().holds(light));
}

TEST(LightTrack, GrowsWithTheLightsPaceAndShrinksWhenItRests) {
    LightTrack track;
    int made = 0;
    glm::vec4 light(0, 0, 0, 1);
    for (int i = 0; i < 100; ++i) {
        light.x += 0.1f;
        made += track.follow(light);
        EXPECT_TRUE(track.ball().holds(light));
    }
    EXPECT_LT(made, 30);
    EXPECT_GT(track.ball().radius, 0.0f);
    int atRest = 0;
    for (int i = 0; i < 10; ++i)
        atRest += track.follow(light);
    EXPECT_EQ(atRest, 1);
    EXPECT_EQ(track.ball().radius, 0.0f);
}

TEST(LightTrack, AJumpMakesNoBall) {
    LightTrack track;
    track.follow({0, 0, 0, 1});
    EXPECT_TRUE(track.follow({100, 0, 0, 1}));
    EXPECT_EQ(track.ball().radius, 0.0f);
    // Nor for a directional light in place of a point light.
    EXPECT_TRUE(track.follow({100, 0, 0, 0}));
    EXPECT_TRUE(track.ball().holds({100, 0, 0, 0}));
}

} // namespace edgeshade
