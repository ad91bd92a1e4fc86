#pragma once

#include "src/render/volumes/render_settings.hpp"
#include "src/settings/build_parts.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace edgeshade {

/// The words that a setting's values go by on the command line, in reports, in a view's state and
/// in a page's address.
template <class Value, std::size_t N>
using SettingWords = std::array<std::pair<const char*, Value>, N>;

namespace words {

/// The first word of each method is the one that is written; the others are read, too.
inline constexpr SettingWords<ShadowMethod, 7> shadowsOfPages = {
    {{"auto", ShadowMethod::automatic},
     {"volumes", ShadowMethod::volumes},
     {"primitive-map", ShadowMethod::primitiveMap},
     {"lookup", ShadowMethod::primitiveMap},
     {"map", ShadowMethod::map},
     {"planar", ShadowMethod::planar},
     {"none", ShadowMethod::none}}};
inline constexpr auto shadows = [] {
    if constexpr (hasPoints) {
        SettingWords<ShadowMethod, 9> words{};
        auto end = std::copy(shadowsOfPages.begin(), shadowsOfPages.end(), words.begin());
        *end++ = {"irregular-z-buffer", ShadowMethod::irregularZBuffer};
        *end = {"points", ShadowMethod::irregularZBuffer};
        return words;
    } else {
        return shadowsOfPages;
    }
}();

inline constexpr SettingWords<MultiplicityMethod, 5> multiplicity = {
    {{"plane", MultiplicityMethod::plane},
     {"reference-edge", MultiplicityMethod::referenceEdge},
     {"three-edge", MultiplicityMethod::threeEdge},
     {"single-edge", MultiplicityMethod::singleEdge},
     {"triangle", MultiplicityMethod::triangle}}};

inline constexpr SettingWords<MapKind, 4> mapKind = {{{"cube", MapKind::cube},
                                                      {"cascades", MapKind::cascades},
                                                      {"paraboloid", MapKind::paraboloid},
                                                      {"warped", MapKind::warped}}};

inline constexpr SettingWords<WarpGrid, 2> warp = {
    {{"rectilinear", WarpGrid::rectilinear}, {"non-orthogonal", WarpGrid::nonOrthogonal}}};

inline constexpr SettingWords<Shading, 2> shading = {
    {{"full", Shading::full}, {"base", Shading::base}}};

} // namespace words
} // namespace edgeshade
