#include "src/hours/surfaces/surface_merge.hpp"

#include "src/hours/one_run.hpp"
#include "src/hours/part.hpp"
#include "src/hours/settings.hpp"

#include <bit>

namespace edgeshade::hours {
namespace {

void requireOneRun(const OneRun& one, const SurfacePart& part, const SurfacePart& first) {
    const SurfaceRun& a = part.run;
    const SurfaceRun& b = first.run;
    one.requireSame("parts", part.of, first.of);
    one.requireSame("scene", a.scene, b.scene);
    one.requireSame("version", a.version, b.version);
    one.requireSame("files", a.files, b.files);
    one.requireSame("settings", a.settings, b.settings);
    one.requireSame("positions_of_run", part.positionsOfRun, first.positionsOfRun);
    one.requireSameArrays("beam", "position", part.beam, first.beam);
    one.requireSame("materials", a.materials, b.materials);
    one.requireSame("nodes", a.nodes, b.nodes);
}

} // namespace

void SurfaceMerge::add(const std::string& path, SurfacePart part) {
    CellArrays arrays = arraysOf(part.run.cells, part.scene);
    lights_.push_back({std::move(part.run.positions), std::move(part.run.light.bits)});
    paths_.push_back(path);
    numbers_.push_back(part.number);
    if (paths_.size() == 1) {
        first_ = std::move(part);
        arrays_ = std::move(arrays);
        return;
    }
    const OneRun one(path, paths_.front());
    requireOneRun(one, part, first_);
    forEachArray([&](const ArrayName& name, auto array) {
        one.requireSameArrays(std::string(name.group) + "." + name.member, name.element,
                              arrays.*array, arrays_.*array, name.components);
    });
}

rays::LitBits SurfaceMerge::bitsOf(std::span<const std::size_t> order, std::size_t first,
                                   std::size_t end) const {
    rays::LitBits bits(end - first, first_.positionsOfRun);
    for (std::size_t n = 0; n < order.size(); ++n) {
        const Light& light = lights_[order[n]];
        const std::size_t row = bytesOfRow(light.positions.size());
        for (std::size_t cell = first; cell < end; ++cell)
            for (std::size_t b = 0; b < row; ++b)
                for (std::uint8_t byte = light.bits[cell * row + b]; byte != 0;) {
                    const auto bit = static_cast<std::size_t>(std::countl_zero(byte));
                    byte = static_cast<std::uint8_t>(byte & ~(0x80u >> bit));
                    bits.setLit(cell - first, (8 * b + bit) * order.size() + n);
                }
    }
    return bits;
}

SurfacePart SurfaceMerge::whole(bool bits, const std::function<void(double)>& onShare) && {
    std::vector<NumberedFile> files;
    for (std::size_t i = 0; i < paths_.size(); ++i)
        files.push_back({paths_[i], numbers_[i]});
    const std::vector<std::size_t> order = partsInOrder(files, first_.of);
    SurfaceRun& run = first_.run;
    for (std::size_t i = 0; i < first_.positionsOfRun; ++i) {
        const std::size_t from = order[i % order.size()], index = i / order.size();
        const Position& position = lights_[from].positions[index];
        requireLater(position, run.positions, paths_[from], index);
        run.positions.push_back(position);
    }
    const std::size_t days =
        hoursSettings(JsonField(paths_.front(), run.settings, "settings")).days;
    run.light = lightOf(
        run.cells, questionOf(run, days, first_.beam, bits),
        CellBits([&](std::size_t from, std::size_t end) { return bitsOf(order, from, end); }),
        onShare);
    first_.number = first_.of = 1;
    return std::move(first_);
}

} // namespace edgeshade::hours
