#pragma once

#include "src/lab/oracle.hpp"
#include "src/render/accumulation/lit_counter.hpp"

#include <memory>
#include <span>
#include <vector>

namespace edgeshade::lab {

/// What comparing counts of lit points with the oracle's finds.
struct WrongSums {
    std::size_t pixels = 0;
    std::size_t visiblePixels = 0; ///< where the oracle sees a surface
    std::size_t points = 0;        ///< of all visible pixels together, the light's points for each
    std::size_t wrong = 0;         ///< points counted too often or too seldom, over all pixels
    std::size_t wrongPixels = 0;   ///< with any
    std::size_t beyond1px = 0;     ///< of those, outside what the oracle counts in the 3x3 around
    std::size_t beyond1pxNotTied = 0; ///< of those, no tie for any of the points
    std::size_t largest = 0;          ///< points wrong in one pixel

    double percent() const {
        return points == 0 ? 0.0 : 100.0 * static_cast<double>(wrong) / static_cast<double>(points);
    }
    WrongSums& operator+=(const WrongSums& other);
};

/// The oracle's answers for more lights than one Question has, pixel by pixel.
class PointOracle {
  public:
    /// `question`: its lights may be as many as wanted. Traces all rays, on all cores. Throws
    /// Error.
    PointOracle(const Question& question, const AlphaLookup& alpha);

    /// Counts of the first `lights` of its lights, against a picture's. What disagrees is judged
    /// again, exactly unless rounding can't have changed the answer, and ties are found.
    WrongSums compare(const LitCounts& drawn, std::size_t lights);

  private:
    struct Part {
        std::unique_ptr<Oracle> oracle; ///< of up to lightsOfAPart lights
        std::vector<Answer> answers;    ///< a pixel each
    };
    std::size_t countAt(std::size_t pixel, std::size_t lights) const;
    void judgeAgain(std::size_t pixel);
    bool isTied(std::size_t pixel, std::size_t lights) const;

    int width_, height_;
    std::vector<Part> parts_;
    std::vector<bool> judged_;
};

} // namespace edgeshade::lab
