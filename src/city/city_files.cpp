#include "src/city/city_files.hpp"

#include "src/city/byte_text.hpp"
#include "src/city/json_text.hpp"
#include "src/city/planned_bytes.hpp"

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

using ObjectsByName = std::map<std::string_view, const ObjectHours*>;

/// Adds the attributes to the objects of a file or a feature.
void addHours(const ObjectsByName& named, double hours, Json& root) {
    const auto objects = root.find("CityObjects");
    if (objects == root.end()) return;
    for (auto object = objects->begin(); object != objects->end(); ++object) {
        const auto found = named.find(object.key());
        if (found == named.end()) continue;
        Json& attributes = (*object)["attributes"];
        attributes["+sun-hours"] = found->second->meanLit() * hours;
        attributes["+sun-hours-min"] = found->second->least * hours;
        attributes["+sun-hours-max"] = found->second->most * hours;
    }
}

} // namespace

std::string objectRowsOf(std::span<const ObjectHours> objects, const Plan& plan) {
    const double hours = hoursOfPosition(plan);
    std::string csv;
    for (const ObjectHours& object : objects)
        csv += quoted(object.object.id) + (object.object.isBuilding ? ",1," : ",0,") +
               quoted(plan.sources[object.object.source].source.file) + "," +
               std::to_string(object.cells) + "," +
               textOf(static_cast<double>(object.cells) * plan.grid * plan.grid) + "," +
               textOf(object.meanLit() * hours) + "," + textOf(object.least * hours) + "," +
               textOf(object.most * hours) + "\n";
    return csv;
}

Json mapReportOf(const CityHours& map, const Plan& plan) {
    const double hours = hoursOfPosition(plan);
    const auto meanOf = [&](std::uint64_t litSum, std::size_t cells) {
        return cells == 0 ? 0.0 : hours * static_cast<double>(litSum) / static_cast<double>(cells);
    };
    Json kinds;
    for (std::size_t kind = 0; kind < map.kinds.size(); ++kind)
        if (const KindHours& of = map.kinds[kind]; of.cells > 0)
            kinds[kindNames[kind]] = {{"cells", of.cells},
                                      {"mean_hours", meanOf(of.litSum, of.cells)}};
    return {{"jobs", plan.jobs.size()},
            {"sources", plan.sources.size()},
            {"cells", plan.region.count()},
            {"cells_with_surface", map.cells},
            {"cells_held", map.cellsHeld},
            {"grid", plan.grid},
            {"epsg", plan.epsg ? Json(*plan.epsg) : Json(nullptr)},
            {"place", {plan.schedule.place.latitude, plan.schedule.place.longitude}},
            {"north", plan.schedule.north},
            {"positions", map.positions},
            {"hours",
             {{"min", map.least * hours},
              {"mean", meanOf(map.litSum, map.cells)},
              {"max", map.most * hours}}},
            {"by_surface", std::move(kinds)},
            {"objects", map.objects},
            {"buildings", map.buildings}};
}

Preview::Preview(const CellRange& region)
    : columns_(region.columns()), rows_(region.rows()),
      step_((std::max(columns_, rows_) + longestPreview - 1) / longestPreview) {}

void Preview::add(std::span<const std::int32_t> lit) {
    const std::int64_t row = next_++;
    const bool isLast = row + 1 == rows_ && row % step_ < step_ / 2;
    if (row % step_ != step_ / 2 && !isLast) return;
    for (std::int64_t left = 0; left < columns_; left += step_)
        lit_.push_back(lit[static_cast<std::size_t>(std::min(left + step_ / 2, columns_ - 1))]);
}

Image Preview::image(std::int32_t most,
                     const std::function<std::uint32_t(double share)>& color) const {
    Image image;
    image.width = static_cast<int>((columns_ + step_ - 1) / step_);
    image.height = static_cast<int>((rows_ + step_ - 1) / step_);
    for (const std::int32_t lit : lit_) {
        const std::uint32_t rgb =
            lit == nothing ? 0 : color(static_cast<double>(lit) / std::max(1, most));
        for (const std::uint32_t channel : {rgb >> 16, rgb >> 8, rgb, lit == nothing ? 0u : 255u})
            image.rgba.push_back(static_cast<std::uint8_t>(channel));
    }
    return image;
}

std::string cityJsonWithHours(std::span<const ObjectHours> objects, const Plan& plan,
                              const PlannedSource& planned) {
    ObjectsByName named;
    for (const ObjectHours& object : objects)
        named.emplace(object.object.id, &object);
    const Bytes bytes = plannedBytes(plan, planned);
    const std::string_view text = textOf(bytes);
    const std::string where =
        "'" + (plan.folder / planned.source.file).string() + "' is not valid JSON";
    std::string all;
    const auto add = [&](std::string_view part) {
        Json json = jsonFrom(part, where);
        addHours(named, hoursOfPosition(plan), json);
        all += json.dump() + "\n";
    };
    if (planned.source.kind == SourceKind::cityJsonSequence)
        forEachLine(text, [&](std::string_view line, std::size_t) { add(line); });
    else
        add(text);
    return all;
}

} // namespace edgeshade::city
