#include "src/cli/synthetic_report.hpp"

#include "src/cli/bench_report.hpp"

#include <iomanip>
#include <set>
#include <sstream>

namespace edgeshade::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* silhouetteName(bench::Silhouette silhouette) {
    return silhouette == bench::Silhouette::all ? "all" : "none";
}

Json fitJson(const bench::SyntheticFit& fit) {
    Json json;
    for (std::size_t i = 0; i < fit.equation.k.size(); ++i)
        json["k" + std::to_string(i)] = fit.equation.k[i];
    json["mwse_percent"] = fit.equation.mwsePercent;
    json["linear_r_squared"] = fit.leastRSquared;
    return json;
}

bool belongs(const bench::SyntheticRow& row, const bench::SyntheticFit& fit) {
    return row.layout == fit.layout && row.silhouette == fit.silhouette;
}

void addTable(std::ostream& text, const bench::SyntheticReport& report,
              const bench::SyntheticFit& fit) {
    std::set<int> multiplicities;
    std::set<std::size_t> edges;
    for (const bench::SyntheticRow& row : report.rows)
        if (belongs(row, fit)) {
            multiplicities.insert(row.multiplicity);
            edges.insert(row.edges);
        }
    text << fit.layout << ", " << silhouetteName(fit.silhouette)
         << " silhouette edges; ms by opposite vertices per edge\n"
         << std::setw(8) << "edges";
    for (const int m : multiplicities)
        text << std::setw(10) << m;
    text << "\n" << std::fixed << std::setprecision(3);
    for (const std::size_t e : edges) {
        text << std::setw(8) << e;
        for (const int m : multiplicities)
            for (const bench::SyntheticRow& row : report.rows)
                if (belongs(row, fit) && row.edges == e && row.multiplicity == m)
                    text << std::setw(10) << row.ms;
        text << "\n";
    }
    const auto& k = fit.equation.k;
    text << std::setprecision(5) << "(" << k[0] << " m^2 + " << k[2] << " m + " << k[4]
         << ") e/1000 + (" << k[1] << " m^2 + " << k[3] << " m + " << k[5] << ") ms; mean error "
         << std::setprecision(2) << fit.equation.mwsePercent
         << " %, linear in edges with R^2 >= " << std::setprecision(4) << fit.leastRSquared << "\n";
}

} // namespace

std::string syntheticTable(const bench::SyntheticReport& report) {
    std::ostringstream text;
    text << "Evaluating edges only, minimum of several draws, timed by " << nameOf(report.timing)
         << ", " << report.device.renderer << "\n";
    for (const bench::SyntheticFit& fit : report.fits) {
        text << "\n";
        addTable(text, report, fit);
    }
    std::string table = text.str();
    table.pop_back();
    return table;
}

Json syntheticJson(const bench::SyntheticReport& report, MultiplicityMethod method) {
    Json rows = Json::array(), fits = Json::array();
    for (const bench::SyntheticRow& row : report.rows)
        rows.push_back({{"edges", row.edges},
                        {"multiplicity", row.multiplicity},
                        {"layout", row.layout},
                        {"silhouette", silhouetteName(row.silhouette)},
                        {"ms", row.ms}});
    for (const bench::SyntheticFit& fit : report.fits) {
        Json json = {{"layout", fit.layout}, {"silhouette", silhouetteName(fit.silhouette)}};
        json.update(fitJson(fit));
        fits.push_back(std::move(json));
    }
    DrawSettings settings;
    settings.render.multiplicity = method;
    return {{"device", deviceJson(report.device)},
            {"timing", nameOf(report.timing)},
            {"settings", {{"multiplicity", settingsJson(settings)["multiplicity"]}}},
            {"rows", rows},
            {"fit", fitJson(report.fits.front())},
            {"fits", fits}};
}

} // namespace edgeshade::cli
