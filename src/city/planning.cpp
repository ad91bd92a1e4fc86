#include "src/city/planning.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/sha256.hpp"
#include "preprocess/base/vectors.hpp"
#include "src/city/coordinate_system.hpp"
#include "src/city/halo.hpp"
#include "src/city/job_memory.hpp"
#include "src/city/job_result.hpp"
#include "src/city/part_tree.hpp"

#include <algorithm>
#include <map>

namespace edgeshade::city {
namespace {

/// Cells along a target's side: at most, and at least.
constexpr std::int64_t largestSide = 4096, smallestSide = 16;
/// The same in metres, at most: floats hold corners of triangles over a target, relative to its
/// middle, without rounding (docs/method.md, C63).
constexpr double widestTarget = 0x1p14;
/// Cells from the origin of coordinates, at most.
constexpr double farthestCell = 0x1p30;
/// The most targets.
constexpr std::size_t mostJobs = 1'000'000;

/// Reads all sources, and checks them against each other.
class Survey {
  public:
    Survey(const SourceList& list, Plan& plan, std::vector<std::string>& warnings)
        : list_(list), plan_(plan), warnings_(warnings) {}

    void add(const Source& source) {
        const Bytes bytes = bytesOf(list_.folder, source, plan_.reading);
        const CityTile tile = readSource(list_.folder, source, bytes, plan_.reading);
        warnings_.insert(warnings_.end(), tile.warnings.begin(), tile.warnings.end());
        PlannedSource planned{source, bytes.size(), sha256(bytes), tile.triangles.size(), {}};
        for (Part& part : partsOf(tile.triangles, plan_.sources.size())) {
            planned.box.add(part.box);
            parts_.push_back(part);
        }
        requireSameSystem(source, tile);
        if (source.kind == SourceKind::cityJson || source.kind == SourceKind::cityJsonSequence)
            requireNewBuildings(source, tile);
        plan_.sources.push_back(std::move(planned));
    }

    /// The parts of all sources. Throws InputError: two rasters overlap.
    std::vector<Part> takeParts() {
        requireNoOverlaps();
        return std::move(parts_);
    }

  private:
    std::string nameOf(const Source& source) const {
        return "'" + (list_.folder / source.file).string() + "'";
    }

    void requireSameSystem(const Source& source, const CityTile& tile) {
        if (!tile.epsg) return;
        if (plan_.epsg && horizontalSystemOf(*plan_.epsg) != horizontalSystemOf(*tile.epsg))
            throw InputError(nameOf(source) + ": its EPSG code is " + std::to_string(*tile.epsg) +
                             ", but that of the tiles before it is " + std::to_string(*plan_.epsg) +
                             ".");
        if (!plan_.epsg) plan_.epsg = tile.epsg;
    }

    void requireNoOverlaps() const {
        std::vector<Part> boxes;
        for (std::size_t i = 0; i < plan_.sources.size(); ++i)
            if (const PlannedSource& planned = plan_.sources[i];
                planned.source.kind == SourceKind::raster && !planned.box.empty())
                boxes.push_back({planned.box, 0, i});
        const PartTree rasters(boxes);
        for (const Part& raster : boxes) {
            const auto sharedWith = [&](const Box& box) {
                return glm::min(box.high, raster.box.high) - glm::max(box.low, raster.box.low);
            };
            rasters.forEach(
                [&](const Box& box) {
                    const glm::dvec3 shared = sharedWith(box);
                    return shared.x > latticeUnit && shared.y > latticeUnit;
                },
                [&](const Part& other) {
                    if (other.source >= raster.source) return;
                    const glm::dvec3 shared = sharedWith(other.box);
                    throw InputError(nameOf(plan_.sources[raster.source].source) + " overlaps " +
                                     nameOf(plan_.sources[other.source].source) + " by " +
                                     std::to_string(shared.x) + " by " + std::to_string(shared.y) +
                                     " metres.");
                });
        }
    }

    void requireNewBuildings(const Source& source, const CityTile& tile) {
        for (const CityObject& object : tile.objects) {
            if (!object.isBuilding) continue;
            const auto [known, isNew] = buildings_.emplace(object.id, plan_.sources.size());
            if (!isNew)
                throw InputError(nameOf(source) + ": the building '" + object.id + "' is in " +
                                 nameOf(plan_.sources[known->second].source) +
                                 " too; tiles must not overlap.");
        }
    }

    const SourceList& list_;
    Plan& plan_;
    std::vector<std::string>& warnings_;
    std::vector<Part> parts_;
    std::map<std::string, std::size_t> buildings_; ///< the source of each
};

/// Rounds towards minus infinity.
std::int64_t floorOf(std::int64_t value, std::int64_t divisor) {
    return (value >= 0 ? value : value - divisor + 1) / divisor;
}

/// Divides the ground into targets.
class Division {
  public:
    Division(Plan& plan, std::vector<Part> parts, std::uint64_t memory)
        : plan_(plan), parts_(std::move(parts)), memory_(memory),
          fan_(hours::positionsOf(plan.schedule)),
          bytesOfCell_(
              bytesOfCell(plan.months, plan.bits, hours::positionsOf(plan.schedule).size())) {}

    /// Makes jobs of squares of that side.
    void divide(std::int64_t side) {
        plan_.jobs.clear();
        const CellRange& region = plan_.region;
        for (std::int64_t y = floorOf(region.bottom, side); y * side < region.top; ++y)
            for (std::int64_t x = floorOf(region.left, side); x * side < region.right; ++x)
                addSquare(x * side, y * side, side);
    }

  private:
    void addSquare(std::int64_t left, std::int64_t bottom, std::int64_t side) {
        const CellRange& region = plan_.region;
        Job job;
        job.cells = {std::max(left, region.left), std::max(bottom, region.bottom),
                     std::min(left + side, region.right), std::min(bottom + side, region.top)};
        if (job.cells.columns() <= 0 || job.cells.rows() <= 0) return;
        const std::optional<double> lowest = lowestOver(job.cells);
        if (!lowest) return;
        job.lowest = *lowest;
        const TargetBox target(job.cells, plan_.grid, job.lowest);
        std::uint64_t casters = 0;
        parts_.forEach([&](const Box& box) { return fan_.mayShade(box, target); },
                       [&](const Part& part) {
                           job.sources.push_back(part.source);
                           casters += part.triangles;
                       });
        std::ranges::sort(job.sources);
        job.sources.erase(std::ranges::unique(job.sources).begin(), job.sources.end());
        job.memory = memoryOf(job, plan_.sources, casters, bytesOfCell_);
        if (job.memory <= memory_ && job.cells.count() * bytesOfCell_ <= mostBytesOfCells) {
            plan_.jobs.push_back(std::move(job));
            if (plan_.jobs.size() > mostJobs)
                throw Error(ExitStatus::usage, "--tiles: the plan has more than " +
                                                   std::to_string(mostJobs) + " jobs.");
            return;
        }
        if (side <= smallestSide)
            throw Error(ExitStatus::unavailable,
                        "--memory: a job of " + std::to_string(smallestSide) + " by " +
                            std::to_string(smallestSide) + " cells needs " +
                            std::to_string(job.memory) + " bytes, but may take " +
                            std::to_string(memory_) +
                            "; divide the city into more files, or raise --min-altitude.");
        const std::int64_t half = side / 2;
        addSquare(left, bottom, half);
        addSquare(left + half, bottom, half);
        addSquare(left, bottom + half, half);
        addSquare(left + half, bottom + half, half);
    }

    /// A height that no surface over the target is below; null: none is over it.
    std::optional<double> lowestOver(const CellRange& cells) const {
        std::optional<double> lowest;
        const TargetBox target(cells, plan_.grid, 0.0);
        parts_.forEach([&](const Box& box) { return target.isUnder(box); },
                       [&](const Part& part) {
                           lowest = std::min(lowest.value_or(part.box.low.z), part.box.low.z);
                       });
        return lowest;
    }

    Plan& plan_;
    PartTree parts_;
    std::uint64_t memory_;
    SunFan fan_;
    std::size_t bytesOfCell_; ///< in a result
};

Box boxOf(const std::vector<PlannedSource>& sources) {
    Box all;
    for (const PlannedSource& source : sources)
        all.add(source.box);
    if (all.empty())
        throw InputError("The tiles have no triangles; with --lod, none of that level of detail.");
    return all;
}

CellRange regionOf(const Box& all, double grid) {
    const double farthest = std::max(largestComponent(all.low), largestComponent(all.high));
    if (farthest / grid > farthestCell)
        throw Error(ExitStatus::usage, "--grid: cells of " + std::to_string(grid) +
                                           " metres are too small for coordinates of " +
                                           std::to_string(farthest) + " metres.");
    const auto first = [&](double low) {
        return static_cast<std::int64_t>(std::floor(low / grid));
    };
    const auto end = [&](double low, double high) {
        return std::max(static_cast<std::int64_t>(std::ceil(high / grid)), first(low) + 1);
    };
    return {first(all.low.x), first(all.low.y), end(all.low.x, all.high.x),
            end(all.low.y, all.high.y)};
}

/// Finds the place and the direction of north. `all`: the box of all sources.
void findPlace(const SourceList& list, const Box& all, Plan& plan) {
    if (list.place) {
        plan.schedule.place = *list.place;
        plan.schedule.north = 0.0;
        return;
    }
    if (!plan.epsg)
        throw Error(ExitStatus::usage, "--place auto: no tile of '" + list.folder.string() +
                                           "' says its EPSG code; type --place LAT,LON.");
    const FramePlace found = placeInSystem(*plan.epsg, all.center());
    plan.schedule.place = found.place;
    plan.schedule.north = found.north;
}

} // namespace

Plan planOf(const SourceList& list, const PlanChoice& choice,
            const std::function<void(double, const std::string&)>& progress,
            std::vector<std::string>& warnings) {
    Plan plan;
    plan.folder = list.folder;
    plan.reading = choice.reading;
    plan.schedule = choice.schedule;
    plan.grid = choice.grid;
    plan.months = choice.months;
    plan.bits = choice.bits;
    Survey survey(list, plan, warnings);
    for (const Source& source : list.sources) {
        progress(static_cast<double>(plan.sources.size()) /
                     static_cast<double>(list.sources.size()),
                 source.file);
        survey.add(source);
    }
    const Box all = boxOf(plan.sources);
    plan.region = regionOf(all, plan.grid);
    if (choice.placeFromSources) findPlace(list, all, plan);
    plan.schedule.offset = choice.offset.value_or(hours::offsetNear(plan.schedule.place.longitude));
    Division division(plan, survey.takeParts(), choice.memory);
    std::int64_t side = largestSide;
    while (static_cast<double>(side) * plan.grid > widestTarget)
        side /= 2;
    for (division.divide(side); plan.jobs.size() < choice.tiles && side > smallestSide;)
        division.divide(side /= 2);
    return plan;
}

} // namespace edgeshade::city
