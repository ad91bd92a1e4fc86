#include "src/rivals/maps/map_filters.hpp"

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
    switch (filter) {
    case MapFilter::poisson:
        return {"POISSON"};
    case MapFilter::variance:
        return {"VSM"};
    case MapFilter::exponential:
        return {"ESM"};
    case MapFilter::moments:
        return {"MSM"};
    default:
        return {};
    }
}

std::string filterWordsOf(MapFilter filter) {
    switch (filter) {
    case MapFilter::poisson:
        return "Poisson taps";
    case MapFilter::variance:
        return "variance";
    case MapFilter::exponential:
        return "exponential";
    case MapFilter::moments:
        return "four moments";
    default:
        return "compared";
    }
}

} // namespace edgeshade
