#include "src/policy/shadow_policy.hpp"

#include "preprocess/base/names.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgeshade {
namespace {

struct Facts {
    const PolicySettings& settings;
    const DeviceFacts& device;
    const SceneFacts& scene;
    const LightFacts& light;
    const LookupFacts& lookup;
};

bool canAskPoints(const DeviceFacts& device) {
    return device.isSoftware && device.samples <= 1 && device.hasDepthOfItsOwn;
}

/// Whether points replace volumes when the user requested neither by name.
bool pointsPay(const PolicySettings& settings, const DeviceFacts& device, const SceneFacts& scene) {
    return settings.asked == ShadowMethod::automatic && settings.planePairs &&
           settings.maskScale == 1 && canAskPoints(device) &&
           scene.triangles >= leastTrianglesForPoints;
}

bool asks(const Facts& of, ShadowMethod method) {
    return of.settings.asked == method;
}

/// A row of the table; the first row that applies decides.
struct Rule {
    const char* name;
    bool (*applies)(const Facts&);
    Technique technique;
    std::string_view (*reason)(const Facts&);
};

std::string_view asked(const Facts&) {
    return {};
}

constexpr std::array rules{
    Rule{"light without a shadow", [](const Facts& of) { return !of.light.isShadowed; },
         Technique::none,
         [](const Facts&) -> std::string_view {
             return "other lights are estimated to add more to the picture";
         }},
    Rule{"light out of sight", [](const Facts& of) { return !of.light.isDrawn; }, Technique::none,
         [](const Facts&) -> std::string_view { return "it reaches no visible geometry"; }},
    Rule{"no shadows requested", [](const Facts& of) { return asks(of, ShadowMethod::none); },
         Technique::none, asked},
    Rule{"shadow map requested", [](const Facts& of) { return asks(of, ShadowMethod::map); },
         Technique::map, asked},
    Rule{"planar shadows requested", [](const Facts& of) { return asks(of, ShadowMethod::planar); },
         Technique::planar, asked},
    Rule{"points requested",
         [](const Facts& of) { return asks(of, ShadowMethod::irregularZBuffer); },
         Technique::points, asked},
    Rule{"volumes requested", [](const Facts& of) { return asks(of, ShadowMethod::volumes); },
         Technique::volumes, asked},
    Rule{"lookup is built", [](const Facts& of) { return of.lookup.isUsable; }, Technique::lookup,
         [](const Facts& of) { return of.lookup.reason; }},
    Rule{"points cost less than volumes",
         [](const Facts& of) { return pointsPay(of.settings, of.device, of.scene); },
         Technique::points,
         [](const Facts&) -> std::string_view {
             return "it has no primitive map, and filling volumes is estimated to take longer";
         }},
    Rule{"lookup was given up", [](const Facts& of) { return of.lookup.isSettled; },
         Technique::volumes, [](const Facts& of) { return of.lookup.reason; }},
    Rule{"light with an extent", [](const Facts& of) { return of.light.hasExtent; },
         Technique::volumes, [](const Facts&) -> std::string_view { return "it has an extent"; }},
    Rule{"lookup is not built yet", [](const Facts& of) { return of.light.rests; },
         Technique::volumes,
         [](const Facts&) -> std::string_view { return "its primitive map is not built"; }},
    Rule{"light that moves", [](const Facts&) { return true; }, Technique::volumes,
         [](const Facts&) -> std::string_view { return "it moves"; }},
};

const Rule& ruleFor(const Facts& facts) {
    return *std::find_if(rules.begin(), rules.end(),
                         [&](const Rule& of) { return of.applies(facts); });
}

/// A reason why casters or a light can't have a lookup.
struct Obstacle {
    bool (*applies)(const Facts&);
    const char* why;
};

constexpr int unitsForCutouts = 6;
constexpr int uniformsForExtent = 64; ///< vectors; a light's points take 17

constexpr std::array obstacles{
    Obstacle{[](const Facts& of) { return !of.device.floatTables; },
             "the GL can't sample float textures exactly"},
    Obstacle{[](const Facts& of) {
                 return of.scene.cutoutsCast && of.device.textureUnits < unitsForCutouts;
             },
             "the GL has too few texture units for cutouts"},
    Obstacle{[](const Facts& of) { return of.scene.simplified; }, "casters are simplified"},
    Obstacle{[](const Facts& of) { return of.scene.allAnimated; }, "all casters are animated"},
    Obstacle{[](const Facts& of) { return of.scene.alphaTested; }, "some casters are alpha-tested"},
};

/// Further obstacles for a light with an extent, since one lookup holds the whole light.
constexpr std::array obstaclesOfExtents{
    Obstacle{[](const Facts& of) { return of.device.fragmentUniformVectors < uniformsForExtent; },
             "the GL has too few uniforms for a light's points"},
    Obstacle{[](const Facts& of) { return of.light.hasRange; },
             "it has both an extent and a range"},
    Obstacle{[](const Facts& of) { return of.light.isSpot; }, "it is a spot with an extent"},
    Obstacle{[](const Facts& of) { return of.scene.cutoutsCast; },
             "it has an extent, and cutouts cast shadows"},
    Obstacle{[](const Facts& of) { return of.scene.anyAnimated; },
             "it has an extent, and casters are animated"},
};

template <std::size_t N>
std::string firstOf(const std::array<Obstacle, N>& all, const Facts& facts) {
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const Obstacle& obstacle) { return obstacle.applies(facts); });
    return found == all.end() ? "" : found->why;
}

/// Whether lookups are built only where they cost less than volumes. If see-through surfaces
/// receive shadows while lookups are built in the background, every lookup is built: only lookups
/// can shade such surfaces.
bool onlyWhatPays(const PolicySettings& settings) {
    return settings.asked == ShadowMethod::automatic &&
           !(settings.inBackground && settings.seeThroughReceives);
}

} // namespace

const char* wordFor(Technique technique) {
    using enum Technique;
    return nameIn({{none, "none"},
                   {volumes, "volumes"},
                   {lookup, "primitive-map"},
                   {points, "irregular-z-buffer"},
                   {map, "map"},
                   {planar, "planar"}},
                  technique);
}

LightChoice ShadowPolicy::choose(const LightFacts& light, const LookupFacts& lookup) const {
    const Rule& rule = ruleFor({settings_, device_, scene_, light, lookup});
    LightChoice choice{rule.technique, rule.technique, rule.name};
    if (choice.technique == Technique::lookup)
        choice.counted = !scene_.anyAnimated                     ? Technique::none
                         : pointsPay(settings_, device_, scene_) ? Technique::points
                                                                 : Technique::volumes;
    return choice;
}

std::string ShadowPolicy::reasonFor(const LightFacts& light, const LookupFacts& lookup) const {
    const Facts facts{settings_, device_, scene_, light, lookup};
    return std::string(ruleFor(facts).reason(facts));
}

LookupWish ShadowPolicy::lookupWish(const LightFacts& light) const {
    if (!settings_.usesLookups()) return {};
    const bool forSeeThrough = !settings_.asksForLookups();
    const bool byName = settings_.asked == ShadowMethod::primitiveMap;
    if (light.hasExtent && !byName && !settings_.inBackground) return {};
    if (!light.rests && (!byName || settings_.inBackground)) return {};
    return {true,
            light.isDrawn && light.isShadowed && !(forSeeThrough && !light.reachesSeeThrough)};
}

std::string ShadowPolicy::lookupObstacle(const LightFacts& light) const {
    const LookupFacts none;
    const Facts facts{settings_, device_, scene_, light, none};
    std::string why = firstOf(obstacles, facts);
    if (why.empty() && light.hasExtent) why = firstOf(obstaclesOfExtents, facts);
    if (!why.empty()) return why;
    const bool paysAlways = !onlyWhatPays(settings_) || scene_.cutoutsCast || light.hasExtent;
    if (!paysAlways && light.silhouetteEdges)
        if (const std::size_t edges = light.silhouetteEdges(); edges <= fewSilhouettes)
            return "volumes of " + std::to_string(edges) + " silhouette edges cost less";
    return {};
}

std::string ShadowPolicy::roomObstacle(std::size_t room) const {
    return room < leastLookupBytes ? "other lights' primitive maps leave no memory for it" : "";
}

std::string ShadowPolicy::lookupRefusal(const LookupOutcome& built) const {
    if (!built.fault.empty()) return built.fault;
    if (onlyWhatPays(settings_) && built.meanList > longLists)
        return "volumes cost less than lists of " + std::to_string(std::lround(built.meanList)) +
               " triangles";
    return {};
}

bool ShadowPolicy::mayLookUp(std::size_t records) const {
    const LightFacts light;
    const LookupFacts none;
    if (!firstOf(obstacles, {settings_, device_, scene_, light, none}).empty()) return false;
    return !onlyWhatPays(settings_) || records > fewSilhouettes || scene_.cutoutsCast;
}

bool ShadowPolicy::asksPoints() const {
    return choose({}, {}).technique == Technique::points;
}

bool ShadowPolicy::mayAskPoints() const {
    if (settings_.asked == ShadowMethod::irregularZBuffer) return canAskPoints(device_);
    SceneFacts large = scene_;
    large.triangles = leastTrianglesForPoints;
    return pointsPay(settings_, device_, large);
}

} // namespace edgeshade
