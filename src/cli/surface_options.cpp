#include "src/cli/surface_options.hpp"

#include "src/cli/add_options.hpp"

namespace edgeshade::cli {
namespace {

/// Options of pictures and of shadow volumes, which surfaces have no use for.
constexpr const char* ofPictures[] = {"--weld-tolerance",
                                      "--flat-tolerance",
                                      "--caster-error",
                                      "--size",
                                      "--camera",
                                      "--camera-from",
                                      "--camera-to",
                                      "--camera-matrix",
                                      "--fov",
                                      "--ortho",
                                      "--near",
                                      "--plan",
                                      "--cull",
                                      "--ground",
                                      "--section",
                                      "--section-box",
                                      "--section-fill",
                                      "--section-shadows",
                                      "--counts",
                                      "--at",
                                      "--gl-limits"};

} // namespace

nlohmann::ordered_json SurfaceOptions::json() const {
    return {{"grid", windows.empty() ? nlohmann::ordered_json(grid) : nullptr},
            {"offset", offset},
            {"unit", unit},
            {"nodes", nodes},
            {"materials", materials},
            {"windows", windows},
            {"sill", sill ? nlohmann::ordered_json(*sill) : nullptr},
            {"quantity",
             optionOf("sunhours", "--quantity").values.words.at(quantity == Quantity::directKwh)}};
}

void addSurfaceOptions(CLI::App& verb, SurfaceOptions& options) {
    CLI::Option* const surfaces = verb.add_flag("--surfaces", options.surfaces);
    for (const char* name : ofPictures)
        surfaces->excludes(verb.get_option(name));
    CLI::Option* const grid = addNumber(verb, "--grid", options.grid)->needs(surfaces);
    addNumber(verb, "--offset", options.offset)->needs(surfaces);
    addNumber(verb, "--unit", options.unit)->needs(surfaces);
    addTexts(verb, "--nodes", options.nodes)->needs(surfaces);
    addTexts(verb, "--materials", options.materials)->needs(surfaces);
    addTexts(verb, "--windows", options.windows)->needs(surfaces)->excludes(grid);
    addNumber(verb, "--sill", options.sill)->needs(verb.get_option("--windows"));
    verb.add_flag("--when", options.when)->needs(surfaces)->excludes(verb.get_option("--part"));
    addWords(verb, "--quantity", options.quantity,
             std::vector{Quantity::hours, Quantity::directKwh})
        ->needs(surfaces)
        ->needs(verb.get_option("--epw"));
}

} // namespace edgeshade::cli
