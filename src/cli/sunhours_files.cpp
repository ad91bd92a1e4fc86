#include "src/cli/sunhours_files.hpp"

#include "preprocess/base/file_io.hpp"
#include "src/cli/report.hpp"
#include "src/hours/report.hpp"
#include "src/image/png16.hpp"
#include "src/plot/color_scale.hpp"
#include "src/plot/hours_sheet.hpp"

#include <cstdio>

namespace edgeshade::cli {
namespace {

std::string placeText(const hours::HoursSettings& settings) {
    char text[96];
    std::snprintf(text, sizeof text, "%.6g,%.6g", settings.latitude, settings.longitude);
    return text;
}

std::string daysText(const hours::HoursSettings& settings) {
    return settings.days == 1 ? settings.from : settings.from + " to " + settings.to;
}

Bytes pictureOf(const hours::Part& whole, const hours::HoursSettings& settings) {
    const hours::Exposure& exposure = whole.exposure;
    plot::HoursSheet sheet;
    sheet.title = "Hours of sun, " + settings.file;
    sheet.subtitles = {daysText(settings) + ", UTC" + sun::textOf(settings.offset) + ", " +
                           placeText(settings),
                       std::to_string(whole.positions.size()) + " sun positions, one every " +
                           std::to_string(settings.step.count()) + " min"};
    if (whole.settings.value("plan", nlohmann::ordered_json()) == true)
        sheet.subtitles.front() += ", north up";
    if (settings.preset) sheet.subtitles.push_back(std::string(settings.preset->source));
    sheet.width = exposure.width;
    sheet.height = exposure.height;
    sheet.threshold = hours::totalThreshold(settings);
    const double possible = hours::possibleHours(whole, settings);
    sheet.most = possible > 0.0 ? possible : 1.0;
    sheet.rgba.reserve(4 * exposure.lit.size());
    for (std::size_t i = 0; i < exposure.lit.size(); ++i) {
        const plot::Color color =
            plot::evenColor(hours::hoursOf(exposure.lit[i], settings.step) / sheet.most);
        for (const int shift : {16, 8, 0})
            sheet.rgba.push_back(static_cast<std::uint8_t>(color >> shift));
        sheet.rgba.push_back(exposure.surface[i] != 0 ? 255 : 0);
    }
    return plot::hoursPng(sheet);
}

Bytes countsOf(const hours::Exposure& exposure) {
    std::vector<std::uint16_t> greyAlpha;
    greyAlpha.reserve(2 * exposure.lit.size());
    for (std::size_t i = 0; i < exposure.lit.size(); ++i) {
        const bool surface = exposure.surface[i] != 0;
        greyAlpha.push_back(surface ? exposure.lit[i] : 0);
        greyAlpha.push_back(surface ? 65535 : 0);
    }
    return encodeGreyAlphaPng(greyAlpha, exposure.width, exposure.height);
}

std::string summaryOf(const hours::Part& whole, const hours::HoursSettings& settings,
                      const nlohmann::ordered_json& report) {
    const auto& found = report["hours"];
    char text[160];
    std::snprintf(text, sizeof text,
                  ": %d x %d, %zu sun positions, UTC%s; hours of sun %.4g to %.4g, mean %.4g",
                  whole.exposure.width, whole.exposure.height, whole.positions.size(),
                  sun::textOf(settings.offset).c_str(), found["min"].get<double>(),
                  found["max"].get<double>(), found["mean"].get<double>());
    std::string all = text;
    if (settings.threshold) {
        std::snprintf(text, sizeof text, "; %.4g h a day or more on %.1f %% of the area",
                      *settings.threshold, report["area_above_threshold_percent"].get<double>());
        all += text;
    }
    return all;
}

} // namespace

void writeSunHours(const hours::Part& whole, const std::string& source,
                   const SunHoursFiles& files) {
    const std::filesystem::path path(source);
    const hours::HoursSettings settings =
        hours::hoursSettings(JsonField(path, whole.settings, "settings"));
    // Make everything before writing anything.
    const nlohmann::ordered_json report = hours::reportOf(whole, settings);
    const Bytes picture = pictureOf(whole, settings);
    const Bytes counts = files.counts.empty() ? Bytes() : countsOf(whole.exposure);
    writeFile(files.picture, picture);
    if (!files.counts.empty()) writeFile(files.counts, counts);
    printResult(files.picture + summaryOf(whole, settings, report), files.report);
    writeReport(report, files.report);
}

} // namespace edgeshade::cli
