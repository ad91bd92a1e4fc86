#include "src/cli/sunhours_way.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/headless_context.hpp"

namespace edgeshade::cli {
namespace {

/// An option typed that shapes shadow volumes or their drawing, and so has no effect by rays;
/// empty: none was.
std::string optionOfMasks(const SunHoursOptions& options) {
    const CasterChanges& changes = options.casters.changes;
    if (changes.weldTolerance || changes.autoWeld) return "--weld-tolerance";
    if (changes.flatTolerance) return "--flat-tolerance";
    if (changes.casterError) return "--caster-error";
    return options.glLimits != gl::Limits::device ? "--gl-limits" : "";
}

SunHoursWay automaticWay(const SunHoursOptions& options) {
    if (options.cutoutsCast) return {true, "masks count no cutouts"};
    if (const std::string option = optionOfMasks(options); !option.empty()) return {false, option};
    try {
        const gl::HeadlessContext context(gl::HeadlessContext::Request{});
        const gl::Capabilities& device = context.capabilities();
        if (device.isSoftware()) return {true, "the processor draws"};
        return {false, "hardware draws"};
    } catch (const Error& error) {
        if (error.status() != ExitStatus::unavailable) throw;
        return {true, "there is no GL"};
    }
}

} // namespace

SunHoursWay wayOf(const SunHoursOptions& options) {
    if (options.by == SunHoursBy::automatic) return automaticWay(options);
    if (options.by == SunHoursBy::rays) {
        if (const std::string option = optionOfMasks(options); !option.empty())
            throw Error(ExitStatus::usage, "--by rays does not go with " + option +
                                               ", which is for shadow volumes; --by masks does.");
        return {true, "--by"};
    }
    if (options.cutoutsCast)
        throw Error(ExitStatus::usage,
                    "--cast-cutouts does not go with --by masks, whose shadow volumes count no "
                    "cutouts; --by rays does, and --cast-masked casts whole triangles.");
    return {false, "--by"};
}

const char* nameOf(const SunHoursWay& way) {
    return way.byRays ? "rays" : "masks";
}

} // namespace edgeshade::cli
