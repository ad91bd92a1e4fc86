#include "src/cli/tradeoff_family.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <sstream>

namespace edgeshade::cli {
namespace {

using Words = std::map<std::string, std::string>;

Words wordsOf(const std::string& text) {
    Words words;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        const std::size_t equals = std::min(part.find('='), part.size());
        words[part.substr(0, equals)] = part.substr(std::min(equals + 1, part.size()));
    }
    return words;
}

/// The setting's value for `name`; `otherwise` if it has none.
std::string said(const Words& words, const std::string& name, const std::string& otherwise) {
    const auto found = words.find(name);
    return found == words.end() ? otherwise : found->second;
}

bool saysAnyOf(const Words& words, std::initializer_list<const char*> names) {
    return std::ranges::any_of(names, [&](const char* name) { return words.contains(name); });
}

std::string familyOfMap(const Words& words) {
    const std::string kind = said(words, "map-kind", "cube");
    if (kind != "cube") return kind;
    const std::string filter =
        said(words, "filter", said(words, "pcf", "1") == "1" ? "none" : "pcf");
    return filter == "none" ? "maps" : "maps, " + filter;
}

std::string familyOfVolumes(const Words& words) {
    if (saysAnyOf(words, {"caster-error", "weld-tolerance", "flat-tolerance"}))
        return "coarser casters";
    if (words.contains("mask-scale")) return "coarser masks";
    const std::string published =
        said(words, "multiplicity", "plane") == "plane" ? "adapted" : "published";
    const std::string layout = said(words, "layout", published);
    return layout == "adapted" ? "volumes" : "volumes, " + layout;
}

} // namespace

std::string familyOf(const std::string& text) {
    const Words words = wordsOf(text);
    const std::string shadows = said(words, "shadows", "volumes");
    if (shadows == "map") return familyOfMap(words);
    if (shadows == "volumes") return familyOfVolumes(words);
    if (shadows == "none") return "no shadows";
    std::string name = shadows;
    std::ranges::replace(name, '-', ' ');
    return name;
}

std::vector<std::string> familiesOf(const std::vector<std::string>& texts) {
    std::vector<std::string> families = {"volumes",       "volumes, published",
                                         "coarser masks", "coarser casters",
                                         "primitive map", "maps",
                                         "maps, pcf",     "maps, poisson",
                                         "maps, vsm",     "maps, esm",
                                         "cascades",      "paraboloid",
                                         "no shadows",    "volumes, brute-force",
                                         "planar",        "warped",
                                         "maps, msm",     "irregular z buffer"};
    for (const std::string& text : texts)
        if (const std::string family = familyOf(text);
            std::ranges::find(families, family) == families.end())
            families.push_back(family);
    return families;
}

} // namespace edgeshade::cli
