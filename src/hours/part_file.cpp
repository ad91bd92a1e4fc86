#include "src/hours/part_file.hpp"

#include "preprocess/base/base64.hpp"
#include "preprocess/gltf/data_uri.hpp"
#include "preprocess/gltf/json_vectors.hpp"
#include "src/hours/settings.hpp"
#include "src/image/zlib.hpp"

#include <bit>
#include <cmath>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t version = 1;
constexpr const char* versionKey = "edgeshade_sunhours_part";
constexpr std::uint64_t largestFile = std::uint64_t{2} << 30;
constexpr std::uint64_t longestSide = 65536;
constexpr std::uint64_t mostPixels = std::uint64_t{1} << 28;
constexpr std::uint64_t mostParts = mostPositions;

std::uint32_t bitsOf(float value) {
    return std::bit_cast<std::uint32_t>(value);
}
template <class T>
T bitsOf(T value) {
    return value;
}

/// The pixels as a data URI.
template <class T>
std::string packed(const std::vector<T>& pixels) {
    Bytes bytes;
    bytes.reserve(sizeof(T) * pixels.size());
    for (const T pixel : pixels)
        for (std::size_t b = 0; b < sizeof(T); ++b)
            bytes.push_back(static_cast<std::uint8_t>(bitsOf(pixel) >> 8 * b));
    return "data:application/zlib;base64," + base64(deflated(bytes));
}

template <class T>
std::vector<T> unpacked(const JsonField& field, const std::filesystem::path& path,
                        std::size_t count) {
    const Bytes stream = dataOfUri(field.text(), "'" + path.string() + "': " + field.name());
    const std::optional<Bytes> bytes = inflated(stream, sizeof(T) * count);
    if (!bytes)
        field.fail(" is not a zlib stream of the " + std::to_string(sizeof(T) * count) +
                   " bytes that the size requires");
    using Bits = decltype(bitsOf(T()));
    std::vector<T> pixels(count);
    for (std::size_t i = 0; i < count; ++i) {
        Bits bits = 0;
        for (std::size_t b = sizeof(T); b-- > 0;)
            bits = static_cast<Bits>(sizeof(T) == 1 ? 0 : bits << 8) |
                   static_cast<Bits>((*bytes)[sizeof(T) * i + b]);
        pixels[i] = std::bit_cast<T>(bits);
    }
    return pixels;
}

Json vectorJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

glm::dvec3 vectorOf(const JsonField& field) {
    const glm::dvec3 vector = vectorFrom(field);
    for (glm::length_t c = 0; c < 3; ++c)
        if (!std::isfinite(vector[c])) field.fail(" is not finite");
    return vector;
}

Json namesJson(const std::map<std::uint32_t, std::string>& names) {
    Json json = Json::array();
    for (const auto& [index, name] : names)
        json.push_back({{"index", index}, {"name", name}});
    return json;
}

std::map<std::uint32_t, std::string> namesOf(const JsonField& field) {
    std::map<std::uint32_t, std::string> names;
    field.forEachItem([&](const JsonField& item) {
        const JsonField index = item.member("index");
        const auto value = static_cast<std::uint32_t>(index.wholeNumber(Exposure::none));
        if (!names.emplace(value, item.member("name").text()).second)
            index.fail(" is " + std::to_string(value) + ", which occurs twice");
    });
    return names;
}

Position positionOf(const JsonField& field, std::chrono::minutes offset) {
    Position position;
    const JsonField time = field.member("time");
    const sun::LocalTime read = readAs(time, sun::localTimeFromText);
    if (read.offset != offset) time.fail(" has a different offset from UTC than the settings");
    position.time = read.instant;
    position.azimuth = field.member("azimuth").number();
    position.altitude = field.member("altitude").number();
    position.direction = vectorOf(field.member("direction"));
    return position;
}

/// `positions`: number of the part's positions.
Probe probeOf(const JsonField& field, std::size_t positions) {
    Probe probe;
    probe.point = vectorOf(field.member("point"));
    const JsonField normal = field.member("normal");
    if (!normal.value().is_null()) probe.normal = vectorOf(normal);
    const JsonField lit = field.member("lit");
    const std::string bits = lit.text();
    if (bits.size() != positions || bits.find_first_not_of("01") != std::string::npos)
        lit.fail(" is not " + std::to_string(positions) +
                 " zeros and ones, one for each of the part's positions");
    for (const char bit : bits)
        probe.lit.push_back(bit == '1');
    return probe;
}

void requireNamed(const JsonField& field, const std::vector<std::uint32_t>& pixels,
                  const std::map<std::uint32_t, std::string>& names) {
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (pixels[i] != Exposure::none && !names.contains(pixels[i]))
            field.fail(" of pixel " + std::to_string(i) + " is " + std::to_string(pixels[i]) +
                       ", which has no name");
}

Exposure exposureOf(const JsonField& root, const std::filesystem::path& path, const Part& part) {
    const JsonField size = root.member("size");
    size.requireArray();
    if (size.size() != 2) size.fail(" is not a pair of numbers");
    const std::uint64_t width = size.item(0).wholeNumber(longestSide),
                        height = size.item(1).wholeNumber(longestSide);
    if (width == 0 || height == 0 || width * height > mostPixels)
        size.fail(" is " + size.value().dump() + ", but must be from 1 to 65536 and of at most " +
                  std::to_string(mostPixels) + " pixels");
    const std::size_t count = width * height;
    Exposure exposure;
    exposure.width = static_cast<int>(width);
    exposure.height = static_cast<int>(height);
    const JsonField pixels = root.member("pixels");
    const JsonField lit = pixels.member("lit"), surface = pixels.member("surface"),
                    area = pixels.member("area"), material = pixels.member("material"),
                    node = pixels.member("node");
    exposure.lit = unpacked<std::uint16_t>(lit, path, count);
    exposure.surface = unpacked<std::uint8_t>(surface, path, count);
    exposure.area = unpacked<float>(area, path, count);
    exposure.material = unpacked<std::uint32_t>(material, path, count);
    exposure.node = unpacked<std::uint32_t>(node, path, count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string pixel = " of pixel " + std::to_string(i) + " is ";
        if (exposure.surface[i] > 1)
            surface.fail(pixel + std::to_string(exposure.surface[i]) + ", but must be 0 or 1");
        if (exposure.lit[i] > part.positions.size())
            lit.fail(pixel + std::to_string(exposure.lit[i]) + ", but the part has " +
                     std::to_string(part.positions.size()) + " positions");
        if (!(exposure.area[i] >= 0.0f) || !std::isfinite(exposure.area[i]))
            area.fail(pixel + std::to_string(exposure.area[i]) +
                      ", but must be finite and not below 0");
    }
    requireNamed(material, exposure.material, part.materials);
    requireNamed(node, exposure.node, part.nodes);
    return exposure;
}

Part partOf(const Json& json, const std::filesystem::path& path) {
    const JsonField root(path, json);
    root.requireObject();
    root.requireVersion(versionKey, version);
    Part part;
    const JsonField of = root.member("parts"), number = root.member("part");
    part.of = of.wholeNumber(mostParts);
    part.number = number.wholeNumber(mostParts);
    if (part.number < 1 || part.number > part.of)
        number.fail(" is " + std::to_string(part.number) + ", but must be from 1 to " +
                    std::to_string(part.of));
    part.scene = root.member("scene").text();
    const JsonField settings = root.member("settings");
    settings.requireObject();
    part.settings = settings.value();
    part.offset = hoursSettings(settings).offset;
    part.camera = root.member("camera").value();
    root.member("warnings").forEachItem([&](const JsonField& warning) {
        part.warnings.push_back(warning.text());
    });
    part.positionsOfRun = root.member("positions_of_run").wholeNumber(mostPositions);
    const JsonField positions = root.member("positions");
    positions.requireArray();
    const std::size_t wanted = countOfPart(part.positionsOfRun, part.number, part.of);
    if (positions.size() != wanted)
        positions.fail(" has " + std::to_string(positions.size()) + " items, but part " +
                       std::to_string(part.number) + " of " + std::to_string(part.of) + " has " +
                       std::to_string(wanted) + " of " + std::to_string(part.positionsOfRun));
    positions.forEachItem([&](const JsonField& position) {
        part.positions.push_back(positionOf(position, part.offset));
    });
    root.member("probes").forEachItem(
        [&](const JsonField& probe) { part.probes.push_back(probeOf(probe, wanted)); });
    part.materials = namesOf(root.member("materials"));
    part.nodes = namesOf(root.member("nodes"));
    part.exposure = exposureOf(root, path, part);
    return part;
}

} // namespace

std::size_t countOfPart(std::size_t positions, std::size_t number, std::size_t of) {
    return (positions + of - number) / of;
}

Json jsonOf(const Position& position, std::chrono::minutes offset) {
    return {{"time", sun::textOf(sun::LocalTime{position.time, offset})},
            {"azimuth", position.azimuth},
            {"altitude", position.altitude},
            {"direction", vectorJson(position.direction)}};
}

std::string textOf(const Part& part) {
    Json positions = Json::array(), probes = Json::array();
    for (const Position& position : part.positions)
        positions.push_back(jsonOf(position, part.offset));
    for (const Probe& probe : part.probes) {
        std::string lit;
        for (const bool seen : probe.lit)
            lit += seen ? '1' : '0';
        probes.push_back({{"point", vectorJson(probe.point)},
                          {"normal", probe.normal ? vectorJson(*probe.normal) : Json(nullptr)},
                          {"lit", lit}});
    }
    const Exposure& exposure = part.exposure;
    const Json json = {{versionKey, version},
                       {"part", part.number},
                       {"parts", part.of},
                       {"scene", part.scene},
                       {"settings", part.settings},
                       {"camera", part.camera},
                       {"warnings", part.warnings},
                       {"positions_of_run", part.positionsOfRun},
                       {"positions", std::move(positions)},
                       {"probes", std::move(probes)},
                       {"materials", namesJson(part.materials)},
                       {"nodes", namesJson(part.nodes)},
                       {"size", {exposure.width, exposure.height}},
                       {"pixels",
                        {{"lit", packed(exposure.lit)},
                         {"surface", packed(exposure.surface)},
                         {"area", packed(exposure.area)},
                         {"material", packed(exposure.material)},
                         {"node", packed(exposure.node)}}}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Part partFrom(const std::filesystem::path& path) {
    const Bytes bytes = readFile(path, largestFile);
    Json json;
    try {
        json = Json::parse(bytes.begin(), bytes.end());
    } catch (const nlohmann::json::exception& error) {
        throw InputError("'" + path.string() +
                         "' is not a part of a sunhours run: " + clauseOf(error.what()) + ".");
    }
    return partOf(json, path);
}

} // namespace edgeshade::hours
