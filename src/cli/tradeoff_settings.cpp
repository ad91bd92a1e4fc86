#include "src/cli/tradeoff_settings.hpp"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

namespace edgeshade::cli {

namespace {

/// Three significant digits, in the form that options take.
std::string shortNumber(double value) {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
}

/// Adds coarser casters, with errors as shares of the scene's diagonal and in degrees.
void addCasters(std::vector<TradeSetting>& settings, double diagonal) {
    if (diagonal > 0.0) {
        for (const double percent : {0.05, 0.2, 1.0})
            settings.push_back(
                {"casters " + shortNumber(percent) + " % off",
                 "shadows=volumes,caster-error=" + shortNumber(0.01 * percent * diagonal)});
        settings.push_back({"welded within 0.01 %",
                            "shadows=volumes,weld-tolerance=" + shortNumber(1e-4 * diagonal)});
    }
    for (const double degrees : {0.1, 1.0, 5.0})
        settings.push_back({"flat within " + shortNumber(degrees) + " deg",
                            "shadows=volumes,flat-tolerance=" + shortNumber(degrees)});
}

/// Adds maps of other kinds and with other filters, coarse and fine.
void addMapKinds(std::vector<TradeSetting>& settings, int largestMap,
                 std::span<const Light> lights) {
    const auto isSun = [](const Light& light) { return light.position.w == 0.0; };
    for (const int size : {512, 2048}) {
        if (size > largestMap) continue;
        const std::string number = std::to_string(size), map = "shadows=map,map-size=" + number;
        if (std::ranges::any_of(lights, isSun)) {
            settings.push_back({"cascades 4 x " + number, map + ",map-kind=cascades"});
            settings.push_back({"rectilinear " + number, map + ",map-kind=warped"});
            settings.push_back(
                {"non-orthogonal " + number, map + ",map-kind=warped,warp=non-orthogonal"});
        }
        if (!std::ranges::all_of(lights, isSun))
            settings.push_back({"paraboloid " + number, map + ",map-kind=paraboloid"});
        for (const char* filter : {"poisson", "vsm", "esm", "msm"})
            settings.push_back({std::string(filter) + " " + number, map + ",filter=" + filter});
    }
}

/// Adds shadows for only the most important lights, if there are more than a few.
void addShadowedLights(std::vector<TradeSetting>& settings, std::size_t lights) {
    constexpr std::size_t few = 4;
    for (std::size_t most = 1; lights > few && most < lights; most *= 4) {
        const std::string number = std::to_string(most);
        settings.push_back({number + (most == 1 ? " shadowed light" : " shadowed lights"),
                            "shadows=volumes,shadowed-lights=" + number});
    }
}

} // namespace

std::vector<TradeSetting> tradeSettings(int largestMap, double diagonal,
                                        std::span<const Light> lights) {
    std::vector<TradeSetting> settings = {
        {"volumes", "shadows=volumes"},
        {"primitive map", "shadows=primitive-map"},
        {"irregular z-buffer", "shadows=irregular-z-buffer"},
        {"published", "shadows=volumes,layout=published"},
        {"brute force, z-fail", "shadows=volumes,layout=brute-force"},
        {"brute force, z-pass", "shadows=volumes,layout=brute-force,count=z-pass"},
        {"planar 4", "shadows=planar"},
        {"planar 16", "shadows=planar,planes=16"},
        {"three-edge", "shadows=volumes,multiplicity=three-edge"},
        {"single-edge", "shadows=volumes,multiplicity=single-edge"},
        {"one depth range", "shadows=volumes,depth-slices=1"},
        {"two depth slices", "shadows=volumes,depth-slices=2"},
        {"published, a draw a side", "shadows=volumes,layout=published,instancing=multi-draw"},
        {"not instanced", "shadows=volumes,instancing=off"},
        {"mask 1/2", "shadows=volumes,mask-scale=1/2"},
        {"mask 1/4", "shadows=volumes,mask-scale=1/4"},
        {"no shadows", "shadows=none"},
    };
    addCasters(settings, diagonal);
    for (const int pcf : {1, 3})
        for (int size = 512; size <= std::min(largestMap, 8192); size *= 2) {
            std::string name = "map " + std::to_string(size);
            std::string text = "shadows=map,map-size=" + std::to_string(size);
            if (pcf > 1) {
                name += " pcf " + std::to_string(pcf);
                text += ",pcf=" + std::to_string(pcf);
            }
            settings.push_back({name, text});
        }
    addMapKinds(settings, largestMap, lights);
    addShadowedLights(settings, lights.size());
    return settings;
}

std::string asOptions(const std::string& text) {
    std::string options;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        part[part.find('=')] = ' ';
        options += (options.empty() ? "--" : " --") + part;
    }
    return options;
}

std::string leftOptions(const CasterOptions& call, const CasterChanges& setting) {
    std::ostringstream text;
    const auto add = [&](const char* name, std::optional<double> typed,
                         std::optional<double> changed) {
        if (typed && !changed)
            text << " " << name << " " << std::setprecision(std::numeric_limits<double>::digits10)
                 << *typed;
    };
    if (call.castMasked) text << " --cast-masked";
    if (call.changes.autoWeld && !setting.autoWeld && !setting.weldTolerance)
        text << " --weld-tolerance auto";
    if (!setting.autoWeld)
        add("--weld-tolerance", call.changes.weldTolerance, setting.weldTolerance);
    add("--flat-tolerance", call.changes.flatTolerance, setting.flatTolerance);
    add("--caster-error", call.changes.casterError, setting.casterError);
    if (call.changes.instances && !setting.instances)
        text << " --instances " << nameOf(*call.changes.instances);
    return text.str();
}

} // namespace edgeshade::cli
