#include "src/rivals/synthetic/synthetic.hpp"

#include "preprocess/base/error.hpp"
#include "src/bench/statistics.hpp"
#include "src/gl/headless_context.hpp"
#include "src/rivals/synthetic/synthetic_layouts.hpp"

#include <algorithm>
#include <GLES2/gl2.h>
#include <map>

namespace edgeshade::bench {
namespace {

constexpr int pictureSize = 64; // nothing is drawn into it

const char* nameOf(Silhouette silhouette) {
    return silhouette == Silhouette::all ? "all silhouette" : "none silhouette";
}

/// Milliseconds of a draw, by number of edges. Small numbers are drawn several times in a row, so
/// that every measurement takes about as long, and disturbances hit it as often.
std::map<std::size_t, double> timesOf(SyntheticSubject& subject, const SyntheticTask& task,
                                      gl::SpanTimer& timer) {
    const std::size_t most = *std::max_element(task.edges.begin(), task.edges.end());
    const auto drawsOf = [&](std::size_t i) {
        return (most + task.edges[i] / 2) / task.edges[i]; // rounded
    };
    const auto measure = [&](std::size_t i) -> std::optional<double> {
        timer.begin(0);
        for (std::size_t draw = 0; draw < drawsOf(i); ++draw)
            subject.draw(task.edges[i]);
        timer.end();
        const auto spans = timer.takeAll();
        if (spans.front().disturbed) return std::nullopt;
        return spans.front().milliseconds;
    };
    for (std::size_t i = 0; i < task.edges.size(); ++i)
        measure(i); // warms up
    const auto times = timesInTurns(task.edges.size(), task.turns, measure);
    gl::requireNoError("evaluating synthetic edges");
    if (times.empty())
        throw Error(ExitStatus::unavailable,
                    "The GPU's timer is disjoint in every turn; '--timing finish' needs no timer.");
    std::map<std::size_t, double> perDraw;
    for (std::size_t i = 0; i < times.size(); ++i)
        perDraw[task.edges[i]] = times[i] / static_cast<double>(drawsOf(i));
    return perDraw;
}

SyntheticFit fitOf(const std::vector<SyntheticRow>& rows, const SyntheticTask& task) {
    SyntheticFit fit{rows.front().layout, rows.front().silhouette, {}, 1.0};
    std::vector<EvaluationTime> times;
    for (const SyntheticRow& row : rows)
        times.push_back(
            {1e-3 * static_cast<double>(row.edges), static_cast<double>(row.multiplicity), row.ms});
    fit.equation = fitEquation(times);
    for (const int multiplicity : task.multiplicities) {
        std::vector<double> edges, ms;
        for (const SyntheticRow& row : rows)
            if (row.multiplicity == multiplicity) {
                edges.push_back(static_cast<double>(row.edges));
                ms.push_back(row.ms);
            }
        fit.leastRSquared = std::min(fit.leastRSquared, fittedLine(edges, ms).rSquared);
    }
    return fit;
}

} // namespace

SyntheticReport measureSynthetic(const SyntheticTask& task,
                                 const std::function<void(double, const std::string&)>& progress) {
    const gl::HeadlessContext context({pictureSize, pictureSize});
    gl::SpanTimer timer(task.timing.value_or(gl::bestTiming(context.capabilities())),
                        context.capabilities());
    glViewport(0, 0, pictureSize, pictureSize);
    glDisable(GL_CULL_FACE);
    SyntheticReport report{context.capabilities(), timer.timing(), {}, {}};
    const auto layouts = syntheticLayouts(task.method, context.capabilities());
    const std::size_t most = *std::max_element(task.edges.begin(), task.edges.end());
    const double steps = 2.0 * static_cast<double>(layouts.size() * task.multiplicities.size());
    int done = 0;
    for (const SyntheticLayout& layout : layouts)
        for (const Silhouette silhouette : {Silhouette::all, Silhouette::none}) {
            std::vector<SyntheticRow> rows;
            for (const int multiplicity : task.multiplicities) {
                progress(done++ / steps, layout.name + ", " + nameOf(silhouette) +
                                             ", multiplicity " + std::to_string(multiplicity));
                const auto subject =
                    layout.upload(syntheticMesh(most, multiplicity, silhouette), multiplicity);
                for (const auto& [edges, ms] : timesOf(*subject, task, timer))
                    rows.push_back({layout.name, silhouette, edges, multiplicity, ms});
            }
            report.fits.push_back(fitOf(rows, task));
            report.rows.insert(report.rows.end(), rows.begin(), rows.end());
        }
    progress(1.0, "done");
    return report;
}

} // namespace edgeshade::bench
