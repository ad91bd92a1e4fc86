#pragma once

#include "preprocess/packing/shadow_extension.hpp"
#include "preprocess/packing/weld_choice.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade {

/// Figures about a scene's shadow data, printed by `pack` and `info` under fixed keys.
struct PackReport {
    double diagonal = 0.0; ///< diagonal of the scene's bounds, scene units
    std::size_t batches = 0;
    std::size_t sharedMeshes = 0;            ///< kept once for several places
    std::size_t sharedPlaces = 0;            ///< places of shared meshes
    std::size_t triangles = 0;               ///< of all surfaces, with degenerate ones
    std::size_t singleSidedTriangles = 0;    ///< of these, those with single-sided materials
    std::size_t castingSurfaceTriangles = 0; ///< before simplification, with degenerate ones
    CasterSettings settings;                 ///< with the weld tolerance in use, given or chosen
    std::optional<WeldChoice> weldChoice;    ///< if the tolerance was to be chosen
    MeshStatistics casters;
    PlanePairCosts planePairs;
    int maxMultiplicity = 1;     ///< opposite vertices per record in `expanded`
    std::size_t storedBytes = 0; ///< of shadow data in the file
    std::size_t fileBytes = 0;
    double readSeconds = 0.0;
    BuildSeconds build;
    std::vector<std::string> variants; ///< names, in the document's order
    std::vector<AnimationTitle> animations;
    std::vector<SceneCamera> cameras; ///< in the scene's order
    std::vector<SceneLight> lights;   ///< in the scene's order
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

/// read -> flatten -> simplify -> weld -> edges -> count. `settings` may leave the choice of the
/// weld tolerance open. Throws InputError.
PackInput readForPacking(const std::filesystem::path& path, const CasterSettings& settings,
                         const ReadingLimits& limits = {});

/// As above for a file already read; its times exclude reading. `useStored`: reuse the simplified
/// casters of a file packed with the same settings.
PackInput readForPacking(GltfDocument document, const CasterSettings& wanted, bool useStored);

/// ... -> pack. Returns the packed file's bytes, made with the settings in `input.report`, and
/// completes that report.
Bytes packBytes(PackInput& input, Encoding encoding);

} // namespace edgeshade
