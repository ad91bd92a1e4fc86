#include "src/city/job.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/caster_filter.hpp"
#include "src/city/lattice.hpp"
#include "src/city/planned_bytes.hpp"
#include "src/city/top_surface.hpp"
#include "src/rays/lit_rays.hpp"

namespace edgeshade::city {
namespace {

/// Shares of the time at which stages end.
constexpr double readEnd = 0.3;
/// Cells that are traced at once, at most; fewer with many directions.
constexpr std::size_t mostAtOnce = std::size_t{1} << 14;
constexpr std::size_t mostBits = std::size_t{1} << 27;
/// The side of a block of cells that share a packet of rays.
constexpr std::int64_t blockSide = 4;

/// Reads the sources of a job.
class JobSources {
  public:
    JobSources(const Plan& plan, const Job& job,
               const std::function<void(double, const std::string&)>& progress)
        : plan_(plan), job_(job), progress_(progress) {}

    /// Reads a source; `number`: in Plan::sources.
    CityTile read(std::size_t number) {
        const PlannedSource& planned = plan_.sources[number];
        progress_(readEnd * static_cast<double>(read_++) / static_cast<double>(job_.sources.size()),
                  "reading " + planned.source.file);
        return readSource(plan_.folder, planned.source, plannedBytes(plan_, planned),
                          plan_.reading);
    }

  private:
    const Plan& plan_;
    const Job& job_;
    const std::function<void(double, const std::string&)>& progress_;
    std::size_t read_ = 0;
};

rays::Corners cornersFrom(const CityTriangle& triangle, const glm::dvec3& origin) {
    return {triangle.corners[0] - origin, triangle.corners[1] - origin,
            triangle.corners[2] - origin};
}

/// The sources over a target.
struct Ground {
    std::vector<CityTriangle> over;    ///< their boxes are over or under cells
    std::vector<CityTriangle> besides; ///< others that may shade cells
    std::vector<ResultObject> objects; ///< of both
};

bool isOver(const TargetBox& target, const PlannedSource& source) {
    return !source.box.empty() && target.isUnder(source.box);
}

Ground groundOf(const Plan& plan, const Job& job, const SunFan& fan, JobSources& sources) {
    Ground ground;
    const TargetBox target(job.cells, plan.grid, job.lowest);
    for (const std::size_t number : job.sources) {
        if (!isOver(target, plan.sources[number])) continue;
        const CityTile tile = sources.read(number);
        const auto first = static_cast<std::uint32_t>(ground.objects.size());
        for (const CityObject& object : tile.objects)
            ground.objects.push_back({number, object.id, object.isBuilding});
        for (CityTriangle triangle : tile.triangles) {
            const Box box = triangle.box();
            if (!fan.mayShade(box, target)) continue;
            triangle.object += first;
            (target.isUnder(box) ? ground.over : ground.besides).push_back(triangle);
        }
    }
    return ground;
}

/// The triangles that cells are on, as a scene of rays, relative to a point of the lattice. Their
/// corners are kept as floats, which hold them exactly (C63).
struct RayScene {
    Scene scene;
    std::vector<rays::SurfaceTriangle> surfaces;

    RayScene(std::span<const CityTriangle> triangles, const glm::dvec3& origin) {
        Geometry geometry;
        for (const CityTriangle& triangle : triangles)
            for (const glm::dvec3& corner : triangle.corners) {
                geometry.indices.push_back(static_cast<std::uint32_t>(geometry.positions.size()));
                geometry.positions.push_back(glm::vec3(corner - origin));
            }
        scene.materials.emplace_back();
        scene.batches.emplace_back().geometry = CopyOnWrite<Geometry>(std::move(geometry));
        surfaces.reserve(triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const auto [a, b, c] = cornersFrom(triangles[t], origin);
            rays::SurfaceTriangle& surface = surfaces.emplace_back();
            surface.a = a;
            surface.b = b;
            surface.c = c;
            surface.firstIndex = static_cast<std::uint32_t>(3 * t);
            surface.geometry = &*scene.batches.front().geometry;
        }
    }
};

/// Puts triangles that cells are on before the others, in both lists. Returns their number.
std::size_t sortTops(std::vector<CityTriangle>& triangles, std::vector<std::uint32_t>& tops) {
    std::vector<std::uint32_t> numbers(triangles.size(), noSurface);
    std::vector<CityTriangle> sorted;
    sorted.reserve(triangles.size());
    for (std::uint32_t& top : tops) {
        if (top == noSurface) continue;
        std::uint32_t& number = numbers[top];
        if (number == noSurface) {
            number = static_cast<std::uint32_t>(sorted.size());
            sorted.push_back(triangles[top]);
        }
        top = number;
    }
    const std::size_t count = sorted.size();
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (numbers[t] == noSurface) sorted.push_back(triangles[t]);
    triangles.swap(sorted);
    return count;
}

/// The casters of a job, relative to the origin: first those over its target, as they are sorted,
/// then those of the halo, which is read a source at a time.
std::vector<rays::Corners> castersOf(const Plan& plan, const Job& job, Ground ground,
                                     const CasterFilter& filter, const glm::dvec3& origin,
                                     JobSources& sources) {
    std::vector<rays::Corners> casters;
    const auto add = [&](const CityTriangle& triangle) {
        casters.push_back(cornersFrom(triangle, origin));
    };
    const TargetBox target(job.cells, plan.grid, job.lowest);
    // Pages that stay unused take no memory; growing by copies would.
    std::size_t most = ground.over.size() + ground.besides.size();
    for (const std::size_t number : job.sources)
        if (!isOver(target, plan.sources[number])) most += plan.sources[number].triangles;
    casters.reserve(std::min<std::size_t>(most, noSurface)); // which number triangles
    for (const CityTriangle& triangle : ground.over)
        add(triangle);
    filter.forEach(ground.besides, add);
    ground = {};
    for (const std::size_t number : job.sources)
        if (!isOver(target, plan.sources[number]))
            filter.forEach(sources.read(number).triangles, add);
    return casters;
}

/// Counts the positions that light a cell.
void count(std::span<const std::uint64_t> row, std::span<const std::uint8_t> months,
           std::size_t cell, JobResult& result) {
    const std::size_t rowBytes = hours::bytesOfRow(months.size());
    for (std::size_t i = 0; i < months.size(); ++i) {
        if ((row[i / 64] >> i % 64 & 1) == 0) continue;
        ++result.lit[cell];
        if (!result.months.empty()) ++result.months[monthsOfYear * cell + months[i]];
        if (!result.bits.empty())
            result.bits[rowBytes * cell + i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
    }
}

/// The numbers of cells that have a surface, block by block.
std::vector<std::uint32_t> cellsWithSurface(const CellRange& cells,
                                            const std::vector<std::uint32_t>& tops) {
    std::vector<std::uint32_t> numbers;
    for (std::int64_t bottom = 0; bottom < cells.rows(); bottom += blockSide)
        for (std::int64_t left = 0; left < cells.columns(); left += blockSide)
            for (std::int64_t y = bottom; y < std::min(bottom + blockSide, cells.rows()); ++y)
                for (std::int64_t x = left; x < std::min(left + blockSide, cells.columns()); ++x) {
                    const auto cell = static_cast<std::uint32_t>(y * cells.columns() + x);
                    if (tops[cell] != noSurface) numbers.push_back(cell);
                }
    return numbers;
}

/// Fills in what is known without rays.
JobResult unlitResult(const ReadPlan& read, std::size_t number, const Ground& ground,
                      const std::vector<std::uint32_t>& tops, std::size_t positions) {
    const Job& job = read.plan.jobs[number - 1];
    JobResult result;
    result.plan = read.hash;
    result.job = number;
    result.cells = job.cells;
    result.positions = positions;
    const std::size_t count = job.cells.count();
    result.lit.assign(count, 0);
    if (read.plan.months) result.months.assign(monthsOfYear * count, 0);
    if (read.plan.bits) result.bits.assign(hours::bytesOfRow(positions) * count, 0);
    result.objects.assign(count, noSurface);
    result.kinds.assign(count, SurfaceKind::none);
    std::vector<std::uint32_t> numberOf(ground.objects.size(), noSurface);
    for (std::size_t cell = 0; cell < count; ++cell) {
        if (tops[cell] == noSurface) continue;
        const CityTriangle& top = ground.over[tops[cell]];
        if (numberOf[top.object] == noSurface) {
            numberOf[top.object] = static_cast<std::uint32_t>(result.named.size());
            result.named.push_back(ground.objects[top.object]);
        }
        result.objects[cell] = numberOf[top.object];
        result.kinds[cell] = top.kind;
    }
    return result;
}

} // namespace

JobResult runJob(const ReadPlan& read, std::size_t number,
                 const std::function<void(double, const std::string&)>& progress, Threads threads) {
    const Plan& plan = read.plan;
    if (number < 1 || number > plan.jobs.size())
        throw Error(ExitStatus::usage, "--job: " + std::to_string(number) +
                                           " is not from 1 to the plan's " +
                                           std::to_string(plan.jobs.size()) + " jobs.");
    const Job& job = plan.jobs[number - 1];
    const std::vector<hours::Position> positions = hours::positionsOf(plan.schedule);
    std::vector<glm::dvec3> directions;
    for (const hours::Position& position : positions)
        directions.push_back(inFrame(position.direction));
    const std::vector<std::uint8_t> months = hours::monthsOf(positions, plan.schedule.offset);
    const SunFan fan(positions);
    JobSources sources(plan, job, progress);
    Ground ground = groundOf(plan, job, fan, sources);
    std::vector<std::uint32_t> tops = topSurfaces(ground.over, job.cells, plan.grid);
    const std::size_t surfaces = sortTops(ground.over, tops);
    JobResult result = unlitResult(read, number, ground, tops, positions.size());
    const std::vector<std::uint32_t> cells = cellsWithSurface(job.cells, tops);
    if (directions.empty() || cells.empty()) return result;

    const auto middle = [&](std::uint32_t cell) {
        return glm::dvec2(middleOf(job.cells.left + cell % job.cells.columns(), plan.grid),
                          middleOf(job.cells.bottom + cell / job.cells.columns(), plan.grid));
    };
    const glm::dvec3 origin(middleOf(job.cells.left + job.cells.columns() / 2, plan.grid),
                            middleOf(job.cells.bottom + job.cells.rows() / 2, plan.grid), 0.0);
    std::vector<double> heights(job.cells.count(), HUGE_VAL); // by cell, rounded to the lattice
    for (const std::uint32_t cell : cells)
        heights[cell] =
            onLattice(heightAt(ground.over[tops[cell]], middle(cell).x, middle(cell).y));
    RayScene rayScene(std::span(ground.over).first(surfaces), origin);
    const CasterFilter filter(fan, job.cells, plan.grid, heights);
    std::vector<rays::Corners> casters =
        castersOf(plan, job, std::move(ground), filter, origin, sources);
    progress(readEnd, "building the tree of rays");
    const rays::LitRays litRays(
        rayScene.scene,
        std::make_shared<const rays::SurfaceSet>(std::move(rayScene.surfaces), std::move(casters)));
    const std::size_t atOnce =
        std::clamp<std::size_t>(mostBits / directions.size(), 64, mostAtOnce);
    for (std::size_t first = 0; first < cells.size(); first += atOnce) {
        const std::size_t end = std::min(first + atOnce, cells.size());
        progress(readEnd + (1.0 - readEnd) * static_cast<double>(first) /
                               static_cast<double>(cells.size()),
                 "tracing rays");
        std::vector<rays::SurfacePoint> points;
        for (std::size_t i = first; i < end; ++i) {
            // Any point of the vertical line would do; near the surface doubles decide most.
            const glm::dvec3 above(middle(cells[i]), heights[cells[i]]);
            points.push_back({above - origin, glm::dvec3(0.0, 0.0, -1.0), tops[cells[i]]});
        }
        const rays::LitBits bits = litRays.lit(points, directions, threads);
        for (std::size_t i = first; i < end; ++i)
            count(bits.of(i - first), months, cells[i], result);
    }
    return result;
}

} // namespace edgeshade::city
