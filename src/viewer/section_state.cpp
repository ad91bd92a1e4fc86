#include "src/viewer/section_state.hpp"

#include "src/scene/section_text.hpp"
#include "src/settings/settings.hpp"

#include <limits>

namespace edgeshade::viewer {
namespace {

constexpr std::size_t mostPlanes = Section::mostPlanes + 6; // those of a box too
constexpr double largest = std::numeric_limits<double>::max();

std::vector<glm::dvec4> planesFrom(const Field& field) {
    if (field.arraySize() < 1 || field.arraySize() > mostPlanes)
        field.fail("an array of 1 to " + std::to_string(mostPlanes) + " planes");
    std::vector<glm::dvec4> planes;
    field.forEachItem([&](const Field& item) {
        planes.push_back(item.place<4>(-largest, largest));
        if (!isSectionPlane(planes.back())) item.fail("a plane whose first three numbers aren't 0");
    });
    return planes;
}

} // namespace

glm::vec3 defaultFill() {
    return fillFromText("#cc5540")->value();
}

std::optional<Section> sectionFrom(const Field& field) {
    if (field.isNull()) return std::nullopt;
    if (!field.isObject()) field.fail("null or an object");
    Section section;
    section.fill = defaultFill();
    field.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "planes") {
            section.planes = planesFrom(value);
        } else if (key == "shadows") {
            section.shadows = value.in(settings::sectionShadows.domain);
        } else if (key == "fill") {
            const auto fill = fillFromText(value.word());
            if (!fill) value.fail("none or a colour #rrggbb");
            section.fill = *fill;
        } else {
            return false;
        }
        return true;
    });
    if (section.planes.empty()) field.fail("null or an object with 'planes'");
    return section;
}

nlohmann::ordered_json toJson(const std::optional<Section>& section) {
    if (!section) return nullptr;
    nlohmann::ordered_json planes = nlohmann::ordered_json::array();
    for (const glm::dvec4& plane : section->planes)
        planes.push_back({plane.x, plane.y, plane.z, plane.w});
    return {{"planes", planes},
            {"shadows", wordOf(settings::sectionShadows.domain, section->shadows)},
            {"fill", textOfFill(section->fill)}};
}

} // namespace edgeshade::viewer
