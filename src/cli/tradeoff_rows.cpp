#include "src/cli/tradeoff_rows.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/caster_variants.hpp"
#include "src/gl/headless_context.hpp"

#include <array>

namespace edgeshade::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The call's scene options except casters, for pasting.
std::string sceneOptionsOf(const TradeoffOptions& options) {
    return (options.cutoutsCast ? std::string(" --cast-cutouts") : std::string()) +
           (options.ground ? " --ground '" + textOf(*options.ground) + "'" : "") +
           (options.culls ? std::string(" --cull ") + (*options.culls ? "auto" : "off") : "") +
           (options.time ? " --time " + Json(*options.time).dump() : "") +
           (options.animation.empty() ? "" : " --animation " + Json(options.animation).dump());
}

} // namespace

std::vector<TradeRow> possibleRows(const TradeoffOptions& options, const LoadedScene& loaded,
                                   std::vector<std::string>& warnings) {
    std::vector<TradeSetting> all =
        tradeSettings(options.largestMap, worldBounds(loaded.scene).diagonal(),
                      requestFor(options.view, loaded.scene).lights);
    for (const std::string& text : options.against)
        all.push_back({text, text});
    CasterVariants variants(options.input, loaded);
    const std::string sceneOptions = sceneOptionsOf(options);
    const gl::HeadlessContext context({16, 16, 0, options.glLimits});
    std::vector<TradeRow> rows;
    for (const TradeSetting& setting : all) {
        TradeRow row;
        row.setting = setting;
        row.settings = settingsFrom(DrawSettings(), setting.text);
        if (loaded.scene.culls && drawOppositeVertices(std::array{row.settings})) {
            warnings.push_back(setting.name + " is left out: --cull auto does not go with it.");
            continue;
        }
        RenderSettings render = row.settings.render;
        render.layout = layoutFor(row.settings.instancing, context.capabilities());
        try {
            Renderer(render, context.capabilities());
            row.scene = variants.with(row.settings.casters);
            row.casters = variants.settingsWith(row.settings.casters);
            row.callsOptions = leftOptions(options.casters, row.settings.casters) + sceneOptions;
            rows.push_back(std::move(row));
        } catch (const Error& error) {
            if (error.status() != ExitStatus::unavailable) throw;
            warnings.push_back(setting.name + " is left out: " + error.what());
        }
    }
    return rows;
}

} // namespace edgeshade::cli
