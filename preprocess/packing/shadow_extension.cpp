#include "preprocess/packing/shadow_extension.hpp"

#include "preprocess/base/names.hpp"
#include "preprocess/gltf/accessor.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "shaders_es2/record_layout.glsl"

#include <cstdio>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* shadowAccessorKeys[] = {
    "simplifiedCasters", "sides", "caps", "edgeVertices", "oppositeCounts", "oppositeVertices"};

/// Checks the types of a batch's fields; references are checked where they are used.
void checkBatch(const JsonField& batch) {
    batch.ifPresent("node", [](const JsonField& node) { node.index(); });
    batch.member("positionsHash").text();
    batch.ifPresent("simplifiedTriangles", [](const JsonField& count) { count.index(); });
    batch.ifPresent("edgeCount", [](const JsonField& count) { count.index(); });
    for (const char* key : shadowAccessorKeys)
        batch.ifPresent(key, [](const JsonField& accessor) { accessor.index(); });
}

double notNegative(const JsonField& field) {
    const double value = field.number();
    if (value < 0.0) field.fail(" is negative");
    return value;
}

/// The value whose name the field holds.
template <class Value>
Value namedBy(const JsonField& field, std::initializer_list<Value> known) {
    const std::string name = field.text();
    for (const Value value : known)
        if (name == nameOf(value)) return value;
    field.fail(" is '" + name + "', which is not known");
}

} // namespace

const char* nameOf(Encoding encoding) {
    return nameIn({{Encoding::expanded, "expanded"},
                   {Encoding::indexed, "indexed"},
                   {Encoding::none, "none"}},
                  encoding);
}

std::string hashText(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

const Json* shadowExtensionOf(const Json& json) {
    const auto extensions = json.find("extensions");
    if (extensions == json.end()) return nullptr;
    const auto extension = extensions->find(shadowExtensionName);
    return extension == extensions->end() ? nullptr : &*extension;
}

std::set<int> shadowAccessorsOf(const Json& extension) {
    std::set<int> accessors;
    for (const Json& batch : extension.at("batches"))
        for (const char* key : shadowAccessorKeys)
            if (batch.contains(key)) accessors.insert(batch.at(key).get<int>());
    return accessors;
}

std::optional<ShadowHeader> readShadowHeader(const GltfDocument& document) {
    const Json* json = shadowExtensionOf(document.json);
    if (!json) return std::nullopt;
    const JsonField extension(document.path, *json, shadowExtensionName);
    const JsonField version = extension.member("version");
    if (version.index() != shadowExtensionVersion)
        version.fail(" is " + std::to_string(version.index()) + "; this program reads version " +
                     std::to_string(shadowExtensionVersion));
    ShadowHeader header;
    header.encoding = namedBy(extension.member("encoding"),
                              {Encoding::expanded, Encoding::indexed, Encoding::none});
    const JsonField multiplicity = extension.member("maxMultiplicity");
    const auto value = multiplicity.integer();
    if (value < 1 || value > LARGEST_RECORD_MULTIPLICITY)
        multiplicity.fail(" is " + std::to_string(value) + ", but must be 1 to " +
                          std::to_string(LARGEST_RECORD_MULTIPLICITY));
    header.maxMultiplicity = static_cast<int>(value);
    header.settings.weldTolerance = notNegative(extension.member("weldTolerance"));
    header.settings.casterError = notNegative(extension.member("casterError"));
    const JsonField flat = extension.member("flatTolerance");
    header.settings.flatTolerance = notNegative(flat);
    if (header.settings.flatTolerance >= flatToleranceEnd)
        flat.fail(" is " + std::to_string(header.settings.flatTolerance) +
                  ", but must be below 45");
    header.settings.castMasked = extension.member("castMasked").boolean();
    header.settings.instances = InstanceChoice::repeated;
    extension.ifPresent("instances", [&](const JsonField& instances) {
        using enum InstanceChoice;
        header.settings.instances = namedBy(instances, {automatic, shared, repeated});
    });
    extension.member("batches").forEachItem(checkBatch);
    return header;
}

std::size_t storedShadowBytes(const GltfDocument& document) {
    if (!readShadowHeader(document)) return 0;
    std::size_t bytes = 0;
    for (const int accessor : shadowAccessorsOf(*shadowExtensionOf(document.json)))
        bytes +=
            bufferViewBytes(document, bufferViewOf(document, accessor, shadowExtensionName)).size();
    return bytes;
}

} // namespace edgeshade
