#include "src/city/map_sweep.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/city_hours.hpp"
#include "src/city/halo.hpp"
#include "src/city/top_surface.hpp"

#include <algorithm>
#include <list>
#include <numeric>

namespace edgeshade::city {
namespace {

/// Whether a source may have a cell of a job.
bool isOver(const PlannedSource& source, const Job& job, double grid) {
    return !source.box.empty() && TargetBox(job.cells, grid, job.lowest).isUnder(source.box);
}

void requireOwn(const JobResult& result, const ReadPlan& read, std::size_t number,
                std::size_t positions, const std::filesystem::path& path) {
    const Plan& plan = read.plan;
    if (result.plan != read.hash)
        throw InputError("'" + path.string() + "' is the result of another plan.");
    const Job& job = plan.jobs[number - 1];
    if (result.job != number || result.cells != job.cells)
        throw InputError("'" + path.string() + "' is the result of job " +
                         std::to_string(result.job) + ", not of job " + std::to_string(number) +
                         ".");
    if (result.positions != positions || result.months.empty() == plan.months ||
        result.bits.empty() == (plan.bits && positions > 0))
        throw InputError("'" + path.string() +
                         "' has other sun positions, months or bits than "
                         "the plan.");
    for (const ResultObject& object : result.named)
        if (object.source >= plan.sources.size() ||
            !isOver(plan.sources[object.source], job, plan.grid))
            throw InputError("'" + path.string() + "' names source " +
                             std::to_string(object.source) + ", which isn't over the job's cells.");
}

/// The jobs' numbers, from 1, by their northern edges.
std::vector<std::size_t> fromTheNorth(const std::vector<Job>& jobs) {
    std::vector<std::size_t> order(jobs.size());
    std::iota(order.begin(), order.end(), std::size_t{1});
    std::ranges::stable_sort(order, std::greater(),
                             [&](std::size_t job) { return jobs[job - 1].cells.top; });
    return order;
}

/// For each place in the order of jobs, the sources that none of the jobs after it is on. Sources
/// that no job is on are at the last place.
std::vector<std::vector<std::size_t>> sourceEnds(const Plan& plan,
                                                 const std::vector<std::size_t>& order) {
    std::vector<std::size_t> lastOf(plan.sources.size(), order.empty() ? 0 : order.size() - 1);
    for (std::size_t place = 0; place < order.size(); ++place) {
        const Job& job = plan.jobs[order[place] - 1];
        for (const std::size_t source : job.sources)
            if (isOver(plan.sources[source], job, plan.grid)) lastOf[source] = place;
    }
    std::vector<std::vector<std::size_t>> ends(order.size());
    for (std::size_t source = 0; source < plan.sources.size() && !order.empty(); ++source)
        ends[lastOf[source]].push_back(source);
    return ends;
}

/// A row that jobs put their cells into.
struct Line {
    std::vector<std::int32_t> lit;
    std::vector<std::uint16_t> months;
    Bytes bits;

    Line(const Plan& plan, std::size_t rowBytes) {
        const auto columns = static_cast<std::size_t>(plan.region.columns());
        lit.assign(columns, nothing);
        if (plan.months) months.assign(monthsOfYear * columns, 0);
        if (plan.bits) bits.assign(rowBytes * columns, 0);
    }

    void put(const JobResult& result, std::int64_t y, std::int64_t left) {
        const auto columns = static_cast<std::size_t>(result.cells.columns()),
                   to = static_cast<std::size_t>(result.cells.left - left);
        const std::size_t first = static_cast<std::size_t>(y - result.cells.bottom) * columns;
        for (std::size_t x = 0; x < columns; ++x)
            if (result.objects[first + x] != noSurface) lit[to + x] = result.lit[first + x];
        const auto copy = [&](const auto& from, auto& line, std::size_t perCell) {
            if (!line.empty())
                std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(perCell * first),
                            perCell * columns,
                            line.begin() + static_cast<std::ptrdiff_t>(perCell * to));
        };
        copy(result.months, months, monthsOfYear);
        copy(result.bits, bits, hours::bytesOfRow(result.positions));
    }
};

} // namespace

void requireAllThere(const Plan& plan, const std::filesystem::path& results) {
    for (std::size_t job = 1; job <= plan.jobs.size(); ++job) {
        const std::filesystem::path path = results / fileNameOfJob(job);
        std::error_code error;
        if (!std::filesystem::exists(path, error))
            throw InputError("Job " + std::to_string(job) + " of " +
                             std::to_string(plan.jobs.size()) + " has no result: '" +
                             path.string() + "' is missing.");
    }
}

std::size_t sweepMap(const ReadPlan& read, const std::filesystem::path& results,
                     const MapVisitor& visitor) {
    const Plan& plan = read.plan;
    const std::vector<std::size_t> order = fromTheNorth(plan.jobs);
    const std::vector<std::vector<std::size_t>> ends = sourceEnds(plan, order);
    std::list<JobResult> held;
    std::size_t next = 0, cells = 0, mostCells = 0;
    const std::size_t positions = hours::positionsOf(plan.schedule).size();
    for (std::int64_t y = plan.region.top - 1; y >= plan.region.bottom; --y) {
        std::erase_if(held, [&](const JobResult& result) {
            const bool isPast = result.cells.bottom > y;
            if (isPast) cells -= result.cells.count();
            return isPast;
        });
        for (; next < order.size() && plan.jobs[order[next] - 1].cells.top > y; ++next) {
            const std::filesystem::path path = results / fileNameOfJob(order[next]);
            held.push_back(resultFrom(path));
            requireOwn(held.back(), read, order[next], positions, path);
            cells += held.back().cells.count();
            visitor.job(held.back());
            for (const std::size_t source : ends[next])
                visitor.sourceEnd(source);
        }
        mostCells = std::max(mostCells, cells);
        Line line(plan, hours::bytesOfRow(positions));
        for (const JobResult& result : held)
            line.put(result, y, plan.region.left);
        visitor.row({line.lit, line.months, line.bits});
    }
    return mostCells;
}

} // namespace edgeshade::city
