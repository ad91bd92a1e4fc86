#pragma once

#include "src/lab/verdicts.hpp"
#include "src/rivals/published/volume_program.hpp"
#include "tests/lab/extreme.hpp"

namespace edgeshade::test {

/// Findings of the checks of one case.
struct ExtremeOutcome {
    std::size_t triangles = 0;
    struct Way {
        std::string name;
        lab::WrongCounts counts;
    };
    std::vector<Way> ways;     ///< of drawing the case
    std::size_t openEdges = 0; ///< over all lights, by planes, reference edges and three edges
};

ExtremeOutcome check(const Extreme& extreme);

/// Draws the case with shadows, without, and as a lit mask. `near` is set to the near plane used.
lab::Pictures drawPictures(const Extreme& extreme, const LoadedScene& scene,
                           const RenderSettings& settings, double& near);

/// Number of edges at which the emitted sides and caps have a boundary; 0: the chain is closed.
/// Small meshes are also tried triangle by triangle, where an open chain counts as one more edge.
std::size_t openEdgesOf(const LoadedScene& scene, const std::vector<Light>& lights);

/// The table's heading, and the case's rows.
std::string tableHead();
std::string tableRows(const Extreme& extreme, const ExtremeOutcome& outcome);

} // namespace edgeshade::test
