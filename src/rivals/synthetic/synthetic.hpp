#pragma once

#include "src/gl/span_timer.hpp"
#include "src/rivals/published/volume_program.hpp"
#include "src/rivals/synthetic/equation_fit.hpp"
#include "src/rivals/synthetic/synthetic_mesh.hpp"

#include <functional>
#include <optional>
#include <string>

namespace edgeshade::bench {

/// Measurement of the silhouette evaluation alone (thesis, 6.3.3).
struct SyntheticTask {
    std::vector<std::size_t> edges{10'000, 20'000, 30'000, 40'000, 50'000,
                                   60'000, 70'000, 80'000, 90'000};
    std::vector<int> multiplicities{1, 2, 3, 4, 5, 6, 7, 8, 9}; ///< opposite vertices per edge
    int turns = 9; ///< turns over all numbers of edges: see timesInTurns()
    /// For the opposite-vertex layouts.
    MultiplicityMethod method = MultiplicityMethod::referenceEdge;
    std::optional<gl::Timing> timing; ///< null: bestTiming()
};

/// One cell of the table.
struct SyntheticRow {
    std::string layout;
    Silhouette silhouette = Silhouette::all;
    std::size_t edges = 0;
    int multiplicity = 0;
    double ms = 0.0;
};

/// The fit over the rows of one layout and silhouette.
struct SyntheticFit {
    std::string layout;
    Silhouette silhouette = Silhouette::all;
    EquationFit equation;
    double leastRSquared = 1.0; ///< of the lines time over edges, one per multiplicity
};

struct SyntheticReport {
    gl::Capabilities device;
    gl::Timing timing = gl::Timing::finish;
    std::vector<SyntheticRow> rows;
    std::vector<SyntheticFit> fits;
};

/// Draws the sides of synthetic meshes in every layout that the GL has, with degenerate output from
/// the vertex shader. `progress` receives the share done and a description. Throws Error.
SyntheticReport measureSynthetic(const SyntheticTask& task,
                                 const std::function<void(double, const std::string&)>& progress);

} // namespace edgeshade::bench
