#include "src/cli/light_options.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/scene/extremes.hpp"
#include "src/cli/choices.hpp"
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
    const double intensity = numberFrom(text, option);
    if (intensity < 0.0) throw CLI::ValidationError(option, "'" + text + "' is below 0");
    if (intensity > brightestLight)
        throw CLI::ValidationError(option, "'" + text + "' is brighter than 1e12");
    return intensity;
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
    CLI::Option* radius =
        verb.add_option_function<std::string>(
                "--light-radius",
                [&](const std::string& text) {
                    const double value = numberFrom(text, "--light-radius");
                    if (!(value > 0.0))
                        throw CLI::ValidationError("--light-radius",
                                                   "'" + text + "' is not above 0");
                    extents.ofPoints = {.shape = LightExtent::Shape::sphere, .radius = value};
                },
                "Point lights are spheres that large, in scene units, with soft shadows (points, "
                "with hard ones)")
            ->type_name("R");
    CLI::Option* size =
        verb.add_option_function<std::string>(
                "--light-size",
                [&](const std::string& text) {
                    extents.ofPoints = {.shape = LightExtent::Shape::rectangle,
                                        .size = rectangleFrom(text, "--light-size")};
                },
                "Point lights are rectangles that wide and high, in scene units, and shine to one "
                "side")
            ->type_name("W,H")
            ->excludes(radius);
    verb.add_option_function<std::string>(
            "--light-direction",
            [&](const std::string& text) {
                const glm::dvec3 direction = vectorFrom(text, "--light-direction");
                if (direction == glm::dvec3(0.0))
                    throw CLI::ValidationError("--light-direction",
                                               "'" + text + "' is no direction");
                extents.ofPoints->direction = unitOf(direction);
            },
            "What such rectangles face, their width level (down)")
        ->type_name("X,Y,Z")
        ->needs(size);
    verb.add_option_function<std::string>(
            "--sun-angle",
            [&](const std::string& text) {
                const double degrees = numberFrom(text, "--sun-angle");
                if (!(degrees > 0.0 && degrees <= 90.0))
                    throw CLI::ValidationError("--sun-angle",
                                               "'" + text + "' is not above 0 and at most 90");
                extents.ofSuns = {.shape = LightExtent::Shape::disc,
                                  .radius = 0.5 * glm::radians(degrees)};
            },
            "Directional lights are discs that measure so many degrees, with soft shadows; the "
            "sun's is 0.53 (one direction)")
        ->type_name("DEG");
}

} // namespace

void addLightOptions(CLI::App& verb, LightOptions& options) {
    // One callback per occurrence keeps points and suns in the order in which they were typed.
    const auto addLights = [&](const std::string& name, double w, const std::string& help) {
        verb.add_option_function<std::vector<std::string>>(
                name,
                [&options, name, w](const std::vector<std::string>& texts) {
                    for (const std::string& text : texts) {
                        options.typed.push_back(lightFrom(text, name, w));
                        requireFewLights(options.typed.size());
                    }
                },
                help)
            ->type_name("X,Y,Z[:#RRGGBB[:INTENSITY]]")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
            ->trigger_on_parse();
    };
    addLights("--light", 1.0,
              "A point light, perhaps with a colour and candela, with which it falls off with the "
              "square of the distance; may be repeated (the file's lights, or a sun from above)");
    addLights("--sun", 0.0,
              "A directional light, the direction towards it, perhaps with a colour and lux; may "
              "be repeated");
    addSunOptions(verb, options.sun);
    addExtentOptions(verb, options.extents);
    addChoice(verb, "--lights", options.choice,
              {{"file", LightChoice::file}, {"default", LightChoice::fallback}},
              "Whose lights there are where none are typed: the file's if it has some, or a sun "
              "from above (file)");
    for (const char* typed : {"--light", "--sun", "--place"})
        verb.get_option("--lights")->excludes(verb.get_option(typed));
    // Parse after all lights: the range applies to them.
    verb.add_option_function<std::string>(
            "--light-range",
            [&](const std::string& text) {
                const double range = numberFrom(text, "--light-range");
                if (range <= 0.0)
                    throw CLI::ValidationError("--light-range", "'" + text + "' is not above 0");
                for (Light& light : options.typed)
                    if (light.position.w != 0.0) light.range = range;
            },
            "How far the point lights reach, in scene units; what is farther away gets nothing of "
            "them (everywhere)")
        ->type_name("R")
        ->needs(verb.get_option("--light"));
}

} // namespace edgeshade::cli
