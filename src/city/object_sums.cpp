#include "src/city/object_sums.hpp"

#include "src/city/top_surface.hpp"

#include <algorithm>

namespace edgeshade::city {
namespace {

/// Adds a cell to sums that have its fields.
template <class Sums>
void addCell(Sums& sums, std::uint16_t lit) {
    sums.least = sums.cells == 0 ? lit : std::min(sums.least, lit);
    sums.most = std::max(sums.most, lit);
    sums.litSum += lit;
    ++sums.cells;
}

} // namespace

void ObjectSums::add(const JobResult& result) {
    std::vector<ObjectHours*> own;
    for (const ResultObject& object : result.named) {
        ObjectHours& hours = bySource_[object.source][object.id];
        hours.object = object;
        own.push_back(&hours);
    }
    for (std::size_t cell = 0; cell < result.lit.size(); ++cell)
        if (result.objects[cell] != noSurface)
            addCell(*own[result.objects[cell]], result.lit[cell]);
}

std::vector<ObjectHours> ObjectSums::take(std::size_t source) {
    std::vector<ObjectHours> objects;
    if (auto node = bySource_.extract(source))
        for (auto& [id, hours] : node.mapped())
            objects.push_back(std::move(hours));
    return objects;
}

void addCells(const JobResult& result, CityHours& hours) {
    hours.positions = result.positions;
    for (std::size_t cell = 0; cell < result.lit.size(); ++cell) {
        if (result.objects[cell] == noSurface) continue;
        addCell(hours, result.lit[cell]);
        KindHours& kind = hours.kinds[static_cast<std::size_t>(result.kinds[cell])];
        kind.litSum += result.lit[cell];
        ++kind.cells;
    }
}

} // namespace edgeshade::city
