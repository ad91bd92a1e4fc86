#include "src/cli/options.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/limit_options.hpp"
#include "src/shadow/geometry/framing.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>
#include <tuple>

namespace edgeshade::cli {
namespace {

/// A finite number that is the whole text.
double numberFrom(std::string_view text, const std::string& option) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() ||
        !std::isfinite(value))
        throw CLI::ValidationError(option, "'" + std::string(text) + "' is no finite number");
    return value;
}

/// So many finite numbers with commas in between. `form`: what the text should be.
template <std::size_t count>
std::array<double, count> numbersFrom(const std::string& text, const std::string& option,
                                      const std::string& form) {
    std::array<double, count> numbers;
    std::size_t start = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t comma = text.find(',', start);
        if ((comma == std::string::npos) != (i + 1 == count))
            throw CLI::ValidationError(option, "'" + text + "' is not " + form);
        numbers[i] = numberFrom(std::string_view(text).substr(start, comma - start), option);
        start = comma + 1;
    }
    return numbers;
}

/// "x,y,z".
glm::dvec3 vectorFrom(const std::string& text, const std::string& option) {
    return glm::make_vec3(numbersFrom<3>(text, option, "of the form x,y,z").data());
}

/// Column by column.
glm::dmat4 matrixFrom(const std::string& text, const std::string& option) {
    return glm::make_mat4(numbersFrom<16>(text, option, "16 numbers with commas").data());
}

const Choices<gl::Limits> limitNames = {{"device", gl::Limits::device},
                                        {"es2-minimum", gl::Limits::es2Minimum}};

template <class Use>
void addTextOption(CLI::App& verb, const std::string& name, const std::string& type,
                   const std::string& help, Use use) {
    verb.add_option_function<std::string>(name, use, help)->type_name(type);
}

void addViewOptions(CLI::App& verb, ViewOptions& options) {
    addTextOption(verb, "--size", "WxH",
                  "Picture size in pixels (" + std::to_string(options.width) + "x" +
                      std::to_string(options.height) + ")",
                  [&](const std::string& text) {
                      std::tie(options.width, options.height) = sizeFrom(text, "--size");
                  });
    addTextOption(
        verb, "--camera-from", "X,Y,Z", "Where the eye is (frames the scene)",
        [&](const std::string& text) { options.from = vectorFrom(text, "--camera-from"); });
    addTextOption(verb, "--camera-to", "X,Y,Z", "What the eye looks at (middle of the scene)",
                  [&](const std::string& text) { options.to = vectorFrom(text, "--camera-to"); });
    addTextOption(verb, "--camera-matrix", "M0,...,M15",
                  "A view matrix, world to camera, column by column, in place of both",
                  [&](const std::string& text) {
                      options.cameraMatrix = rigidView(matrixFrom(text, "--camera-matrix"));
                  });
    for (const char* other : {"--camera-from", "--camera-to"})
        verb.get_option("--camera-matrix")->excludes(verb.get_option(other));
    addTextOption(verb, "--ortho", "HEIGHT",
                  "An orthographic picture, so many scene units high (perspective)",
                  [&](const std::string& text) {
                      options.orthoHeight = numberFrom(text, "--ortho");
                      if (*options.orthoHeight <= 0.0)
                          throw CLI::ValidationError("--ortho", "'" + text + "' is not above 0");
                  });
    addTextOption(verb, "--fov", "DEG", "Vertical field of view in degrees (45)",
                  [&](const std::string& text) {
                      options.fovDegrees = numberFrom(text, "--fov");
                      if (options.fovDegrees <= 0.0 || options.fovDegrees >= 180.0)
                          throw CLI::ValidationError("--fov",
                                                     "'" + text + "' is not between 0 and 180");
                  });
    addTextOption(verb, "--near", "D|auto",
                  "Distance of the near plane; auto: as far out as what is visible allows (auto)",
                  [&](const std::string& text) {
                      if (text == "auto") return options.depth.near.reset();
                      options.depth.near = numberFrom(text, "--near");
                      if (*options.depth.near <= 0.0)
                          throw CLI::ValidationError("--near", "'" + text + "' is not above 0");
                  });
    // One callback an occurrence keeps points and suns in the order in which they were typed.
    const auto addLights = [&](const std::string& name, double w, const std::string& help) {
        verb.add_option_function<std::vector<std::string>>(
                name,
                [&options, name, w](const std::vector<std::string>& texts) {
                    for (const std::string& text : texts) {
                        const glm::dvec3 position = vectorFrom(text, name);
                        if (w == 0.0 && position == glm::dvec3(0.0))
                            throw CLI::ValidationError(name, "'" + text + "' is no direction");
                        options.lights.push_back({glm::dvec4(position, w)});
                        requireFewLights(options.lights.size());
                    }
                },
                help)
            ->type_name("X,Y,Z")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
            ->trigger_on_parse();
    };
    addLights("--light", 1.0, "A point light; may be repeated (a sun from above)");
    addLights("--sun", 0.0, "A directional light, the direction towards it; may be repeated");
    // Not parsed before all lights are: theirs are.
    verb.add_option_function<std::string>(
            "--light-range",
            [&](const std::string& text) {
                const double range = numberFrom(text, "--light-range");
                if (range <= 0.0)
                    throw CLI::ValidationError("--light-range", "'" + text + "' is not above 0");
                for (Light& light : options.lights)
                    if (light.position.w != 0.0) light.range = range;
            },
            "How far the point lights reach, in scene units; what is farther away gets nothing of "
            "them (everywhere)")
        ->type_name("R")
        ->needs(verb.get_option("--light"));
}

} // namespace

std::pair<int, int> sizeFrom(const std::string& text, const std::string& option) {
    int values[2] = {};
    const char* at = text.data();
    const char* end = text.data() + text.size();
    for (int i = 0; i < 2; ++i) {
        const auto result = std::from_chars(at, end, values[i]);
        const bool separated = i == 1 ? result.ptr == end : result.ptr != end && *result.ptr == 'x';
        if (result.ec != std::errc() || !separated || values[i] < 1 || values[i] > 65536)
            throw CLI::ValidationError(option, "'" + text +
                                                   "' is not of the form WIDTHxHEIGHT with "
                                                   "numbers from 1 to 65536");
        at = result.ptr + 1;
    }
    return {values[0], values[1]};
}

CLI::Validator finite() {
    return CLI::Validator(
        [](const std::string& text) {
            return std::isfinite(std::strtod(text.c_str(), nullptr)) ? std::string()
                                                                     : text + " is not finite";
        },
        "");
}

CasterSettings CasterChanges::on(CasterSettings settings) const {
    settings.weldTolerance = weldTolerance.value_or(settings.weldTolerance);
    settings.flatTolerance = flatTolerance.value_or(settings.flatTolerance);
    settings.casterError = casterError.value_or(settings.casterError);
    return settings;
}

void addCasterChanges(CLI::App& verb, CasterChanges& changes) {
    const auto add = [&](const std::string& name, const std::string& type,
                         std::optional<double>& value, double end, const std::string& help) {
        addTextOption(verb, name, type, help, [&value, name, end](const std::string& text) {
            value = numberFrom(text, name);
            if (*value < 0.0) throw CLI::ValidationError(name, "'" + text + "' is below 0");
            if (*value >= end)
                throw CLI::ValidationError(name, "'" + text + "' is not below " +
                                                     std::to_string(static_cast<int>(end)));
        });
    };
    add("--weld-tolerance", "D", changes.weldTolerance, INFINITY,
        "Vertices closer than this, in scene units, become one (0: only equal ones)");
    add("--flat-tolerance", "DEG", changes.flatTolerance, flatToleranceEnd,
        "Edges that bend no more than this, in degrees, are taken for flat and cast nothing; of "
        "plane-pair records (0: exactly flat ones)");
    add("--caster-error", "D", changes.casterError, INFINITY,
        "Shadow volumes are those of simplified casters, about this far off, in scene units; what "
        "is drawn stays as it is (0: not simplified)");
}

void addCasterOptions(CLI::App& verb, CasterOptions& options) {
    addCasterChanges(verb, options.changes);
    verb.add_flag_callback(
        "--cast-masked", [&] { options.castMasked = true; },
        "MASK and BLEND surfaces cast shadows too, of their whole triangles");
}

void addSamplesOption(CLI::App& verb, int& samples) {
    verb.add_option("--samples", samples, "Samples a pixel for antialiasing (0: none)")
        ->check(CLI::Range(0, 64))
        ->type_name("N");
}

void addSceneOptions(CLI::App& verb, SceneOptions& options) {
    addViewOptions(verb, options.view);
    addCasterOptions(verb, options.casters);
    addChoice(verb, "--gl-limits", options.glLimits, limitNames,
              "What is used of the GL: all that the device has, or only what every OpenGL ES 2.0 "
              "has: no extensions, 8 attributes, 16 bits of depth (device)");
    verb.add_option("--variant", options.variant,
                    "Which of the scene's variants of materials is drawn; info lists them (the "
                    "scene's own materials)")
        ->type_name("NAME");
    addLimitOptions(verb, options.limits);
}

std::string glLimitsName(gl::Limits limits) {
    for (const auto& [name, value] : limitNames)
        if (value == limits) return name;
    return "";
}

void addReportOption(CLI::App& verb, std::string& path) {
    verb.add_option("--report", path, "Write a JSON report to this file; - is standard output")
        ->type_name("FILE");
}

Camera cameraFor(const ViewOptions& options, const Scene& scene) {
    const Camera framing = framingCamera(scene, options.fovDegrees, options.aspect());
    const Camera camera{options.from.value_or(framing.from), options.to.value_or(framing.to),
                        options.fovDegrees};
    if (camera.from == camera.to)
        throw Error(ExitStatus::usage,
                    "--camera-from and --camera-to are the same point, so the camera has no "
                    "direction.");
    return camera;
}

FrameRequest requestFor(const ViewOptions& options, const Scene& scene) {
    if (options.orthoHeight && options.depth.near)
        throw Error(ExitStatus::usage,
                    "--near does not go with --ortho, whose picture shows all that there is before "
                    "and behind the camera.");
    FrameRequest request;
    request.frustum = frustumOf(cameraFor(options, scene), options.aspect(), options.orthoHeight);
    if (options.cameraMatrix) request.frustum.viewFromWorld = *options.cameraMatrix;
    request.width = options.width;
    request.height = options.height;
    request.depth = options.depth;
    request.lights = options.lights;
    if (request.lights.empty()) request.lights.push_back(defaultLight());
    return request;
}

} // namespace edgeshade::cli
