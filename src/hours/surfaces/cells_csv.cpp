#include "src/hours/surfaces/cells_csv.hpp"

#include "preprocess/base/names.hpp"
#include "src/hours/exposure.hpp"

#include <charconv>

namespace edgeshade::hours {
namespace {

/// Builds lines. Numbers don't depend on the locale.
class Table {
  public:
    Table& add(double number) {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, number);
        return raw(std::string_view(digits, static_cast<std::size_t>(end.ptr - digits)));
    }
    Table& add(const glm::dvec3& vector) { return add(vector.x).add(vector.y).add(vector.z); }
    /// In quotes where the text needs them. A text that a spreadsheet would take for a formula gets
    /// them too, which RFC 4180 allows.
    Table& add(std::string_view text) {
        if (text.find_first_of(",\"\r\n") == std::string_view::npos) return raw(text);
        std::string quoted = "\"";
        for (const char c : text) {
            if (c == '"') quoted += '"';
            quoted += c;
        }
        return raw(quoted + "\"");
    }
    void endLine() {
        text_ += '\n';
        starts_ = true;
    }
    std::string text() { return std::move(text_); }

  private:
    Table& raw(std::string_view text) {
        if (!starts_) text_ += ',';
        starts_ = false;
        text_ += text;
        return *this;
    }

    std::string text_;
    bool starts_ = true; ///< of a line
};

void addHeading(Table& table, const SurfaceRun& run, const CsvColumns& columns) {
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "area_m2", "hours", "node",
                             "material", "node_index", "material_index", "left_out"})
        table.add(std::string_view(name));
    if (columns.when) table.add(std::string_view("first")).add(std::string_view("last"));
    if (!run.light.months.empty())
        for (int month = 1; month <= 12; ++month)
            table.add(
                std::string_view((month < 10 ? "hours_0" : "hours_") + std::to_string(month)));
    if (!run.light.directKwh.empty()) table.add(std::string_view("direct_kwh_per_m2"));
    table.endLine();
}

std::string timeText(const SurfaceRun& run, std::uint32_t position, int halfSteps) {
    if (position == CellLight::never) return "";
    const std::chrono::seconds half = std::chrono::seconds(run.step) / 2;
    return sun::textOf(sun::LocalTime{run.positions[position].time + halfSteps * half, run.offset});
}

std::string_view wordOf(CellState state) {
    using enum CellState;
    return nameIn({{counted, ""}, {inside, "inside"}, {within, "within"}}, state);
}

void addNumber(Table& table, std::uint32_t index) {
    table.add(std::string_view(index == Exposure::none ? std::string() : std::to_string(index)));
}

} // namespace

std::string csvOf(const SurfaceRun& run, const CsvColumns& columns) {
    Table table;
    addHeading(table, run, columns);
    for (std::size_t i = 0; i < run.cells.cells.size(); ++i) {
        const Cell& cell = run.cells.cells[i];
        const WorldTriangle& triangle = run.cells.triangleOf(cell);
        table.add(cell.point).add(cell.normal).add(run.areaOf(i)).add(run.hoursOf(i));
        table.add(std::string_view(run.nodes.at(triangle.node)));
        table.add(std::string_view(run.materials.at(triangle.material)));
        addNumber(table, triangle.node);
        addNumber(table, triangle.material);
        table.add(wordOf(cell.state));
        if (columns.when)
            table.add(std::string_view(timeText(run, run.light.first[i], -1)))
                .add(std::string_view(timeText(run, run.light.last[i], 1)));
        if (!run.light.months.empty())
            for (const std::uint32_t lit : run.light.months[i])
                table.add(hoursOf(lit, run.step));
        if (!run.light.directKwh.empty()) table.add(run.light.directKwh[i]);
        table.endLine();
    }
    return table.text();
}

} // namespace edgeshade::hours
