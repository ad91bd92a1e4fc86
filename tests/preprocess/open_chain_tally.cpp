#include "open_chain_tally.hpp"

#include "tests/support/hard_lights.hpp"
#include "tests/support/shader_arithmetic.hpp"

namespace edgeshade::test {
namespace {

static_assert(OpenChainTally::kinds == lightKindCount);

using glm::vec3;
using glm::vec4;

// Sides and caps are two programs, so that the optimiser must neither merge their arithmetic here
// nor compile it at one site alone. Arguments go by reference: with vectors by value, the last of
// them on the stack, GCC 12.2 gave other counts at -O2 and -O3 than at -O0, and the same ones with
// -fno-ipa-modref.

/// A record of two opposite vertices, the second absent, as sides.vert sees it.
template <class Method>
[[gnu::noinline]] float sideMultiplicity(const vec3& a, const vec3& b, const vec4& opposite,
                                         const vec4& absent, const vec4& light) {
    Method method;
    return method.oppositeMultiplicity(a, b, opposite, light) +
           method.oppositeMultiplicity(a, b, absent, light);
}

template <class Method>
[[gnu::noinline]] float capFacing(const vec3& a, const vec3& b, const vec3& c, const vec4& light) {
    return Method{}.triangleSign(a, b, c, light);
}

vec4 withOrder(vec3 p, double order) {
    return {p, static_cast<float>(order)};
}

template <class Method>
bool isOpen(const Corners& p, const vec4& light) {
    const vec4 absent = withOrder(vec3(0.0f), ORDER_ABSENT);
    const float facing = capFacing<Method>(p[0], p[1], p[2], light);
    const float ab =
        sideMultiplicity<Method>(p[0], p[1], withOrder(p[2], ORDER_OPPOSITE_LAST), absent, light);
    const float ac = sideMultiplicity<Method>(p[0], p[2], withOrder(p[1], ORDER_OPPOSITE_BETWEEN),
                                              absent, light);
    const float bc =
        sideMultiplicity<Method>(p[1], p[2], withOrder(p[0], ORDER_OPPOSITE_FIRST), absent, light);
    return ab != facing || ac != -facing || bc != facing;
}

/// x y - x y is 0 unless only one of the two products is rounded. The compiler can't know that the
/// two are equal.
[[gnu::noinline]] bool contracts() {
    volatile float factor = 1.0f + 0x1p-12f;
    const float a = factor, b = factor, c = factor, d = -factor;
    const vec3 x(a, c, 0.0f), y(b, d, 0.0f);
    return shader_arithmetic::ReferenceEdge{}.orderedDot(x, y) != 0.0f;
}

} // namespace

std::array<bool, chainMethodCount> isOpenByMethod(const Corners& corners, const vec4& light) {
    using namespace shader_arithmetic;
    return {isOpen<ReferenceEdge>(corners, light), isOpen<ThreeEdge>(corners, light),
            isOpen<SingleEdge>(corners, light)};
}

OpenChainTally tallyOpenChains(std::uint64_t pairs, std::uint64_t seed) {
    OpenChainTally tally;
    tally.fused = contracts();
    Random random(seed);
    for (std::uint64_t i = 0; i < pairs; ++i) {
        const auto kind = static_cast<std::size_t>(i % lightKindCount);
        const Corners corners = randomTriangle(random);
        const vec4 light = randomLight(random, corners, static_cast<LightKind>(kind));
        const auto open = isOpenByMethod(corners, light);
        ++tally.pairs[kind];
        tally.casting[kind] += capFacing<shader_arithmetic::ReferenceEdge>(
                                   corners[0], corners[1], corners[2], light) != 0.0f;
        for (std::size_t method = 0; method < chainMethodCount; ++method)
            tally.open[method][kind] += open[method];
    }
    return tally;
}

} // namespace edgeshade::test
