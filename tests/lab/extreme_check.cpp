#include "tests/lab/extreme_check.hpp"

#include "src/lab/texture_alpha.hpp"
#include "src/rivals/rivals.hpp"
#include "tests/support/headless.hpp"

#include <iomanip>
#include <sstream>

namespace edgeshade::test {
namespace {

std::string row(const std::string& name, const std::string& provokes,
                const std::vector<std::string>& numbers) {
    std::ostringstream line;
    line << std::left << "[ extreme ] " << std::setw(44) << name << " | " << std::setw(46)
         << provokes << std::right;
    const int widths[] = {9, 8, 6, 6, 24, 10};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        line << " | " << std::setw(widths[i]) << numbers[i];
    return line.str();
}

/// Ways of drawing a case, and their names.
std::vector<std::pair<const char*, RenderSettings>> waysToDraw() {
    RenderSettings byPlanes, byEdges, byMap, byPoints;
    byEdges.multiplicity = MultiplicityMethod::referenceEdge;
    byEdges.rivals = &allRivals();
    byMap.shadows = ShadowMethod::primitiveMap;
    byPoints.shadows = ShadowMethod::irregularZBuffer;
    std::vector<std::pair<const char*, RenderSettings>> ways = {
        {"adapted", byPlanes}, {"published", byEdges}, {"looked up", byMap}};
    if (canAskPoints()) ways.emplace_back("irregular", byPoints);
    return ways;
}

} // namespace

ExtremeOutcome check(const Extreme& extreme) {
    const LoadedScene scene = extreme.load();
    ExtremeOutcome outcome;
    outcome.triangles = scene.scene.triangleCount();
    outcome.openEdges = openEdgesOf(scene, extreme.lights);
    double near = 0.0;
    std::vector<lab::Pictures> pictures;
    for (const auto& [name, settings] : waysToDraw()) {
        outcome.ways.push_back({name, {}});
        pictures.push_back(drawPictures(extreme, scene, settings, near));
    }
    const lab::Oracle oracle({&scene.scene, scene.settings.castMasked,
                              standingBack(extreme.seen(), worldBounds(scene.scene)), near,
                              extreme.lights, extreme.width, extreme.height},
                             lab::textureAlpha(scene));
    auto answers = lab::traceAll(oracle);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        outcome.ways[i].counts = lab::compareWithOracle(oracle, answers, pictures[i], 8).counts;
    return outcome;
}

std::string tableHead() {
    return row("case", "provokes",
               {"layout", "visible", "wrong", "ties", "beyond 1 px, not tied", "open edges"});
}

std::string tableRows(const Extreme& extreme, const ExtremeOutcome& outcome) {
    std::string rows;
    for (const auto& [name, counts] : outcome.ways) {
        const bool first = rows.empty();
        if (!first) rows += "\n";
        rows += row(first ? extreme.name : "", first ? extreme.provokes : "",
                    {name, std::to_string(counts.visiblePixels),
                     std::to_string(counts.wrongImagePixels), std::to_string(counts.tiePixels),
                     std::to_string(counts.beyond1pxNotTied),
                     first ? std::to_string(outcome.openEdges) : ""});
    }
    return rows;
}

} // namespace edgeshade::test
