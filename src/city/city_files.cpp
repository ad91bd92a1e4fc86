#include "src/city/city_files.hpp"

#include "src/city/byte_text.hpp"
#include "src/city/json_text.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

namespace edgeshade::city {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t longestPreview = 1024;

/// Words for surface kinds, in their order.
constexpr const char* kindNames[] = {"none", "ground", "roof", "wall", "other"};

/// The shortest text that reads back as the number.
std::string textOf(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string all = "\"";
    for (const char c : text)
        all += c == '"' ? "\"\"" : std::string(1, c);
    return all + '"';
}

/// Adds the attributes to the objects of a file or a feature.
void addHours(const CityMap& map, const std::map<std::string_view, const ObjectHours*>& named,
              Json& root) {
    const auto objects = root.find("CityObjects");
    if (objects == root.end()) return;
    for (auto object = objects->begin(); object != objects->end(); ++object) {
        const auto found = named.find(object.key());
        if (found == named.end()) continue;
        Json& attributes = (*object)["attributes"];
        attributes["+sun-hours"] = map.meanHoursOf(*found->second);
        attributes["+sun-hours-min"] = map.hoursOf(found->second->least);
        attributes["+sun-hours-max"] = map.hoursOf(found->second->most);
    }
}

} // namespace

std::string objectsCsvOf(const CityMap& map, const Plan& plan) {
    std::string csv = "id,building,source,cells,area_m2,mean_hours,min_hours,max_hours\n";
    for (const ObjectHours& object : map.objects)
        csv += quoted(object.object.id) + (object.object.isBuilding ? ",1," : ",0,") +
               quoted(plan.sources[object.object.source].source.file) + "," +
               std::to_string(object.cells) + "," +
               textOf(static_cast<double>(object.cells) * plan.grid * plan.grid) + "," +
               textOf(map.meanHoursOf(object)) + "," + textOf(map.hoursOf(object.least)) + "," +
               textOf(map.hoursOf(object.most)) + "\n";
    return csv;
}

Json mapReportOf(const CityMap& map, const Plan& plan) {
    std::uint64_t sum = 0;
    std::size_t count = 0;
    std::int32_t least = 0, most = 0;
    for (const std::int32_t lit : map.lit) {
        if (lit == CityMap::nothing) continue;
        least = count == 0 ? lit : std::min(least, lit);
        most = std::max(most, lit);
        sum += static_cast<std::uint64_t>(lit);
        ++count;
    }
    Json kinds;
    for (std::size_t kind = 0; kind < map.kinds.size(); ++kind)
        if (const KindHours& of = map.kinds[kind]; of.cells > 0)
            kinds[kindNames[kind]] = {
                {"cells", of.cells},
                {"mean_hours", map.hoursOfPosition * static_cast<double>(of.litSum) /
                                   static_cast<double>(of.cells)}};
    const auto buildings = std::ranges::count_if(
        map.objects, [](const ObjectHours& object) { return object.object.isBuilding; });
    const double mean =
        count == 0 ? 0.0
                   : map.hoursOfPosition * static_cast<double>(sum) / static_cast<double>(count);
    return {{"jobs", plan.jobs.size()},
            {"sources", plan.sources.size()},
            {"cells", map.lit.size()},
            {"cells_with_surface", count},
            {"grid", plan.grid},
            {"epsg", plan.epsg ? Json(*plan.epsg) : Json(nullptr)},
            {"place", {plan.schedule.place.latitude, plan.schedule.place.longitude}},
            {"north", plan.schedule.north},
            {"positions", map.positions},
            {"hours", {{"min", map.hoursOf(least)}, {"mean", mean}, {"max", map.hoursOf(most)}}},
            {"by_surface", std::move(kinds)},
            {"objects", map.objects.size()},
            {"buildings", buildings}};
}

Image previewOf(const CityMap& map, const std::function<std::uint32_t(double share)>& color) {
    const std::int64_t columns = map.region.columns(), rows = map.region.rows();
    const std::int64_t step = (std::max(columns, rows) + longestPreview - 1) / longestPreview;
    Image image;
    image.width = static_cast<int>((columns + step - 1) / step);
    image.height = static_cast<int>((rows + step - 1) / step);
    const std::int32_t most = std::max(1, *std::ranges::max_element(map.lit));
    for (std::int64_t y = 0; y < image.height; ++y)
        for (std::int64_t x = 0; x < image.width; ++x) {
            const std::int64_t row = std::min(y * step + step / 2, rows - 1),
                               column = std::min(x * step + step / 2, columns - 1);
            const std::int32_t lit = map.lit[static_cast<std::size_t>(row * columns + column)];
            const std::uint32_t rgb =
                lit == CityMap::nothing ? 0 : color(static_cast<double>(lit) / most);
            for (const std::uint32_t channel :
                 {rgb >> 16, rgb >> 8, rgb, lit == CityMap::nothing ? 0u : 255u})
                image.rgba.push_back(static_cast<std::uint8_t>(channel));
        }
    return image;
}

std::string cityJsonWithHours(const CityMap& map, const Plan& plan, std::size_t source) {
    std::map<std::string_view, const ObjectHours*> named;
    for (const ObjectHours& object : map.objects)
        if (object.object.source == source) named.emplace(object.object.id, &object);
    const Source& of = plan.sources[source].source;
    const Bytes bytes = bytesOf(plan.folder, of, plan.reading);
    const std::string_view text = textOf(bytes);
    std::string all;
    const auto add = [&](std::string_view part) {
        Json json = jsonFrom(part, "'" + (plan.folder / of.file).string() +
                                       "' has changed since the plan was made");
        addHours(map, named, json);
        all += json.dump() + "\n";
    };
    if (of.kind == SourceKind::cityJsonSequence)
        forEachLine(text, [&](std::string_view line, std::size_t) { add(line); });
    else
        add(text);
    return all;
}

} // namespace edgeshade::city
