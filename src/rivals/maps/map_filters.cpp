#include "src/rivals/maps/map_filters.hpp"

#include "preprocess/base/names.hpp"

namespace edgeshade {

bool isFiltered(const ShadowMapSettings& settings) {
    return settings.filter == MapFilter::variance || settings.filter == MapFilter::exponential ||
           settings.filter == MapFilter::moments;
}

int texelWidthOf(const ShadowMapSettings& settings) {
    return settings.filter == MapFilter::moments ? 2 : 1;
}

float bleedingShareOf(const ShadowMapSettings& settings) {
    return settings.bleeding.value_or(settings.filter == MapFilter::moments ? 0.02f : 0.2f);
}

std::vector<std::string> filterDefines(MapFilter filter) {
    using enum MapFilter;
    if (filter == compare) return {};
    return {nameIn(
        {{poisson, "POISSON"}, {variance, "VSM"}, {exponential, "ESM"}, {moments, "MSM"}}, filter)};
}

std::string filterWordsOf(MapFilter filter) {
    using enum MapFilter;
    return nameIn({{poisson, "Poisson taps"},
                   {variance, "variance"},
                   {exponential, "exponential"},
                   {moments, "four moments"},
                   {compare, "compared"}},
                  filter);
}

} // namespace edgeshade
