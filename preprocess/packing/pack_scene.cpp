#include "edgeshade/packing.hpp"

#include "preprocess/packing/pack.hpp"

namespace edgeshade {

PackedScene packScene(const std::filesystem::path& file, const PackSettings& settings) {
    const auto require = [](bool holds, const char* what, double value) {
        if (!holds)
            throw InputError(std::string(what) + " is " + std::to_string(value) +
                             ", which is out of range.");
    };
    // These comparisons refuse NaN too.
    require(settings.weldTolerance >= 0.0, "weldTolerance", settings.weldTolerance);
    require(settings.casterError >= 0.0, "casterError", settings.casterError);
    require(settings.flatTolerance >= 0.0 && settings.flatTolerance < 45.0, "flatTolerance",
            settings.flatTolerance);
    CasterSettings casters;
    casters.weldTolerance = settings.weldTolerance;
    casters.autoWeld = settings.autoWeld;
    casters.castMasked = settings.castMasked;
    casters.casterError = settings.casterError;
    casters.flatTolerance = settings.flatTolerance;
    PackInput input = readForPacking(file, casters);
    PackedScene packed;
    packed.glb = packBytes(input, Encoding::none);
    const PackReport& report = input.report;
    packed.triangles = report.triangles;
    packed.casterTriangles = report.casters.triangles;
    packed.edges = report.casters.edges;
    packed.diagonal = report.diagonal;
    packed.warnings = report.warnings;
    return packed;
}

} // namespace edgeshade
