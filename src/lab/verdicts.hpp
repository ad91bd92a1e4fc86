#pragma once

#include "src/lab/exact_judge.hpp"
#include "src/lab/oracle_picture.hpp"
#include "src/lab/pictures.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade::lab {

/// What comparing pictures with the oracle finds: the contract's keys of `compare`.
struct WrongCounts {
    std::size_t pixels = 0;
    std::size_t visiblePixels = 0; ///< where the oracle sees a surface
    std::size_t wrongMaskPixels = 0;
    std::size_t wrongMaskBeyond1px = 0; ///< no oracle boundary in the 3x3 neighbourhood
    std::size_t wrongImagePixels = 0;
    std::size_t wrongImageBeyond1px = 0;
    std::size_t tiePixels = 0;        ///< of the wrong ones, in mask or image
    std::size_t beyond1pxNotTied = 0; ///< wrong in the image beyond 1 px and no tie
    // The same with ties on the device's own grid in place of the coarsest one:
    std::size_t deviceTiePixels = 0;
    std::size_t beyond1pxNotDeviceTied = 0;

    WrongCounts& operator+=(const WrongCounts& other);
};

/// What a pixel is, for the heat map.
enum class PixelKind : std::uint8_t { right, wronglyLit, wronglyDark, otherwiseWrong, tie };

struct Comparison {
    WrongCounts counts;
    std::vector<PixelKind> kinds; ///< one a pixel
};

/// Counts where the pictures disagree with the answers. Every pixel on which they do is judged
/// again, exactly unless rounding can't have changed the answer, and `answers` is corrected, before
/// anything is counted. `subpixelBits`: the device puts vertices on a grid of 2^-subpixelBits
/// pixels.
Comparison compareWithOracle(const Oracle& oracle, std::vector<Answer>& answers,
                             const Pictures& pictures, int subpixelBits);

/// Answers of one view, and which of them were judged again, exactly where need be.
struct SettledAnswers {
    SettledAnswers() = default;
    explicit SettledAnswers(std::vector<Answer> traced)
        : answers(std::move(traced)), settled(answers.size(), false) {}

    std::vector<Answer> answers;
    std::vector<bool> settled;
};

/// The same of an image alone, without ties: pixels, visiblePixels, wrongImagePixels and
/// wrongImageBeyond1px are counted. No pixel is judged again that was before. `expected`: the
/// picture that these answers make.
WrongCounts countWrongImage(const Oracle& oracle, SettledAnswers& answers,
                            std::span<const std::uint8_t> image, OraclePicture& expected);

} // namespace edgeshade::lab
