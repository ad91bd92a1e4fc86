#include "src/hours/part_json.hpp"

#include "preprocess/base/base64.hpp"
#include "preprocess/gltf/data_uri.hpp"
#include "preprocess/gltf/json_vectors.hpp"
#include "src/hours/settings.hpp"
#include "src/image/zlib.hpp"

#include <cmath>

namespace edgeshade::hours {
namespace {

constexpr std::uint64_t largestFile = std::uint64_t{2} << 30;
constexpr std::uint64_t mostParts = mostPositions;
/// The array without elements, of which zlib makes no stream.
constexpr const char* noElements = "data:,";

/// Names by index; none occurs twice.
std::map<std::uint32_t, std::string> namesFrom(const JsonField& field) {
    std::map<std::uint32_t, std::string> names;
    field.forEachItem([&](const JsonField& item) {
        const JsonField index = item.member("index");
        const auto value = static_cast<std::uint32_t>(index.wholeNumber(Exposure::none));
        if (!names.emplace(value, item.member("name").text()).second)
            index.fail(" is " + std::to_string(value) + ", which occurs twice");
    });
    return names;
}

/// Positions of the part. `offset`: of the settings' clock.
std::vector<Position> positionsFrom(const JsonField& root, const PartNumber& part,
                                    std::chrono::minutes offset) {
    const JsonField field = root.member("positions");
    field.requireArray();
    const std::size_t wanted = countOfPart(part.positionsOfRun, part.number, part.of);
    if (field.size() != wanted)
        field.fail(" has " + std::to_string(field.size()) + " items, but part " +
                   std::to_string(part.number) + " of " + std::to_string(part.of) + " has " +
                   std::to_string(wanted) + " of " + std::to_string(part.positionsOfRun));
    std::vector<Position> positions;
    field.forEachItem([&](const JsonField& item) {
        Position& position = positions.emplace_back();
        const JsonField time = item.member("time");
        const sun::LocalTime read = readAs(time, sun::localTimeFromText);
        if (read.offset != offset) time.fail(" has a different offset from UTC than the settings");
        position.time = read.instant;
        position.azimuth = item.member("azimuth").number();
        position.altitude = item.member("altitude").number();
        position.direction = finiteVector(item.member("direction"));
    });
    return positions;
}

} // namespace

std::string packedBytes(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return noElements;
    return "data:application/zlib;base64," + base64(deflated(bytes));
}

Bytes unpackedBytes(const JsonField& field, const std::filesystem::path& path, std::size_t size) {
    if (size == 0) {
        if (field.text() != noElements)
            field.fail(std::string(" is not '") + noElements + "', as there are no elements");
        return {};
    }
    const Bytes stream = dataOfUri(field.text(), "'" + path.string() + "': " + field.name());
    std::optional<Bytes> bytes = inflated(stream, size);
    if (!bytes)
        field.fail(" is not a zlib stream of the " + std::to_string(size) +
                   " bytes that the size requires");
    return std::move(*bytes);
}

nlohmann::ordered_json vectorJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

glm::dvec3 finiteVector(const JsonField& field) {
    const glm::dvec3 vector = vectorFrom(field);
    for (glm::length_t c = 0; c < 3; ++c)
        if (!std::isfinite(vector[c])) field.fail(" is not finite");
    return vector;
}

nlohmann::ordered_json namesJson(const std::map<std::uint32_t, std::string>& names) {
    auto json = nlohmann::ordered_json::array();
    for (const auto& [index, name] : names)
        json.push_back({{"index", index}, {"name", name}});
    return json;
}

PartNumber partNumberFrom(const JsonField& root) {
    PartNumber part;
    const JsonField of = root.member("parts"), number = root.member("part");
    part.of = of.wholeNumber(mostParts);
    part.number = number.wholeNumber(mostParts);
    if (part.number < 1 || part.number > part.of)
        number.fail(" is " + std::to_string(part.number) + ", but must be from 1 to " +
                    std::to_string(part.of));
    part.positionsOfRun = root.member("positions_of_run").wholeNumber(mostPositions);
    return part;
}

RunHead runHeadFrom(const JsonField& root, const PartNumber& part) {
    RunHead head;
    head.scene = root.member("scene").text();
    const JsonField settings = root.member("settings");
    settings.requireObject();
    head.settings = settings.value();
    head.offset = hoursSettings(settings).offset;
    root.member("warnings").forEachItem([&](const JsonField& warning) {
        head.warnings.push_back(warning.text());
    });
    head.positions = positionsFrom(root, part, head.offset);
    head.materials = namesFrom(root.member("materials"));
    head.nodes = namesFrom(root.member("nodes"));
    return head;
}

nlohmann::ordered_json partJsonFrom(const std::filesystem::path& path) {
    const Bytes bytes = readFile(path, largestFile);
    try {
        return nlohmann::ordered_json::parse(bytes.begin(), bytes.end());
    } catch (const nlohmann::json::exception& error) {
        throw InputError("'" + path.string() +
                         "' is not a part of a sunhours run: " + clauseOf(error.what()) + ".");
    }
}

} // namespace edgeshade::hours
