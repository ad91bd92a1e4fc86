#include "src/cli/light_options.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/scene/extremes.hpp"
#include "src/cli/add_options.hpp"
#include "src/cli/number_text.hpp"
#include "src/scene/color_text.hpp"
#include "src/shadow/geometry/vectors.hpp"

#include <algorithm>

namespace edgeshade::cli {
namespace {

/// Parses "#rrggbb"; the result is linear.
glm::vec3 colorFrom(const std::string& text, const std::string& option) {
    const auto color = linearFromText(text);
    if (!color) throw CLI::ValidationError(option, "'" + text + "' is no colour #rrggbb");
    return *color;
}

double intensityFrom(const std::string& text, const std::string& option) {
    const Values intensities{{}, Interval{.low = 0.0, .high = brightestLight}};
    return *numberIn(intensities, option, text);
}

/// The parts between colons; the last part takes the rest.
std::vector<std::string> partsOf(const std::string& text, std::size_t most) {
    std::vector<std::string> parts;
    std::size_t start = 0;
    while (parts.size() + 1 < most) {
        const std::size_t colon = text.find(':', start);
        if (colon == std::string::npos) break;
        parts.push_back(text.substr(start, colon - start));
        start = colon + 1;
    }
    parts.push_back(text.substr(start));
    return parts;
}

} // namespace

Light lightFrom(const std::string& text, const std::string& option, double w) {
    const std::vector<std::string> parts = partsOf(text, 3);
    Light light;
    light.position = glm::dvec4(vectorFrom(parts[0], option), w);
    if (light.position == glm::dvec4(0.0))
        throw CLI::ValidationError(option, "'" + text + "' is no direction");
    if (parts.size() > 1) light.color = colorFrom(parts[1], option);
    if (parts.size() > 2) {
        light.color *= static_cast<float>(intensityFrom(parts[2], option));
        light.photometric = true;
    }
    return light;
}

std::vector<Light> LightOptions::all() const {
    std::vector<Light> lights = typed;
    for (Light& light : lights)
        if (range && light.position.w != 0.0) light.range = *range;
    if (sun.typed()) lights.insert(lights.begin(), sun.light());
    requireFewLights(lights.size());
    return lights;
}

void ExtentOptions::giveTo(std::vector<Light>& lights) const {
    bool points = false, suns = false;
    for (Light& light : lights) {
        light.extent = light.position.w != 0.0 ? ofPoints : ofSuns;
        (light.position.w != 0.0 ? points : suns) = true;
    }
    if (ofPoints && !points)
        throw Error(ExitStatus::usage,
                    std::string(ofPoints->shape == LightExtent::Shape::sphere ? "--light-radius"
                                                                              : "--light-size") +
                        " is of point lights, and the picture has none.");
    if (ofSuns && !suns)
        throw Error(ExitStatus::usage,
                    "--sun-angle is of directional lights, and the picture has none.");
}

namespace {

/// Parses "W,H", both above 0.
glm::dvec2 rectangleFrom(const std::string& text, const std::string& option) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        throw CLI::ValidationError(option, "'" + text + "' is not of the form W,H");
    const glm::dvec2 size(numberFrom(text.substr(0, comma), option),
                          numberFrom(text.substr(comma + 1), option));
    if (!(size.x > 0.0 && size.y > 0.0))
        throw CLI::ValidationError(option, "'" + text + "' is not above 0 both ways");
    return size;
}

void addExtentOptions(CLI::App& verb, ExtentOptions& extents) {
    const auto numberOf = [&verb](const std::string& name, const std::string& text) {
        return *numberIn(optionOf(verb.get_name(), name).values, name, text);
    };
    CLI::Option* const radius =
        addOption(verb, "--light-radius", [&extents, numberOf](const std::string& text) {
            extents.ofPoints = {.shape = LightExtent::Shape::sphere,
                                .radius = numberOf("--light-radius", text)};
        });
    CLI::Option* const size = addOption(verb, "--light-size", [&](const std::string& text) {
        extents.ofPoints = {.shape = LightExtent::Shape::rectangle,
                            .size = rectangleFrom(text, "--light-size")};
    });
    size->excludes(radius);
    addOption(verb, "--light-direction", [&](const std::string& text) {
        const glm::dvec3 direction = vectorFrom(text, "--light-direction");
        if (direction == glm::dvec3(0.0))
            throw CLI::ValidationError("--light-direction", "'" + text + "' is no direction");
        extents.ofPoints->direction = unitOf(direction);
    })->needs(size);
    addOption(verb, "--sun-angle", [&extents, numberOf](const std::string& text) {
        extents.ofSuns = {.shape = LightExtent::Shape::disc,
                          .radius = 0.5 * glm::radians(numberOf("--sun-angle", text))};
    });
}

} // namespace

void addLightOptions(CLI::App& verb, LightOptions& options) {
    const auto addLights = [&](const std::string& name, double w) {
        addRepeated(verb, name, [&options, name, w](const std::string& text) {
            options.typed.push_back(lightFrom(text, name, w));
            requireFewLights(options.typed.size());
        });
    };
    addLights("--light", 1.0);
    addLights("--sun", 0.0);
    addSunOptions(verb, options.sun);
    addExtentOptions(verb, options.extents);
    CLI::Option* const lights = addWords(verb, "--lights", options.choice,
                                         std::vector{LightChoice::file, LightChoice::fallback});
    for (const char* typed : {"--light", "--sun", "--place"})
        lights->excludes(verb.get_option(typed));
    addNumber(verb, "--light-range", options.range)->needs(verb.get_option("--light"));
}

} // namespace edgeshade::cli
