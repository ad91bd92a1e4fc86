#pragma once

#include "src/lab/exact_judge.hpp"
#include "src/lab/oracle_picture.hpp"
#include "src/lab/pictures.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace edgeshade::lab {

/// Result of comparing pictures with the oracle, printed by `compare` under fixed keys.
struct WrongCounts {
    std::size_t pixels = 0;
    std::size_t visiblePixels = 0; ///< where the oracle sees a surface
    std::size_t wrongMaskPixels = 0;
    std::size_t wrongMaskBeyond1px = 0; ///< no oracle boundary in the 3x3 neighbourhood
    std::size_t wrongImagePixels = 0;
    std::size_t wrongImageBeyond1px = 0;
    std::size_t tiePixels = 0;        ///< of the wrong pixels, in mask or image
    std::size_t beyond1pxNotTied = 0; ///< wrong in the image beyond 1 px, and no tie
    // The same with ties on the device's own grid instead of the coarsest one:
    std::size_t deviceTiePixels = 0;
    std::size_t beyond1pxNotDeviceTied = 0;

    /// All counts, by their keys.
    static const std::array<std::pair<const char*, std::size_t WrongCounts::*>, 10> keys;

    WrongCounts& operator+=(const WrongCounts& other);
};

/// Kind of a pixel in the heat map.
enum class PixelKind : std::uint8_t { right, wronglyLit, wronglyDark, otherwiseWrong, tie };

struct Comparison {
    WrongCounts counts;
    std::vector<PixelKind> kinds; ///< one per pixel
};

/// Counts where the pictures disagree with the answers. First, every such pixel is judged again,
/// exactly unless rounding can't have changed the answer, and `answers` is corrected.
/// `subpixelBits`: the device puts vertices on a grid of 2^-subpixelBits pixels.
Comparison compareWithOracle(const Oracle& oracle, std::vector<Answer>& answers,
                             const Pictures& pictures, int subpixelBits);

/// Answers of one view, and which of them were judged again, exactly where necessary.
struct SettledAnswers {
    SettledAnswers() = default;
    explicit SettledAnswers(std::vector<Answer> traced)
        : answers(std::move(traced)), settled(answers.size(), false) {}

    std::vector<Answer> answers;
    std::vector<bool> settled;
};

/// As compareWithOracle(), for an image only and without ties. Counts pixels, visiblePixels,
/// wrongImagePixels and wrongImageBeyond1px. Judges each pixel again at most once. `expected`: the
/// picture for these answers.
WrongCounts countWrongImage(const Oracle& oracle, SettledAnswers& answers,
                            std::span<const std::uint8_t> image, OraclePicture& expected);

} // namespace edgeshade::lab
