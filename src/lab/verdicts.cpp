#include "src/lab/verdicts.hpp"

#include "preprocess/base/parallel.hpp"
#include "src/lab/tie.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace edgeshade::lab {
namespace {

constexpr int tolerance = 2; // of 255, in the image; fixed by `compare`

bool differs(const OraclePicture::Color& expected, std::span<const std::uint8_t> image,
             std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c)
        if (std::abs(expected[c] - image[4 * i + c]) > tolerance) return true;
    return false;
}

/// Whether answers differ within the 3x3 neighbourhood.
bool isNearBoundary(const std::vector<Answer>& answers, int width, int height, std::size_t i) {
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    for (int ny = std::max(0, y - 1); ny <= std::min(height - 1, y + 1); ++ny)
        for (int nx = std::max(0, x - 1); nx <= std::min(width - 1, x + 1); ++nx)
            if (!(answers[static_cast<std::size_t>(ny) * width + nx] == answers[i])) return true;
    return false;
}

std::vector<Verdict> judgedAgain(const Oracle& oracle, const std::vector<std::size_t>& pixels) {
    std::vector<Verdict> verdicts(pixels.size());
    inParallel(pixels.size(), {}, [&](std::size_t s) { verdicts[s] = judge(oracle, pixels[s]); });
    return verdicts;
}

/// A view's pictures and answers.
class View {
  public:
    View(const Oracle& oracle, const std::vector<Answer>& answers, const Pictures& pictures)
        : answers_(answers), pictures_(pictures), expected_(pictures.unshadowed, pictures.litAs),
          width_(oracle.question().width), height_(oracle.question().height) {
        follow();
    }

    /// Call this after answers have changed.
    void follow() { expected_.follow(answers_); }

    bool wrongInMask(std::size_t i) const {
        const bool surface = pictures_.mask[4 * i + 3] != 0;
        const bool lit = pictures_.mask[4 * i] != 0;
        const Answer& answer = answers_[i];
        return surface != answer.surface || (surface && lit != answer.lit.has(0));
    }

    bool wrongInImage(std::size_t i) const { return differs(expected_.at(i), pictures_.image, i); }

    bool nearBoundary(std::size_t i) const { return isNearBoundary(answers_, width_, height_, i); }

    PixelKind kindOfWrong(std::size_t i) const {
        const bool surface = pictures_.mask[4 * i + 3] != 0;
        if (surface != answers_[i].surface || !wrongInMask(i)) return PixelKind::otherwiseWrong;
        return pictures_.mask[4 * i] != 0 ? PixelKind::wronglyLit : PixelKind::wronglyDark;
    }

  private:
    const std::vector<Answer>& answers_;
    const Pictures& pictures_;
    OraclePicture expected_;
    int width_, height_;
};

} // namespace

const std::array<std::pair<const char*, std::size_t WrongCounts::*>, 10> WrongCounts::keys = {{
    {"pixels", &WrongCounts::pixels},
    {"visible_pixels", &WrongCounts::visiblePixels},
    {"wrong_mask_pixels", &WrongCounts::wrongMaskPixels},
    {"wrong_mask_beyond_1px", &WrongCounts::wrongMaskBeyond1px},
    {"wrong_image_pixels", &WrongCounts::wrongImagePixels},
    {"wrong_image_beyond_1px", &WrongCounts::wrongImageBeyond1px},
    {"tie_pixels", &WrongCounts::tiePixels},
    {"wrong_image_beyond_1px_not_tied", &WrongCounts::beyond1pxNotTied},
    {"device_tie_pixels", &WrongCounts::deviceTiePixels},
    {"wrong_image_beyond_1px_not_device_tied", &WrongCounts::beyond1pxNotDeviceTied},
}};

WrongCounts& WrongCounts::operator+=(const WrongCounts& other) {
    for (const auto& [key, count] : keys)
        this->*count += other.*count;
    return *this;
}

Comparison compareWithOracle(const Oracle& oracle, std::vector<Answer>& answers,
                             const Pictures& pictures, int subpixelBits) {
    View view(oracle, answers, pictures);
    const auto wrongPixels = [&] {
        std::vector<std::size_t> wrong;
        for (std::size_t i = 0; i < answers.size(); ++i)
            if (view.wrongInMask(i) || view.wrongInImage(i)) wrong.push_back(i);
        return wrong;
    };

    // Judges every disagreement that rounding may have caused again; settled ones are no errors.
    const std::vector<std::size_t> suspects = wrongPixels();
    const std::vector<Verdict> verdicts = judgedAgain(oracle, suspects);
    for (std::size_t s = 0; s < suspects.size(); ++s)
        answers[suspects[s]] = verdicts[s].answer;
    view.follow();

    struct Tie {
        bool coarsest = false, device = false; ///< whether it is a tie on that grid
    };
    std::vector<Tie> ties(suspects.size());
    inParallel(suspects.size(), {}, [&](std::size_t s) {
        const std::size_t i = suspects[s];
        if (!view.wrongInMask(i) && !view.wrongInImage(i)) return;
        const auto tiedOn = [&](double grid) { return isTie(oracle, i, verdicts[s], grid); };
        ties[s] = {tiedOn(coarsestGrid), tiedOn(std::ldexp(1.0, -subpixelBits))};
    });

    Comparison comparison;
    comparison.kinds.assign(answers.size(), PixelKind::right);
    WrongCounts& counts = comparison.counts;
    counts.pixels = answers.size();
    for (const Answer& answer : answers)
        counts.visiblePixels += answer.surface;
    for (std::size_t s = 0; s < suspects.size(); ++s) {
        const std::size_t i = suspects[s];
        const bool inMask = view.wrongInMask(i), inImage = view.wrongInImage(i);
        if (!inMask && !inImage) continue;
        const bool beyond = !view.nearBoundary(i), tie = ties[s].coarsest;
        counts.wrongMaskPixels += inMask;
        counts.wrongMaskBeyond1px += inMask && beyond;
        counts.wrongImagePixels += inImage;
        counts.wrongImageBeyond1px += inImage && beyond;
        counts.tiePixels += tie;
        counts.beyond1pxNotTied += inImage && beyond && !tie;
        counts.deviceTiePixels += ties[s].device;
        counts.beyond1pxNotDeviceTied += inImage && beyond && !ties[s].device;
        comparison.kinds[i] = tie ? PixelKind::tie : view.kindOfWrong(i);
    }
    return comparison;
}

WrongCounts countWrongImage(const Oracle& oracle, SettledAnswers& answers,
                            std::span<const std::uint8_t> image, OraclePicture& expected) {
    expected.follow(answers.answers);
    std::vector<std::size_t> wrong, suspects;
    for (std::size_t i = 0; i < answers.answers.size(); ++i) {
        if (!differs(expected.at(i), image, i)) continue;
        wrong.push_back(i);
        if (!answers.settled[i]) suspects.push_back(i);
    }
    const std::vector<Verdict> verdicts = judgedAgain(oracle, suspects);
    for (std::size_t s = 0; s < suspects.size(); ++s) {
        answers.answers[suspects[s]] = verdicts[s].answer;
        answers.settled[suspects[s]] = true;
    }
    if (!suspects.empty()) expected.follow(answers.answers);

    WrongCounts counts;
    counts.pixels = answers.answers.size();
    for (const Answer& answer : answers.answers)
        counts.visiblePixels += answer.surface;
    const Question& question = oracle.question();
    for (const std::size_t i : wrong) {
        if (!differs(expected.at(i), image, i)) continue;
        ++counts.wrongImagePixels;
        counts.wrongImageBeyond1px +=
            !isNearBoundary(answers.answers, question.width, question.height, i);
    }
    return counts;
}

} // namespace edgeshade::lab
