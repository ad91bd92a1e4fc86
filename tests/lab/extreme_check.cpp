#include "tests/lab/extreme_check.hpp"

#include "src/lab/texture_alpha.hpp"

#include <iomanip>
#include <sstream>

namespace edgeshade::test {
namespace {

std::string row(const std::string& name, const std::string& provokes,
                const std::vector<std::string>& numbers) {
    std::ostringstream line;
    line << std::left << "[ extreme ] " << std::setw(44) << name << " | " << std::setw(46)
         << provokes << std::right;
    const int widths[] = {8, 6, 6, 24, 10};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        line << " | " << std::setw(widths[i]) << numbers[i];
    return line.str();
}

} // namespace

ExtremeOutcome check(const Extreme& extreme) {
    const LoadedScene scene = extreme.load();
    ExtremeOutcome outcome;
    outcome.triangles = scene.scene.triangleCount();
    outcome.openEdges = openEdgesOf(scene, extreme.lights);
    double near = 0.0;
    const lab::Pictures pictures = drawPictures(extreme, scene, near);
    const lab::Oracle oracle({&scene.scene, scene.settings.castMasked, extreme.camera, near,
                              extreme.lights, extreme.width, extreme.height},
                             lab::textureAlpha(scene));
    auto answers = lab::traceAll(oracle, {});
    outcome.counts = lab::compareWithOracle(oracle, answers, pictures).counts;
    return outcome;
}

std::string tableHead() {
    return row("case", "provokes",
               {"visible", "wrong", "ties", "beyond 1 px, not tied", "open edges"});
}

std::string tableRow(const Extreme& extreme, const ExtremeOutcome& outcome) {
    const lab::WrongCounts& counts = outcome.counts;
    return row(extreme.name, extreme.provokes,
               {std::to_string(counts.visiblePixels), std::to_string(counts.wrongImagePixels),
                std::to_string(counts.tiePixels), std::to_string(counts.beyond1pxNotTied),
                std::to_string(outcome.openEdges)});
}

} // namespace edgeshade::test
