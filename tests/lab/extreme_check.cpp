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
    const int widths[] = {9, 8, 6, 6, 24, 10};
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
    RenderSettings byPlanes, toInfinity, byEdges, byMap;
    toInfinity.ends = VolumeEnds::atInfinity;
    byEdges.multiplicity = MultiplicityMethod::referenceEdge;
    byMap.shadows = ShadowMethod::primitiveMap;
    const lab::Pictures planePairs = drawPictures(extreme, scene, byPlanes, near);
    const lab::Pictures infinite = drawPictures(extreme, scene, toInfinity, near);
    const lab::Pictures oppositeVertices = drawPictures(extreme, scene, byEdges, near);
    const lab::Pictures lookedUp = drawPictures(extreme, scene, byMap, near);
    const lab::Oracle oracle({&scene.scene, scene.settings.castMasked,
                              standingBack(extreme.seen(), worldBounds(scene.scene)), near,
                              extreme.lights, extreme.width, extreme.height},
                             lab::textureAlpha(scene));
    auto answers = lab::traceAll(oracle, {});
    outcome.planePairs = lab::compareWithOracle(oracle, answers, planePairs, 8).counts;
    outcome.toInfinity = lab::compareWithOracle(oracle, answers, infinite, 8).counts;
    outcome.oppositeVertices = lab::compareWithOracle(oracle, answers, oppositeVertices, 8).counts;
    outcome.lookedUp = lab::compareWithOracle(oracle, answers, lookedUp, 8).counts;
    return outcome;
}

std::string tableHead() {
    return row("case", "provokes",
               {"layout", "visible", "wrong", "ties", "beyond 1 px, not tied", "open edges"});
}

namespace {

std::string rowOf(const std::string& name, const std::string& provokes, const std::string& layout,
                  const lab::WrongCounts& counts, const std::string& openEdges) {
    return row(name, provokes,
               {layout, std::to_string(counts.visiblePixels),
                std::to_string(counts.wrongImagePixels), std::to_string(counts.tiePixels),
                std::to_string(counts.beyond1pxNotTied), openEdges});
}

} // namespace

std::string tableRows(const Extreme& extreme, const ExtremeOutcome& outcome) {
    return rowOf(extreme.name, extreme.provokes, "adapted", outcome.planePairs,
                 std::to_string(outcome.openEdges)) +
           "\n" + rowOf("", "", "infinite", outcome.toInfinity, "") + "\n" +
           rowOf("", "", "published", outcome.oppositeVertices, "") + "\n" +
           rowOf("", "", "looked up", outcome.lookedUp, "");
}

} // namespace edgeshade::test
