#include "src/city/city_map.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/top_surface.hpp"

#include <algorithm>
#include <map>

namespace edgeshade::city {
namespace {

using ObjectKey = std::pair<std::size_t, std::string>;

void requireOwn(const JobResult& result, const ReadPlan& read, std::size_t job,
                const std::filesystem::path& path) {
    if (result.plan != read.hash)
        throw InputError("'" + path.string() + "' is the result of another plan.");
    if (result.job != job || result.cells != read.plan.jobs[job - 1].cells)
        throw InputError("'" + path.string() + "' is the result of job " +
                         std::to_string(result.job) + ", not of job " + std::to_string(job) + ".");
    for (const ResultObject& object : result.named)
        if (object.source >= read.plan.sources.size())
            throw InputError("'" + path.string() + "' names source " +
                             std::to_string(object.source) + ", which the plan doesn't have.");
}

void addCells(const JobResult& result, CityMap& map, std::map<ObjectKey, ObjectHours>& objects) {
    std::vector<ObjectHours*> own;
    for (const ResultObject& object : result.named) {
        ObjectHours& hours = objects[{object.source, object.id}];
        hours.object = object;
        own.push_back(&hours);
    }
    const std::int64_t columns = result.cells.columns();
    for (std::size_t cell = 0; cell < result.lit.size(); ++cell) {
        if (result.objects[cell] == noSurface) continue;
        const auto at = static_cast<std::int64_t>(cell);
        const std::int64_t x = result.cells.left + at % columns - map.region.left,
                           y = map.region.top - 1 - (result.cells.bottom + at / columns);
        const std::uint16_t lit = result.lit[cell];
        map.lit[static_cast<std::size_t>(y * map.region.columns() + x)] = lit;
        ObjectHours& hours = *own[result.objects[cell]];
        hours.least = hours.cells == 0 ? lit : std::min(hours.least, lit);
        hours.most = std::max(hours.most, lit);
        hours.litSum += lit;
        KindHours& kind = map.kinds[static_cast<std::size_t>(result.kinds[cell])];
        kind.litSum += lit;
        ++kind.cells;
        ++hours.cells;
    }
}

} // namespace

CityMap mapOf(const ReadPlan& read, const std::filesystem::path& results) {
    const Plan& plan = read.plan;
    CityMap map;
    map.region = plan.region;
    map.lit.assign(plan.region.count(), CityMap::nothing);
    map.hoursOfPosition = static_cast<double>(plan.schedule.step.count()) / 60.0;
    std::map<ObjectKey, ObjectHours> objects;
    for (std::size_t job = 1; job <= plan.jobs.size(); ++job) {
        const std::filesystem::path path = results / fileNameOfJob(job);
        std::error_code error;
        if (!std::filesystem::exists(path, error))
            throw InputError("Job " + std::to_string(job) + " of " +
                             std::to_string(plan.jobs.size()) + " has no result: '" +
                             path.string() + "' is missing.");
        const JobResult result = resultFrom(path);
        requireOwn(result, read, job, path);
        map.positions = result.positions;
        addCells(result, map, objects);
    }
    for (auto& [key, hours] : objects)
        map.objects.push_back(std::move(hours));
    return map;
}

} // namespace edgeshade::city
