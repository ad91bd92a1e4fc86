#pragma once

#include "src/lab/oracle.hpp"
#include "src/render/accumulation/lit_counter.hpp"

#include <memory>
#include <span>
#include <vector>

namespace edgeshade::lab {

/// Result of comparing counts of lit points with the oracle's.
struct WrongSums {
    std::size_t pixels = 0;
    std::size_t visiblePixels = 0; ///< where the oracle sees a surface
    std::size_t points = 0;        ///< the light's points, summed over all visible pixels
    std::size_t wrong = 0;         ///< points counted too many or too few, over all pixels
    std::size_t wrongPixels = 0;   ///< pixels with any wrong point
    std::size_t beyond1px = 0;     ///< of these, outside what the oracle counts in the 3x3 around
    std::size_t beyond1pxNotTied = 0; ///< of these, a tie for none of the points
    std::size_t largest = 0;          ///< most wrong points in one pixel

    double percent() const {
        return points == 0 ? 0.0 : 100.0 * static_cast<double>(wrong) / static_cast<double>(points);
    }
    WrongSums& operator+=(const WrongSums& other);
};

/// The oracle's answers per pixel for more lights than one Question can have.
class PointOracle {
  public:
    /// `question`: may have any number of lights. Traces all rays, on all cores. Throws Error.
    PointOracle(const Question& question, const AlphaLookup& alpha);

    /// Compares the oracle's counts of the first `lights` lights with a picture's. Disagreements
    /// are judged again, exactly unless rounding can't have changed the answer, and ties are
    /// identified.
    WrongSums compare(const LitCounts& drawn, std::size_t lights);

  private:
    struct Part {
        std::unique_ptr<Oracle> oracle; ///< for up to lightsOfAPart lights
        std::vector<Answer> answers;    ///< one per pixel
    };
    std::size_t countAt(std::size_t pixel, std::size_t lights) const;
    void judgeAgain(std::size_t pixel);
    bool isTied(std::size_t pixel, std::size_t lights) const;

    int width_, height_;
    std::vector<Part> parts_;
    std::vector<bool> judged_;
};

} // namespace edgeshade::lab
