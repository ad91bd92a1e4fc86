#include "src/cli/section_options.hpp"

#include "preprocess/base/error.hpp"
#include "src/cli/number_text.hpp"
#include "src/cli/setting_text.hpp"
#include "src/scene/section_text.hpp"

namespace edgeshade::cli {
namespace {

glm::dvec4 planeFrom(const std::string& text) {
    const auto [x, y, z, d] = numbersFrom<4>(text, "--section", "NX,NY,NZ,D");
    const glm::dvec4 plane(x, y, z, d);
    if (!isSectionPlane(plane))
        throw CLI::ValidationError("--section", "'" + text + "' has no direction NX,NY,NZ");
    return plane;
}

std::vector<glm::dvec4> boxFrom(const std::string& text) {
    const auto of = numbersFrom<6>(text, "--section-box", "X0,Y0,Z0,X1,Y1,Z1");
    const glm::dvec3 low(of[0], of[1], of[2]), high(of[3], of[4], of[5]);
    if (!glm::all(glm::lessThan(low, high)))
        throw CLI::ValidationError("--section-box",
                                   "'" + text + "' is no box from a low to a high corner");
    return sectionBox(low, high);
}

} // namespace

Section SectionOptions::section() const {
    if (typedHow && !any())
        throw Error(ExitStatus::usage, "--section-shadows and --section-fill have no effect "
                                       "without --section or --section-box.");
    Section section;
    section.planes = planes;
    section.planes.insert(section.planes.end(), box.begin(), box.end());
    section.shadows = shadows;
    section.fill = *fillFromText(fill);
    return section;
}

void addSectionOptions(CLI::App& verb, SectionOptions& options) {
    addRepeated(verb, "--section", [&](const std::string& text) {
        if (options.planes.size() == Section::mostPlanes)
            throw CLI::ValidationError("--section",
                                       "'" + text + "' is one plane too many; at most " +
                                           std::to_string(Section::mostPlanes) + " can be typed");
        options.planes.push_back(planeFrom(text));
    });
    addOption(verb, "--section-box", [&](const std::string& text) { options.box = boxFrom(text); });
    addOption(verb, "--section-shadows", [&](const std::string& text) {
        read(settings::sectionShadows.domain, "--section-shadows", text, options.shadows);
        options.typedHow = true;
    });
    addOption(verb, "--section-fill", [&](const std::string& text) {
        if (!fillFromText(text))
            throw CLI::ValidationError("--section-fill",
                                       "'" + text + "' is neither none nor a colour #rrggbb");
        options.fill = text;
        options.typedHow = true;
    });
    options.typedHow = false; // defaults are set by adding
}

} // namespace edgeshade::cli
