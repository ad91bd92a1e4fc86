#include "edgeshade/light_lookup.hpp"
#include "preprocess/base/error.hpp"
#include "shaders_es2.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace edgeshade {
namespace {

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Whether the source defines this name itself: names of the map, of cutouts and of a light's
/// points.
bool isOwn(std::string_view word) {
    for (const std::string_view part : {"rimitive", "PRIMITIVE_"})
        if (word.find(part) != std::string_view::npos) return true;
    for (const std::string_view own :
         {"wrappedTexel", "sixteenAt", "pointError", "edgeAB", "edgeBC", "edgeAC", "triangleNormal",
          "abovePlane", "hand", "notBlocked", "notGrazing", "sumOf"})
        if (word == own) return true;
    return word.starts_with("cutout") || word.starts_with("places");
}

std::string lowered(std::string_view word) {
    std::string text(word);
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

/// The public name of a word; uniforms and the functions that a host calls get short ones.
std::string named(const std::string& prefix, std::string_view word) {
    constexpr std::string_view uniform = "u_primitive", asked = "primitiveLit";
    if (word.starts_with(uniform)) return prefix + "_" + lowered(word.substr(uniform.size()));
    if (word.starts_with(asked)) return prefix + "_" + lowered(word.substr(asked.size() - 3));
    return prefix + "_" + std::string(word);
}

std::string withoutComments(std::string_view source) {
    std::string text;
    while (!source.empty()) {
        const std::size_t end = std::min(source.find('\n'), source.size());
        std::string_view line = source.substr(0, std::min(end, source.find("//")));
        while (!line.empty() && line.back() == ' ')
            line.remove_suffix(1);
        if (!line.empty()) text.append(line).push_back('\n');
        source.remove_prefix(std::min(end + 1, source.size()));
    }
    return text;
}

} // namespace

std::string lookupSource(const std::string& prefix, LookupCasters casters, bool soft) {
    if (prefix.empty() || !std::all_of(prefix.begin(), prefix.end(), isWordCharacter) ||
        std::isdigit(static_cast<unsigned char>(prefix[0])) || prefix.back() == '_' ||
        prefix.find("__") != std::string::npos || prefix.starts_with("gl_"))
        throw InputError("'" + prefix + "' is not a valid prefix for names in GLSL.");
    const std::string source = withoutComments(shaders::lookup_glsl);
    std::string text;
    if (casters.cutouts) text += "#define " + prefix + "_PRIMITIVE_MAP_CUTOUTS\n";
    if (casters.tints) text += "#define " + prefix + "_PRIMITIVE_MAP_TINTS\n";
    if (soft) text += "#define " + prefix + "_PRIMITIVE_MAP_POINTS\n";
    for (std::size_t i = 0; i < source.size();) {
        std::size_t end = i;
        while (end < source.size() && isWordCharacter(source[end]))
            ++end;
        if (end == i) {
            text.push_back(source[i++]);
            continue;
        }
        const std::string_view word = std::string_view(source).substr(i, end - i);
        text += isOwn(word) ? named(prefix, word) : std::string(word);
        i = end;
    }
    return text;
}

} // namespace edgeshade
