#include "src/city/job.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/halo.hpp"
#include "src/city/planned_bytes.hpp"
#include "src/city/top_surface.hpp"

#ifdef EDGESHADE_HAS_RAYS
#include "src/rays/lit_rays.hpp"
#endif

namespace edgeshade::city {

#ifdef EDGESHADE_HAS_RAYS

namespace {

/// Shares of the time at which stages end.
constexpr double readEnd = 0.3;
/// Cells that are traced at once, at most; fewer with many directions.
constexpr std::size_t mostAtOnce = std::size_t{1} << 14;
constexpr std::size_t mostBits = std::size_t{1} << 27;
/// The side of a block of cells that share a packet of rays.
constexpr std::int64_t blockSide = 4;

/// The triangles of a job, and their objects.
struct Surroundings {
    std::vector<CityTriangle> triangles; ///< their objects are in `objects`
    std::vector<ResultObject> objects;
};

Surroundings surroundingsOf(const Plan& plan, const Job& job, const SunFan& fan,
                            const std::function<void(double, const std::string&)>& progress) {
    Surroundings all;
    const TargetBox target(job.cells, plan.grid, job.lowest);
    for (std::size_t i = 0; i < job.sources.size(); ++i) {
        const PlannedSource& planned = plan.sources[job.sources[i]];
        progress(readEnd * static_cast<double>(i) / static_cast<double>(job.sources.size()),
                 "reading " + planned.source.file);
        const CityTile tile =
            readSource(plan.folder, planned.source, plannedBytes(plan, planned), plan.reading);
        const auto first = static_cast<std::uint32_t>(all.objects.size());
        for (const CityObject& object : tile.objects)
            all.objects.push_back({job.sources[i], object.id, object.isBuilding});
        for (CityTriangle triangle : tile.triangles) {
            if (!fan.mayShade(triangle.box(), target)) continue;
            triangle.object += first;
            all.triangles.push_back(triangle);
        }
    }
    return all;
}

/// The triangles as a scene of rays, relative to a point of the lattice.
struct RayScene {
    Scene scene;
    std::vector<rays::SurfaceTriangle> triangles; ///< in the order of the surroundings'

    /// `tops`: triangles that cells are on. Their corners alone are kept as floats, which hold them
    /// exactly (C63); rays never look at the others'.
    RayScene(const std::vector<CityTriangle>& all, const std::vector<std::uint32_t>& tops,
             const glm::dvec3& origin) {
        std::vector<std::uint8_t> isTop(all.size(), 0);
        for (const std::uint32_t top : tops)
            if (top != noSurface) isTop[top] = 1;
        Geometry geometry;
        std::vector<std::uint32_t> firstIndices(all.size(), 0);
        for (std::size_t t = 0; t < all.size(); ++t) {
            if (isTop[t] == 0) continue;
            firstIndices[t] = static_cast<std::uint32_t>(geometry.indices.size());
            for (const glm::dvec3& corner : all[t].corners) {
                geometry.indices.push_back(static_cast<std::uint32_t>(geometry.positions.size()));
                geometry.positions.push_back(glm::vec3(corner - origin));
            }
        }
        scene.materials.emplace_back();
        scene.batches.emplace_back().geometry = CopyOnWrite<Geometry>(std::move(geometry));
        triangles.reserve(all.size());
        for (std::size_t t = 0; t < all.size(); ++t) {
            rays::SurfaceTriangle& triangle = triangles.emplace_back();
            triangle.a = all[t].corners[0] - origin;
            triangle.b = all[t].corners[1] - origin;
            triangle.c = all[t].corners[2] - origin;
            triangle.firstIndex = firstIndices[t];
            triangle.geometry = &*scene.batches.front().geometry;
        }
    }
};

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
JobResult unlitResult(const ReadPlan& read, std::size_t number, const Surroundings& all,
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
    std::vector<std::uint32_t> numberOf(all.objects.size(), noSurface);
    for (std::size_t cell = 0; cell < count; ++cell) {
        if (tops[cell] == noSurface) continue;
        const CityTriangle& top = all.triangles[tops[cell]];
        if (numberOf[top.object] == noSurface) {
            numberOf[top.object] = static_cast<std::uint32_t>(result.named.size());
            result.named.push_back(all.objects[top.object]);
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
    Surroundings all = surroundingsOf(plan, job, SunFan(positions), progress);
    const std::vector<std::uint32_t> tops = topSurfaces(all.triangles, job.cells, plan.grid);
    JobResult result = unlitResult(read, number, all, tops, positions.size());
    const std::vector<std::uint32_t> cells = cellsWithSurface(job.cells, tops);
    if (directions.empty() || cells.empty()) return result;

    const auto middle = [&](std::uint32_t cell) {
        return glm::dvec2(middleOf(job.cells.left + cell % job.cells.columns(), plan.grid),
                          middleOf(job.cells.bottom + cell / job.cells.columns(), plan.grid));
    };
    const glm::dvec3 origin(middleOf(job.cells.left + job.cells.columns() / 2, plan.grid),
                            middleOf(job.cells.bottom + job.cells.rows() / 2, plan.grid), 0.0);
    std::vector<double> heights; // of `cells`
    heights.reserve(cells.size());
    for (const std::uint32_t cell : cells)
        heights.push_back(
            onLattice(heightAt(all.triangles[tops[cell]], middle(cell).x, middle(cell).y)));
    progress(readEnd, "building the tree of rays");
    RayScene rayScene(all.triangles, tops, origin);
    std::vector<CityTriangle>().swap(all.triangles); // frees it before the tree takes memory
    const rays::LitRays litRays(rayScene.scene, std::move(rayScene.triangles));
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
            const glm::dvec3 above(middle(cells[i]), heights[i]);
            points.push_back({above - origin, glm::dvec3(0.0, 0.0, -1.0), tops[cells[i]]});
        }
        const rays::LitBits bits = litRays.lit(points, directions, threads);
        for (std::size_t i = first; i < end; ++i)
            count(bits.of(i - first), months, cells[i], result);
    }
    return result;
}

#else

JobResult runJob(const ReadPlan&, std::size_t,
                 const std::function<void(double, const std::string&)>&, Threads) {
    throw Error(ExitStatus::unavailable,
                "city run traces rays, but this program was built without Embree.");
}

#endif

} // namespace edgeshade::city
