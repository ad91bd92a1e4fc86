#include "src/lab/point_counts.hpp"

#include "preprocess/base/parallel.hpp"
#include "src/lab/exact_judge.hpp"
#include "src/lab/tie.hpp"

#include <algorithm>

namespace edgeshade::lab {
namespace {

constexpr std::size_t lightsOfAPart = 64;

/// Number of lights, among the first `lights`, from this part's first light on.
std::size_t countingOf(std::size_t part, std::size_t lights) {
    const std::size_t first = part * lightsOfAPart;
    return lights <= first ? 0 : lights - first;
}

std::size_t apart(std::size_t a, std::size_t b) {
    return a > b ? a - b : b - a;
}

} // namespace

WrongSums& WrongSums::operator+=(const WrongSums& other) {
    pixels += other.pixels;
    visiblePixels += other.visiblePixels;
    points += other.points;
    wrong += other.wrong;
    wrongPixels += other.wrongPixels;
    beyond1px += other.beyond1px;
    beyond1pxNotTied += other.beyond1pxNotTied;
    largest = std::max(largest, other.largest);
    return *this;
}

PointOracle::PointOracle(const Question& question, const AlphaLookup& alpha)
    : width_(question.width), height_(question.height) {
    for (std::size_t first = 0; first < question.lights.size(); first += lightsOfAPart) {
        Question some = question;
        const std::size_t end = std::min(first + lightsOfAPart, question.lights.size());
        some.lights.assign(question.lights.begin() + static_cast<std::ptrdiff_t>(first),
                           question.lights.begin() + static_cast<std::ptrdiff_t>(end));
        Part& part = parts_.emplace_back();
        part.oracle = std::make_unique<Oracle>(some, alpha);
        part.answers = traceAll(*part.oracle);
    }
    judged_.assign(parts_.front().answers.size(), false);
}

std::size_t PointOracle::countAt(std::size_t pixel, std::size_t lights) const {
    std::size_t count = 0;
    for (std::size_t p = 0; p < parts_.size(); ++p)
        count += parts_[p].answers[pixel].lit.countOfFirst(countingOf(p, lights));
    return count;
}

void PointOracle::judgeAgain(std::size_t pixel) {
    for (Part& part : parts_)
        part.answers[pixel] = judge(*part.oracle, pixel).answer;
}

bool PointOracle::isTied(std::size_t pixel, std::size_t lights) const {
    for (std::size_t p = 0; p < parts_.size() && countingOf(p, lights) > 0; ++p) {
        const Oracle& oracle = *parts_[p].oracle;
        const glm::dvec2 center = centerOf(oracle.question(), pixel);
        const Verdict exact = judgeExactly(oracle, center.x, center.y);
        if (isTie(oracle, pixel, exact, coarsestGrid)) return true;
    }
    return false;
}

WrongSums PointOracle::compare(const LitCounts& drawn, std::size_t lights) {
    const std::size_t pixels = judged_.size();
    const auto surface = [&](std::size_t i) { return parts_.front().answers[i].surface; };
    const auto differs = [&](std::size_t i) {
        return (drawn.surface[i] != 0) != surface(i) || drawn.lit[i] != countAt(i, lights);
    };
    std::vector<std::size_t> suspects;
    for (std::size_t i = 0; i < pixels; ++i)
        if (differs(i)) suspects.push_back(i);
    std::vector<std::size_t> fresh;
    std::copy_if(suspects.begin(), suspects.end(), std::back_inserter(fresh),
                 [&](std::size_t i) { return !judged_[i]; });
    inParallel(fresh.size(), {}, [&](std::size_t s) { judgeAgain(fresh[s]); });
    for (const std::size_t i : fresh)
        judged_[i] = true;
    std::erase_if(suspects, [&](std::size_t i) { return !differs(i); });

    WrongSums sums;
    sums.pixels = pixels;
    for (std::size_t i = 0; i < pixels; ++i)
        sums.visiblePixels += surface(i);
    sums.points = sums.visiblePixels * lights;
    sums.wrongPixels = suspects.size();
    std::vector<std::size_t> beyond;
    for (const std::size_t i : suspects) {
        const std::size_t wrong = apart(drawn.lit[i], countAt(i, lights));
        sums.wrong += wrong;
        sums.largest = std::max(sums.largest, wrong);
        const int x = static_cast<int>(i) % width_, y = static_cast<int>(i) / width_;
        std::size_t least = lights, most = 0;
        bool edge = false;
        for (int ny = std::max(0, y - 1); ny <= std::min(height_ - 1, y + 1); ++ny)
            for (int nx = std::max(0, x - 1); nx <= std::min(width_ - 1, x + 1); ++nx) {
                const std::size_t n = static_cast<std::size_t>(ny) * width_ + nx;
                edge = edge || surface(n) != surface(i);
                least = std::min(least, countAt(n, lights));
                most = std::max(most, countAt(n, lights));
            }
        if (!edge && (drawn.lit[i] < least || drawn.lit[i] > most)) beyond.push_back(i);
    }
    sums.beyond1px = beyond.size();
    std::vector<char> tied(beyond.size());
    inParallel(beyond.size(), {}, [&](std::size_t b) { tied[b] = isTied(beyond[b], lights); });
    sums.beyond1pxNotTied = static_cast<std::size_t>(std::count(tied.begin(), tied.end(), 0));
    return sums;
}

} // namespace edgeshade::lab
