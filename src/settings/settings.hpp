#pragma once

#include "preprocess/scene/material.hpp"
#include "preprocess/scene/section.hpp"
#include "src/settings/build_parts.hpp"
#include "src/settings/choices.hpp"
#include "src/settings/conditions.hpp"
#include "src/settings/domains.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/shadow/lights/light_extent.hpp"

#include <algorithm>

namespace edgeshade {

/// A setting: its name, its values, and when it has an effect.
template <class Domain>
struct Setting {
    const char* key; ///< in a view's state; options and reports have dashes for underscores
    Domain domain;
    Condition needs = Condition::none; ///< else the option is refused, and reports leave it out
    Condition matters = needs;         ///< else it has no effect
};
template <class Domain>
Setting(const char*, Domain) -> Setting<Domain>;

/// Every setting of drawing, once. src/cli/draw_settings.cpp and forEachSideSetting() say where
/// the values are, src/cli/option_rows.cpp explains them to users.
namespace settings {

inline constexpr Setting shadows{
    "shadows", [] {
        constexpr Words<ShadowMethod, 9> all = {
            {{"auto", ShadowMethod::automatic},
             {"volumes", ShadowMethod::volumes},
             {"lookup", ShadowMethod::primitiveMap, WordUse::typed},
             {"primitive-map", ShadowMethod::primitiveMap, WordUse::written},
             {"points", ShadowMethod::irregularZBuffer, WordUse::typed},
             {"irregular-z-buffer", ShadowMethod::irregularZBuffer, WordUse::written},
             {"map", ShadowMethod::map},
             {"planar", ShadowMethod::planar},
             {"none", ShadowMethod::none}}};
        Words<ShadowMethod, hasPoints ? 9 : 7> ofBuild{};
        std::copy_if(all.begin(), all.end(), ofBuild.begin(), [](const auto& word) {
            return hasPoints || word.value != ShadowMethod::irregularZBuffer;
        });
        return ofBuild;
    }()};

inline constexpr Setting<Words<VolumeLayout, 3>> layout{
    "layout",
    {{{"adapted", VolumeLayout::planePairs},
      {"published", VolumeLayout::oppositeVertices},
      {"brute-force", VolumeLayout::triangles}}}};
inline constexpr Setting<Words<MultiplicityMethod, 5>> multiplicity{
    "multiplicity",
    {{{"plane", MultiplicityMethod::plane},
      {"reference-edge", MultiplicityMethod::referenceEdge},
      {"three-edge", MultiplicityMethod::threeEdge},
      {"single-edge", MultiplicityMethod::singleEdge},
      {"triangle", MultiplicityMethod::triangle}}},
    Condition::none,
    Condition::mayCount};
inline constexpr Setting<Words<SilhouetteChoice, 2>> silhouette{
    "silhouette", {{{"proposed", SilhouetteChoice::proposed}, {"all", SilhouetteChoice::all}}}};
inline constexpr Setting<Words<InstancingChoice, 4>> instancing{
    "instancing",
    {{{"auto", InstancingChoice::automatic},
      {"on", InstancingChoice::on},
      {"off", InstancingChoice::off},
      {"multi-draw", InstancingChoice::multiDraw}}}};
inline constexpr Setting<Optional<WholeRange>> depthSlices{"depth_slices", {{1, 64}, "auto"}};
inline constexpr Setting<Words<BruteForceCount, 2>> count{
    "count",
    {{{"z-fail", BruteForceCount::zFail}, {"z-pass", BruteForceCount::zPass}}},
    Condition::bruteForce};
/// One count for a block of this many by this many pixels.
inline constexpr Setting<Words<int, 3>> maskScale{
    "mask_scale", {{{"1", 1}, {"1/2", 2}, {"1/4", 4}}}, Condition::volumes, Condition::mayCount};
inline constexpr Setting<WholeRange> planes{"planes", {1, 64}, Condition::planar};
inline constexpr Setting<WholeRange> primitiveMapMemory{
    "primitive_map_memory", {1 << 16, std::int64_t{1} << 32}, Condition::lookups}; // bytes

inline constexpr Setting<Optional<WholeRange>> shadowedLights{"shadowed_lights",
                                                              {{0, mostLights}, "all"}};
inline constexpr Setting<WholeRange> lightSamples{"light_samples", {1, mostLightPoints}};
inline constexpr Setting<WholeRange> smooth{"smooth", {1, 256}}; // pictures

inline constexpr Setting<Words<Shading, 2>> shading{
    "shading", {{{"full", Shading::full}, {"base", Shading::base}}}};
inline constexpr Setting<NumberRange> ambient{"ambient", {0.0, 1.0}};
inline constexpr Setting<NumberRange> exposure{
    "exposure", {-20.0, 20.0}, Condition::fullShading}; // EV
inline constexpr Setting<Words<bool, 2>> terminator{
    "terminator", {{{"soft", true}, {"exact", false}}}, Condition::fullShading};
inline constexpr Setting<FileName> environment{"environment", {"neutral"}, Condition::fullShading};
inline constexpr Setting<Words<bool, 2>> cull{"cull", {{{"auto", true}, {"off", false}}}};

inline constexpr Setting<Words<SectionShadows, 2>> sectionShadows{
    "section_shadows", {{{"cut", SectionShadows::cut}, {"whole", SectionShadows::whole}}}};

inline constexpr Setting<WholeRange> mapSize{"map_size", {16, 16384}, Condition::map};
inline constexpr Setting<NumberRange> mapBias{"map_bias", {0.0, 100.0}, Condition::map}; // texels
inline constexpr Setting<Words<MapKind, 4>> mapKind{"map_kind",
                                                    {{{"cube", MapKind::cube},
                                                      {"cascades", MapKind::cascades},
                                                      {"paraboloid", MapKind::paraboloid},
                                                      {"warped", MapKind::warped}}},
                                                    Condition::map};
inline constexpr Setting<WholeRange> cascades{"cascades", {1, mostCascades}, Condition::cascades};
inline constexpr Setting<Words<WarpGrid, 2>> warp{
    "warp",
    {{{"rectilinear", WarpGrid::rectilinear}, {"non-orthogonal", WarpGrid::nonOrthogonal}}},
    Condition::warped};
/// The filter of a side. Its width and SoftShadows are settings of their own.
inline constexpr Setting<Words<MapFilter, 5>> mapFilter{"filter",
                                                        {{{"pcf", MapFilter::compare},
                                                          {"poisson", MapFilter::poisson},
                                                          {"vsm", MapFilter::variance},
                                                          {"esm", MapFilter::exponential},
                                                          {"msm", MapFilter::moments}}},
                                                        Condition::map};
/// The filter on the command line.
inline constexpr Setting<Words<FilterChoice, 7>> filter{
    "filter",
    [] {
        Words<FilterChoice, 7> words{};
        words.front() = {"none", {MapFilter::compare, FilterChoice::Width::one}};
        for (std::size_t i = 0; i < mapFilter.domain.size(); ++i)
            words[i + 1] = {mapFilter.domain[i].text, {mapFilter.domain[i].value}};
        words.back() = {"pcss", {MapFilter::compare, FilterChoice::Width::pcss}};
        return words;
    }(),
    Condition::map};
inline constexpr Setting<Numbers<4>> pcf{"pcf", {{1, 3, 5, 7}}, Condition::map}; // texels
inline constexpr Setting<Words<SoftShadows, 3>> soft{
    "soft",
    {{{"none", SoftShadows::none}, {"pcf", SoftShadows::pcf}, {"pcss", SoftShadows::pcss}}},
    Condition::map};

} // namespace settings

/// Calls use(setting, value...) for every setting of a side, in the order of a view's state.
/// `of`: SideSettings or RenderSettings, constant or not.
template <class Use, class... Of>
constexpr void forEachSideSetting(Use use, Of&... of) {
    use(settings::shadows, of.shadows...);
    use(settings::mapSize, of.map.size...);
    use(settings::multiplicity, of.multiplicity...);
    use(settings::maskScale, of.maskScale...);
    use(settings::mapKind, of.map.kind...);
    use(settings::cascades, of.map.cascades...);
    use(settings::mapFilter, of.map.filter...);
    use(settings::pcf, of.map.pcf...);
    use(settings::warp, of.map.warp...);
}

/// Copies a side's settings, from one of these to another.
template <class To, class From>
constexpr void setSide(To& to, const From& from) {
    forEachSideSetting([](const auto&, auto& one, const auto& other) { one = other; }, to, from);
}

} // namespace edgeshade
