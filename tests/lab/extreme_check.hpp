#pragma once

#include "src/lab/verdicts.hpp"
#include "src/rivals/published/volume_program.hpp"
#include "tests/lab/extreme.hpp"

namespace edgeshade::test {

/// What the checks of one case find.
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

/// Draws the case: with shadows, without, and its lit mask. `near`: set to the near plane used.
lab::Pictures drawPictures(const Extreme& extreme, const LoadedScene& scene,
                           const RenderSettings& settings, double& near);

/// Edges at which what sides and caps emit has a boundary; 0: the chain is closed. Small meshes
/// are tried triangle by triangle too, where an open chain counts as one edge more.
std::size_t openEdgesOf(const LoadedScene& scene, const std::vector<Light>& lights);

/// The table's head, and the case's rows.
std::string tableHead();
std::string tableRows(const Extreme& extreme, const ExtremeOutcome& outcome);

} // namespace edgeshade::test
