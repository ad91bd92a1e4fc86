#include "src/hours/part_file.hpp"

#include "src/hours/part_json.hpp"
#include "src/hours/settings.hpp"

#include <cmath>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t version = 1;
constexpr const char* versionKey = "edgeshade_sunhours_part";
constexpr std::uint64_t longestSide = 65536;
constexpr std::uint64_t mostPixels = std::uint64_t{1} << 28;

/// `positions`: number of the part's positions.
Probe probeOf(const JsonField& field, std::size_t positions) {
    Probe probe;
    probe.point = finiteVector(field.member("point"));
    const JsonField normal = field.member("normal");
    if (!normal.value().is_null()) probe.normal = finiteVector(normal);
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

} // namespace

std::size_t countOfPart(std::size_t positions, std::size_t number, std::size_t of) {
    return (positions + of - number) / of;
}

std::vector<Position> ofPart(std::span<const Position> positions, std::size_t number,
                             std::size_t of) {
    std::vector<Position> some;
    for (std::size_t i = number - 1; i < positions.size(); i += of)
        some.push_back(positions[i]);
    return some;
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
                        {{"lit", packed(std::span(exposure.lit))},
                         {"surface", packed(std::span(exposure.surface))},
                         {"area", packed(std::span(exposure.area))},
                         {"material", packed(std::span(exposure.material))},
                         {"node", packed(std::span(exposure.node))}}}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Part partFrom(const std::filesystem::path& path, const Json& json) {
    const JsonField root(path, json);
    root.requireObject();
    root.requireVersion(versionKey, version);
    Part part;
    static_cast<PartNumber&>(part) = partNumberFrom(root);
    static_cast<RunHead&>(part) = runHeadFrom(root, part);
    part.camera = root.member("camera").value();
    root.member("probes").forEachItem([&](const JsonField& probe) {
        part.probes.push_back(probeOf(probe, part.positions.size()));
    });
    part.exposure = exposureOf(root, path, part);
    return part;
}

Part partFrom(const std::filesystem::path& path) {
    return partFrom(path, partJsonFrom(path));
}

} // namespace edgeshade::hours
