#pragma once

#include "preprocess/packing/shadow_extension.hpp"
#include "preprocess/packing/weld_choice.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade {

/// Figures about a scene's shadow data: the contract's keys of `pack` and `info`.
struct PackReport {
    double diagonal = 0.0; ///< of the scene's bounds, scene units
    std::size_t batches = 0;
    std::size_t sharedMeshes = 0;            ///< kept once for several places
    std::size_t sharedPlaces = 0;            ///< of these
    std::size_t triangles = 0;               ///< of all surfaces, degenerate ones included
    std::size_t singleSidedTriangles = 0;    ///< of these, those of materials not double-sided
    std::size_t castingSurfaceTriangles = 0; ///< before casters are simplified, likewise
    CasterSettings settings;                 ///< with the weld tolerance that was chosen, if it was
    std::optional<WeldChoice> weldChoice;    ///< where it was to be chosen
    MeshStatistics casters;
    PlanePairCosts planePairs;
    int maxMultiplicity = 1;     ///< opposite vertices a record, as `expanded` stores them
    std::size_t storedBytes = 0; ///< of shadow data in the file
    std::size_t fileBytes = 0;
    double readSeconds = 0.0;
    BuildSeconds build;
    std::vector<std::string> variants; ///< names, as the document lists them
    std::vector<AnimationTitle> animations;
    std::vector<SceneCamera> cameras; ///< as the scene has them
    std::vector<SceneLight> lights;   ///< likewise
    std::vector<std::string> warnings;
};

nlohmann::ordered_json toJson(const PackReport& report);

/// A scene read from a file, with the topology of its casters.
struct PackInput {
    GltfDocument document;
    Scene scene;
    Topologies topology;
    PackReport report;
};

/// read -> flatten -> simplify -> weld -> edges -> count. `settings` may leave the weld tolerance
/// to be chosen. Throws InputError.
PackInput readForPacking(const std::filesystem::path& path, const CasterSettings& settings,
                         const ReadingLimits& limits = {});

/// The same of a file that was read already; reading is not in its times. `useStored`: simplified
/// casters of a file that was packed with these settings are taken as they are.
PackInput readForPacking(GltfDocument document, const CasterSettings& wanted, bool useStored);

/// ... -> pack. The packed file's bytes, with the settings of `input.report`, which it completes.
Bytes packBytes(PackInput& input, Encoding encoding);

} // namespace edgeshade
