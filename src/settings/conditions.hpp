#pragma once

#include "preprocess/scene/material.hpp"
#include "src/settings/choices.hpp"

#include <array>
#include <cstddef>

namespace edgeshade {

/// Conditions on other settings for one to have an effect.
enum class Condition {
    none,
    fullShading,
    bruteForce,
    planar,
    volumes,
    mayCount, ///< volumes, for some lights at least
    lookups,
    map,
    cascades,
    warped,
};

/// Whether the condition holds for RenderSettings, or, unless it is about shading, SideSettings.
template <class Settings>
constexpr bool holds(Condition condition, const Settings& of) {
    if (condition == Condition::none) return true;
    if constexpr (requires { of.shading; })
        if (condition == Condition::fullShading) return of.shading == Shading::full;
    if (condition == Condition::bruteForce)
        return volumeLayoutOf(of.multiplicity) == VolumeLayout::triangles;
    switch (of.shadows) {
    case ShadowMethod::volumes:
        return condition == Condition::volumes || condition == Condition::mayCount;
    case ShadowMethod::irregularZBuffer:
        return condition == Condition::mayCount;
    case ShadowMethod::primitiveMap:
    case ShadowMethod::automatic:
        return condition == Condition::lookups || condition == Condition::mayCount;
    case ShadowMethod::map:
        return condition == Condition::map ||
               (condition == Condition::cascades && of.map.kind == MapKind::cascades) ||
               (condition == Condition::warped && of.map.kind == MapKind::warped);
    case ShadowMethod::planar:
        return condition == Condition::planar;
    case ShadowMethod::none:
        break;
    }
    return false;
}

/// The options that make the condition hold, for messages; empty: it needs none.
constexpr const char* optionsFor(Condition condition) {
    constexpr std::array options{
        "",                         // none
        "--shading full",           // fullShading
        "--layout brute-force",     // bruteForce
        "--shadows planar",         // planar
        "--shadows volumes",        // volumes
        "--shadows volumes",        // mayCount
        "--shadows lookup or auto", // lookups
        "--shadows map",            // map
        "--map-kind cascades",      // cascades
        "--map-kind warped",        // warped
    };
    return options[static_cast<std::size_t>(condition)];
}

/// The options that the condition still lacks; empty: it holds.
template <class Settings>
constexpr const char* missing(Condition condition, const Settings& of) {
    if (holds(condition, of)) return "";
    const bool ofMaps = condition == Condition::cascades || condition == Condition::warped;
    return optionsFor(ofMaps && !holds(Condition::map, of) ? Condition::map : condition);
}

} // namespace edgeshade
