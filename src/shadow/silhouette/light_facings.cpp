#include "src/shadow/silhouette/light_facings.hpp"

#include "src/shadow/silhouette/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace edgeshade {
namespace {

using namespace silhouette;
using SmallInts = std::int8_t __attribute__((vector_size(lanes)));

/// Upper bound of a unit normal's length after rounding.
constexpr float longestNormal = 1.0f + 1e-5f;

/// Share of a light's coordinates up to which sums of its steps leave room for spare ways.
constexpr double longestWay = 0x1p30;

/// Tests the sides of planes that the lights of a ball are on, four planes at once.
class SideTest {
  public:
    SideTest(const LightBall& ball, int mantissaBits)
        : x_(all(ball.center.x)), y_(all(ball.center.y)), z_(all(ball.center.z)),
          w_(all(ball.center.w)), share_(static_cast<float>(dotRounding(mantissaBits))),
          // The terms of other lights of the ball sum to at most this much more.
          margin_((ball.radius * longestNormal + ball.reach) * (1.0f + 2.0f * share_) +
                  dotUnderflow(mantissaBits)),
          spareMargin_(margin_ + 2.0f * dotUnderflow(mantissaBits)) {}

    struct Sides {
        Floats side, terms;
    };
    Sides of(Floats x, Floats y, Floats z, Floats w) const {
        x *= x_;
        y *= y_;
        z *= z_;
        w *= w_;
        return {x + y + z + w, magnitude(x) + magnitude(y) + magnitude(z) + magnitude(w)};
    }
    SmallInts facings(const Sides& of) const {
        // Comparisons give -1 for true, and false for NaN and infinity against infinity.
        const Floats bound = all(margin_) + all(share_) * of.terms;
        return __builtin_convertvector((-of.side > bound) - (of.side > bound), SmallInts);
    }
    /// How far the light may go with the same facings; 0 if that isn't known.
    Floats spare(const Sides& of) const {
        const Floats known = magnitude(of.side) - spareMargin_ - all(4.0f * share_) * of.terms;
        return greater(known, all(0.0f));
    }

    float margin() const { return margin_; }
    float share() const { return share_; }

  private:
    Floats x_, y_, z_, w_;
    float share_, margin_, spareMargin_;
};

/// Lets the light go on to its next place.
void goOn(const SideTest& test, const glm::vec4& light, std::size_t runs,
          FollowedFacings& followed) {
    const glm::dvec3 step = glm::dvec3(light) - glm::dvec3(followed.light);
    const double changed =
        (1.0 + 4.0 * test.share()) * longestNormal * glm::length(step) +
        std::abs(static_cast<double>(test.margin()) - static_cast<double>(followed.margin));
    // No less than the exact sum.
    followed.way = (followed.way + changed * (1.0 + 0x1p-40)) * (1.0 + 0x1p-51);
    ++followed.look;
    const bool tooLong = !(followed.way <= longestWay * glm::length(glm::dvec4(light)));
    if (followed.look == 1 || light.w != followed.light.w || tooLong) {
        followed.way = 0.0;
        followed.holdsUntil.assign(runs, 0.0);
        followed.foundAt.resize(runs);
        followed.changedAt.resize(runs);
    }
    followed.light = light;
    followed.margin = test.margin();
}

} // namespace

LightFacings::LightFacings(const PlanePairShadow& shadow) : count_(shadow.caps.size()) {
    const std::size_t size = runCount() * FollowedFacings::run;
    for (auto* component : {&x_, &y_, &z_, &w_})
        component->resize(size, 0.0f);
    for (std::size_t i = 0; i < size; ++i) {
        const glm::vec4& plane = shadow.caps[std::min(i, count_ - 1)].plane;
        x_[i] = plane.x;
        y_[i] = plane.y;
        z_[i] = plane.z;
        w_[i] = plane.w;
    }
}

void LightFacings::find(const LightBall& ball, int mantissaBits,
                        std::vector<std::int8_t>& facings) const {
    facings.resize(x_.size());
    const SideTest test(ball, mantissaBits);
    for (std::size_t i = 0; i < x_.size(); i += lanes) {
        const SmallInts found =
            test.facings(test.of(load(x_, i), load(y_, i), load(z_, i), load(w_, i)));
        std::memcpy(facings.data() + i, &found, sizeof(found));
    }
    facings.resize(count_);
}

void LightFacings::follow(const LightBall& ball, int mantissaBits,
                          FollowedFacings& followed) const {
    const SideTest test(ball, mantissaBits);
    followed.facings.resize(x_.size());
    goOn(test, ball.center, runCount(), followed);
    constexpr std::size_t size = FollowedFacings::run;
    for (std::size_t run = 0; run < runCount(); ++run) {
        if (followed.holdsUntil[run] > followed.way) continue;
        std::array<std::int8_t, size> found;
        Floats least = all(INFINITY);
        for (std::size_t k = 0; k < size; k += lanes) {
            const std::size_t i = run * size + k;
            const auto sides = test.of(load(x_, i), load(y_, i), load(z_, i), load(w_, i));
            const SmallInts facings = test.facings(sides);
            std::memcpy(found.data() + k, &facings, sizeof(facings));
            least = lesser(test.spare(sides), least);
        }
        const double spare = std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
        followed.holdsUntil[run] = (followed.way + spare) * (1.0 - 0x1p-50);
        followed.foundAt[run] = followed.look;
        std::int8_t* const known = followed.facings.data() + run * size;
        if (std::memcmp(known, found.data(), size) == 0 && followed.look > 1) continue;
        std::memcpy(known, found.data(), size);
        followed.changedAt[run] = followed.look;
    }
}

} // namespace edgeshade
