#include "src/hours/surfaces/html_report.hpp"

#include "preprocess/base/base64.hpp"
#include "preprocess/base/markup.hpp"
#include "src/image/png.hpp"
#include "src/sun/direction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

constexpr int pictureWidth = 1000, pictureHeight = 620;
/// Where the two pictures are seen from: azimuths, and an altitude, in degrees.
constexpr double fromSouthWest = 215.0, fromNorthEast = 35.0, eyeAltitude = 35.0;
/// Colours of windows that pass and that don't, distinct without red and green, and of cells that
/// are left out.
constexpr DisplayColor passing = 0x0072B2, failing = 0xD55E00, leftOut = 0x808080;
/// Windows up to which pictures have their numbers.
constexpr std::size_t mostNumbers = 200;

constexpr const char* style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #111; max-width: 1000px; margin: 2em auto;
  padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.15em; margin-top: 1.6em; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: .25em .6em; border-bottom: 1px solid #ccc;
  vertical-align: top; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
td.hash { font-family: monospace; overflow-wrap: anywhere; }
.verdict { font-size: 1.2em; font-weight: bold; border: 2px solid; padding: .4em .8em;
  display: inline-block; }
.passes { color: #0072b2; } .fails { color: #b34700; }
figure { margin: 1em 0; } figure svg { width: 100%; height: auto; border: 1px solid #ccc; }
figcaption { color: #444; }
tr { break-inside: avoid; } thead { display: table-header-group; }
@page { size: A4; margin: 15mm; }
@media print { body { max-width: none; margin: 0; font-size: 10pt; } figure { break-inside: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
)";

std::string rounded(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string colorText(DisplayColor color) {
    char text[8];
    std::snprintf(text, sizeof text, "#%06x", color);
    return text;
}

std::string cell(const std::string& text, const char* kind = nullptr) {
    return (kind ? std::string("<td class=\"") + kind + "\">" : std::string("<td>")) + text +
           "</td>";
}

std::string verdictText(bool passes) {
    return passes ? "<span class=\"passes\">pass</span>" : "<span class=\"fails\">fail</span>";
}

/// The page, part by part.
class Page {
  public:
    Page(const SurfaceRun& run, const HoursSettings& settings, const Json& report,
         std::span<const WorldTriangle> scene, const ReportColors& colors)
        : run_(run), settings_(settings), report_(report), scene_(scene), colors_(colors) {}

    std::string text() {
        const std::string title =
            (settings_.preset ? std::string(settings_.preset->source) : "Hours of sun") + ": " +
            settings_.file;
        page_ = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                escapedForMarkup(title) + "</title><style>" + style +
                "</style></head>\n<body>\n<h1>" + escapedForMarkup(title) + "</h1>\n";
        addVerdict();
        addPicture(fromSouthWest, "From the south-west.");
        addPicture(fromNorthEast, "From the north-east.");
        addLegend();
        if (!hasRule())
            addNodes();
        else if (run_.ofWindows)
            addWindows();
        else
            addGardens();
        addSettings();
        addFiles();
        addWarnings();
        page_ += "</body></html>\n";
        return std::move(page_);
    }

  private:
    bool hasRule() const { return report_.contains("rule"); }
    bool ofEnergy() const { return !run_.light.directKwh.empty(); }

    std::string daysText() const {
        return settings_.days == 1 ? settings_.from : settings_.from + " to " + settings_.to;
    }

    void addVerdict() {
        if (!hasRule()) {
            page_ += "<p>" + daysText() + ": " +
                     rounded(report_["hours"]["mean"].get<double>(), 2) +
                     " hours of sun on average, on " + rounded(report_["area"].get<double>(), 2) +
                     " m².</p>\n";
            return;
        }
        const Json& rule = report_["rule"];
        const bool passes = rule["passes"].get<bool>();
        page_ += std::string("<p class=\"verdict ") + (passes ? "passes" : "fails") + "\">" +
                 std::to_string(rule["passing"].get<std::size_t>()) + " of " +
                 std::to_string(rule["checks"].size()) + " " + rule["of"].get<std::string>() +
                 " pass</p>\n<p>Wanted: at least " + rounded(*settings_.threshold, 2) +
                 " hours of sun a day" +
                 (run_.ofWindows ? " at the middle of a window" : " on half of a garden's area") +
                 ", on " + daysText() + ".</p>\n";
    }

    DisplayColor colorOf(std::size_t i) const {
        if (hasRule() && run_.ofWindows)
            return report_["rule"]["checks"][i]["passes"].get<bool>() ? passing : failing;
        if (!run_.isCounted(i)) return leftOut;
        return colors_.scale((ofEnergy() ? run_.light.directKwh[i] : run_.hoursOf(i)) /
                             colors_.most);
    }

    void addPicture(double azimuth, const char* caption) {
        const glm::dvec3 towardsEye =
            sun::towardsSun({azimuth, eyeAltitude, eyeAltitude}, run_.settings.value("north", 0.0));
        const CellsPicture picture = pictureOf(
            run_, scene_, [&](std::size_t i) { return colorOf(i); }, towardsEye, pictureWidth,
            pictureHeight);
        const std::string size = std::to_string(pictureWidth), tall = std::to_string(pictureHeight);
        page_ += "<figure><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + " " +
                 tall + "\"><image width=\"" + size + "\" height=\"" + tall +
                 "\" href=\"data:image/png;base64," +
                 base64(encodePng(picture.rgba, picture.width, picture.height)) + "\"/>";
        if (run_.ofWindows && picture.places.size() <= mostNumbers)
            for (std::size_t i = 0; i < picture.places.size(); ++i)
                if (const std::optional<glm::dvec2>& at = picture.places[i])
                    page_ += "<text x=\"" + rounded(at->x, 1) + "\" y=\"" +
                             rounded(at->y - 8.0, 1) +
                             "\" font-size=\"14\" font-family=\"sans-serif\" font-weight=\"bold\" "
                             "text-anchor=\"middle\" fill=\"#fff\" stroke=\"#000\" "
                             "stroke-width=\"2.5\" paint-order=\"stroke\">" +
                             std::to_string(i + 1) + "</text>";
        page_ += std::string("</svg><figcaption>") + caption + "</figcaption></figure>\n";
    }

    void addLegend() {
        const auto swatch = [](DisplayColor color, const std::string& text) {
            return "<span style=\"display:inline-block;width:1.2em;height:1em;background:" +
                   colorText(color) + "\"></span> " + text + "&emsp;";
        };
        if (hasRule() && run_.ofWindows) {
            page_ += "<p>" + swatch(passing, "pass") + swatch(failing, "fail") +
                     "numbers as in the table</p>\n";
            return;
        }
        std::string stops;
        for (int i = 0; i <= 16; ++i)
            stops += (i == 0 ? "" : ",") + colorText(colors_.scale(i / 16.0));
        const std::string unit = ofEnergy() ? " kWh/m² of the direct beam" : " hours";
        page_ += "<p>0 <span style=\"display:inline-block;width:16em;height:1em;background:"
                 "linear-gradient(to right," +
                 stops + ")\"></span> " + rounded(colors_.most, 2) + unit + "&emsp;" +
                 swatch(leftOut, "left out") + "</p>\n";
    }

    void startTable(const char* title, const std::vector<const char*>& columns) {
        page_ += std::string("<h2>") + title + "</h2>\n<table><thead><tr>";
        for (const char* column : columns)
            page_ += std::string("<th>") + column + "</th>";
        page_ += "</tr></thead><tbody>\n";
    }
    void endTable() { page_ += "</tbody></table>\n"; }

    /// "09:10-12:40", with the day if there are several.
    std::string timesText(const Json& lit) const {
        std::string all;
        for (const Json& interval : lit) {
            const auto from = interval[0].get<std::string>(), to = interval[1].get<std::string>();
            const std::string day = settings_.days > 1 ? from.substr(0, 10) + " " : "";
            all += (all.empty() ? "" : ", ") + day + from.substr(11, 5) + "–" + to.substr(11, 5);
        }
        return all;
    }

    void addWindows() {
        startTable("Windows", {"No.", "window", "material", "date", "hours a day", "wanted",
                               "times with sun", "result"});
        std::size_t number = 0;
        for (const Json& check : report_["rule"]["checks"]) {
            const std::string note = check["inside_solid"].get<bool>() ? " (inside a solid)" : "";
            page_ += "<tr>" + cell(std::to_string(++number), "number") +
                     cell(escapedForMarkup(check["name"].get<std::string>()) + note) +
                     cell(escapedForMarkup(check["material"].get<std::string>())) +
                     cell(daysText()) + cell(rounded(check["hours"].get<double>(), 2), "number") +
                     cell(rounded(*settings_.threshold, 2), "number") +
                     cell(timesText(check["lit"])) +
                     cell(verdictText(check["passes"].get<bool>())) + "</tr>\n";
        }
        endTable();
    }

    void addGardens() {
        startTable("Gardens", {"garden", "area, m²", "date", "mean hours a day",
                               "area with enough, %", "wanted, %", "result"});
        for (const Json& check : report_["rule"]["checks"])
            page_ +=
                "<tr>" + cell(escapedForMarkup(check["name"].get<std::string>())) +
                cell(rounded(check["area"].get<double>(), 2), "number") + cell(daysText()) +
                cell(rounded(check["hours"].get<double>(), 2), "number") +
                cell(rounded(check["area_above_threshold_percent"].get<double>(), 1), "number") +
                cell(rounded(report_["rule"]["needed_area_percent"].get<double>(), 0), "number") +
                cell(verdictText(check["passes"].get<bool>())) + "</tr>\n";
        endTable();
    }

    void addNodes() {
        std::vector<std::pair<const char*, const char*>> more; // key and heading
        if (settings_.threshold)
            more.emplace_back("area_above_threshold_percent", "area above threshold, %");
        if (ofEnergy()) more.emplace_back("direct_kwh", "direct beam, kWh");
        std::vector<const char*> columns = {"node", "area, m²", "least hours", "mean hours",
                                            "most hours"};
        for (const auto& [key, heading] : more)
            columns.push_back(heading);
        startTable("Surfaces by node", columns);
        for (const Json& node : report_["by_node"]) {
            page_ += "<tr>" + cell(escapedForMarkup(node["name"].get<std::string>())) +
                     cell(rounded(node["area"].get<double>(), 2), "number");
            for (const char* key : {"min", "mean", "max"})
                page_ += cell(rounded(node["hours"][key].get<double>(), 2), "number");
            for (const auto& [key, heading] : more)
                page_ += cell(rounded(node[key].get<double>(), 1), "number");
            page_ += "</tr>\n";
        }
        endTable();
    }

    void addRow(const std::string& name, const std::string& value) {
        page_ += "<tr>" + cell(escapedForMarkup(name)) + cell(escapedForMarkup(value)) + "</tr>\n";
    }

    void addSettings() {
        startTable("Settings", {"setting", "value"});
        addRow("program", "edgeshade " + run_.version);
        for (const auto& [key, value] : run_.settings.items()) {
            if (key == "surfaces" || value.is_null() || value == "" || key == "plan") continue;
            addRow(key, value.is_string() ? value.get<std::string>() : value.dump());
        }
        if (run_.settings.contains("surfaces"))
            for (const auto& [key, value] : run_.settings["surfaces"].items())
                if (!value.is_null() && !value.empty())
                    addRow(key, value.is_string() ? value.get<std::string>() : value.dump());
        addRow("sun positions", std::to_string(run_.positions.size()) + ", one every " +
                                    std::to_string(run_.step.count()) + " min");
        for (const char* key : {"inside_solids", "within_others"})
            if (report_[key]["cells"] != 0)
                addRow(key == std::string("inside_solids") ? "left out, inside solids"
                                                           : "left out, on other surfaces",
                       std::to_string(report_[key]["cells"].get<std::size_t>()) + ", " +
                           rounded(report_[key]["area"].get<double>(), 2) + " m²");
        endTable();
    }

    void addFiles() {
        startTable("Files of the scene", {"file", "SHA-256"});
        for (const Json& file : run_.files)
            page_ += "<tr>" + cell(escapedForMarkup(file["name"].get<std::string>())) +
                     cell(file["sha256"].get<std::string>(), "hash") + "</tr>\n";
        endTable();
    }

    void addWarnings() {
        if (run_.warnings.empty()) return;
        page_ += "<h2>Warnings</h2>\n<ul>";
        for (const std::string& warning : run_.warnings)
            page_ += "<li>" + escapedForMarkup(warning) + "</li>";
        page_ += "</ul>\n";
    }

    const SurfaceRun& run_;
    const HoursSettings& settings_;
    const Json& report_;
    std::span<const WorldTriangle> scene_;
    const ReportColors& colors_;
    std::string page_;
};

} // namespace

std::string htmlOf(const SurfaceRun& run, const HoursSettings& settings, const Json& report,
                   std::span<const WorldTriangle> scene, const ReportColors& colors) {
    return Page(run, settings, report, scene, colors).text();
}

} // namespace edgeshade::hours
