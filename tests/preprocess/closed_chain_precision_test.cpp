// The closed chain on devices whose vertex stage has 16 mantissa bits, with any rounding: signs are
// less exact there, but still consistent (docs/method.md, C1).
#include "tests/support/hard_lights.hpp"
#include "tests/support/rounded_arithmetic.hpp"
#include "tests/support/shader_arithmetic.hpp"

#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade::test {
namespace {

using rounded_arithmetic::Rounding;

/// Whether edges and cap of one triangle disagree, see open_chain_tally.cpp.
template <class Shaders, class Method>
bool isOpen(const Corners& p, const glm::vec4& light) {
    using Vec3 = typename Shaders::vec3;
    using Vec4 = typename Shaders::vec4;
    Method method;
    const Vec4 lightHere(light);
    const Vec4 absent(glm::vec3(0.0f), ORDER_ABSENT);
    const auto side = [&](int a, int b, int o, double order) {
        const Vec3 low(p[static_cast<std::size_t>(a)]), high(p[static_cast<std::size_t>(b)]);
        const Vec4 opposite(p[static_cast<std::size_t>(o)], order);
        return method.oppositeMultiplicity(low, high, opposite, lightHere) +
               method.oppositeMultiplicity(low, high, absent, lightHere);
    };
    const auto facing = method.triangleSign(Vec3(p[0]), Vec3(p[1]), Vec3(p[2]), lightHere);
    return !(side(0, 1, 2, ORDER_OPPOSITE_LAST) == facing) ||
           !(side(0, 2, 1, ORDER_OPPOSITE_BETWEEN) == -facing) ||
           !(side(1, 2, 0, ORDER_OPPOSITE_FIRST) == facing);
}

struct PrecisionTally {
    std::uint64_t pairs = 0;
    std::uint64_t otherSigns = 0; ///< different from float32, by the reference edge
    std::uint64_t referenceEdge = 0, threeEdge = 0, singleEdge = 0; ///< open
    std::uint64_t planes = 0; ///< with a side that isn't the opposite of the negated plane's
};

template <Rounding rounding>
PrecisionTally tally(std::uint64_t pairs, std::uint64_t seed) {
    using Shaders = rounded_arithmetic::Shaders<rounding>;
    using Vec3 = typename Shaders::vec3;
    using Vec4 = typename Shaders::vec4;
    PrecisionTally result;
    result.pairs = pairs;
    Random random(seed);
    for (std::uint64_t i = 0; i < pairs; ++i) {
        const auto kind = static_cast<LightKind>(i % lightKindCount);
        const Corners p = randomTriangle(random);
        const glm::vec4 light = randomLight(random, p, kind);
        result.referenceEdge += isOpen<Shaders, typename Shaders::ReferenceEdge>(p, light);
        result.threeEdge += isOpen<Shaders, typename Shaders::ThreeEdge>(p, light);
        result.singleEdge += isOpen<Shaders, typename Shaders::SingleEdge>(p, light);
        const double sign = typename Shaders::ReferenceEdge{}
                                .triangleSign(Vec3(p[0]), Vec3(p[1]), Vec3(p[2]), Vec4(light))
                                .value();
        const float full = shader_arithmetic::ReferenceEdge{}.triangleSign(p[0], p[1], p[2], light);
        result.otherSigns += sign != static_cast<double>(full);
        const glm::vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        const glm::vec4 plane(normal, -glm::dot(normal, p[0]));
        // A record may hold a triangle's plane negated, if its edge runs the other way.
        typename Shaders::Plane planes;
        result.planes += !(planes.planeSide(Vec4(plane), Vec4(light), 0.0) ==
                           -planes.planeSide(Vec4(-plane), Vec4(light), 0.0));
    }
    return result;
}

void report(const char* rounding, const PrecisionTally& t) {
    std::cout << "[ 16 mantissa bits ] rounded " << rounding << ": " << t.pairs
              << " triangles with a light, " << t.otherSigns
              << " signs other than with 23; open: " << t.referenceEdge << " reference edge, "
              << t.threeEdge << " three edge, " << t.singleEdge << " single edge; " << t.planes
              << " planes\n";
}

constexpr std::uint64_t pairs = 280'000;

} // namespace

TEST(ClosedChainWith16MantissaBits, IsClosedHoweverTheDeviceRounds) {
    const PrecisionTally nearest = tally<Rounding::nearest>(pairs, 16);
    const PrecisionTally towardsZero = tally<Rounding::towardsZero>(pairs, 17);
    const PrecisionTally down = tally<Rounding::down>(pairs, 18);
    report("to nearest", nearest);
    report("towards zero", towardsZero);
    report("down", down);
    for (const PrecisionTally& t : {nearest, towardsZero, down}) {
        EXPECT_EQ(t.referenceEdge, 0u);
        EXPECT_EQ(t.threeEdge, 0u);
        // The lights are hard enough for a meaningful result.
        EXPECT_GT(t.singleEdge, t.pairs / 20);
        EXPECT_GT(t.otherSigns, t.pairs / 100);
    }
    // A device that rounds down would sometimes put a plane and its opposite on the same side. No
    // such device is known; the IEEE rounding modes of WebGL's devices are symmetric.
    EXPECT_EQ(nearest.planes, 0u);
    EXPECT_EQ(towardsZero.planes, 0u);
}

TEST(ClosedChainWith16MantissaBits, RoundingKeeps16Bits) {
    using Nearest = rounded_arithmetic::Number<Rounding::nearest>;
    using Zero = rounded_arithmetic::Number<Rounding::towardsZero>;
    using Down = rounded_arithmetic::Number<Rounding::down>;
    EXPECT_EQ(Nearest(1.0 + 0x1p-16).value(), 1.0 + 0x1p-16);
    EXPECT_EQ(Nearest(1.0 + 0x1p-17).value(), 1.0); // ties to even
    EXPECT_EQ(Nearest(1.0 + 0x1.8p-16).value(), 1.0 + 0x1p-15);
    EXPECT_EQ(Zero(-1.0 - 0x1.8p-16).value(), -1.0 - 0x1p-16);
    EXPECT_EQ(Down(-1.0 - 0x1.8p-16).value(), -1.0 - 0x1p-15);
    EXPECT_EQ(Down(1.0 + 0x1.8p-16).value(), 1.0 + 0x1p-16);
    EXPECT_EQ(Nearest(0x1p-63).value(), 0.0);
    EXPECT_EQ((Nearest(0x1p40) * Nearest(0x1p40)).value(), INFINITY);
}

} // namespace edgeshade::test
