#include "src/city/merge.hpp"

#include "src/city/city_files.hpp"
#include "src/city/detail_files.hpp"
#include "src/city/geo_tiff.hpp"
#include "src/city/map_sweep.hpp"
#include "src/city/object_sums.hpp"
#include "src/city/staged_files.hpp"
#include "src/city/text_by_source.hpp"
#include "src/image/png.hpp"

#include <algorithm>

namespace edgeshade::city {
namespace {

using Json = nlohmann::ordered_json;

/// "a/hours-b.city.json" for "a/b.city.json".
std::filesystem::path withHours(const std::filesystem::path& file) {
    return file.parent_path() / ("hours-" + file.filename().string());
}

bool isCityJson(const Source& source) {
    return source.kind == SourceKind::cityJson || source.kind == SourceKind::cityJsonSequence;
}

/// The files of a map while jobs are joined.
class Merging {
  public:
    Merging(const Plan& plan, const std::filesystem::path& output)
        : plan_(plan), files_(output),
          raster_(files_.add("hours.tif"), plan, std::array{std::string()}),
          table_(files_.scratch("objects"), plan.sources.size()), preview_(plan.region) {
        if (plan.months) months_.emplace(files_.add("months.tif"), plan);
        if (plan.bits) bits_.emplace(files_.add("bits.npy"), plan);
    }

    void addJob(const JobResult& result) {
        addCells(result, hours_);
        sums_.add(result);
    }

    void endSource(std::size_t number) {
        const std::vector<ObjectHours> objects = sums_.take(number);
        hours_.objects += objects.size();
        hours_.buildings += static_cast<std::size_t>(std::ranges::count_if(
            objects, [](const ObjectHours& object) { return object.object.isBuilding; }));
        table_.add(number, objectRowsOf(objects, plan_));
        const PlannedSource& planned = plan_.sources[number];
        if (isCityJson(planned.source))
            writeFile(files_.add(withHours(planned.source.file)),
                      std::string_view(cityJsonWithHours(objects, plan_, planned)));
    }

    void addRow(const MapRow& row) {
        std::vector<float> hours;
        hours.reserve(row.lit.size());
        for (const std::int32_t count : row.lit)
            hours.push_back(count == nothing ? noHours
                                             : static_cast<float>(count * hoursOfPosition(plan_)));
        raster_.add(hours);
        preview_.add(row.lit);
        if (months_) months_->add(row);
        if (bits_) bits_->add(row);
    }

    Json finish(std::size_t cellsHeld, const std::function<std::uint32_t(double share)>& color) {
        hours_.cellsHeld = cellsHeld;
        raster_.finish();
        if (months_) months_->finish();
        if (bits_) bits_->finish();
        table_.write(files_.add("objects.csv"), objectsHeader);
        const Image preview = preview_.image(hours_.most, color);
        writeFile(files_.add("preview.png"),
                  encodePng(preview.rgba, preview.width, preview.height));
        Json report = mapReportOf(hours_, plan_);
        writeFile(
            files_.add("report.json"),
            std::string_view(report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"));
        files_.commit();
        return report;
    }

  private:
    const Plan& plan_;
    StagedFiles files_;
    GeoTiffWriter raster_;
    std::optional<MonthsFile> months_;
    std::optional<BitsFile> bits_;
    TextBySource table_;
    Preview preview_;
    ObjectSums sums_;
    CityHours hours_;
};

} // namespace

Json mergeCity(const ReadPlan& read, const std::filesystem::path& results,
               const std::filesystem::path& output,
               const std::function<std::uint32_t(double share)>& color,
               const std::function<void(double)>& progress) {
    requireAllThere(read.plan, results);
    Merging merging(read.plan, output);
    const auto rows = static_cast<double>(read.plan.region.rows());
    std::int64_t done = 0;
    const std::size_t cellsHeld =
        sweepMap(read, results,
                 {[&](const JobResult& result) { merging.addJob(result); },
                  [&](std::size_t source) { merging.endSource(source); },
                  [&](const MapRow& row) {
                      merging.addRow(row);
                      progress(static_cast<double>(++done) / rows);
                  }});
    return merging.finish(cellsHeld, color);
}

} // namespace edgeshade::city
