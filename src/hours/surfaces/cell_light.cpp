#include "src/hours/surfaces/cell_light.hpp"

#include <algorithm>
#include <bit>

namespace edgeshade::hours {
namespace {

/// Bits of one block of cells, 16 MB: blocks of a day have all that rays can share.
constexpr std::size_t bitsOfBlock = std::size_t{1} << 27;

/// Calls use(position) for each bit of a row, in order.
template <class Use>
void forEachLit(std::span<const std::uint64_t> row, const Use& use) {
    for (std::size_t w = 0; w < row.size(); ++w)
        for (std::uint64_t word = row[w]; word != 0; word &= word - 1)
            use(64 * w + static_cast<std::size_t>(std::countr_zero(word)));
}

class Measuring {
  public:
    Measuring(const SurfaceCells& cells, const LightQuestion& question)
        : cells_(cells), question_(question), rowBytes_(bytesOfRow(question.positions.size())) {
        const std::size_t count = cells.cells.size();
        light_.lit.assign(count, 0);
        light_.first.assign(count, CellLight::never);
        light_.last.assign(count, CellLight::never);
        if (question.months) {
            months_ = monthsOf(question.positions, question.offset);
            light_.months.assign(count, {});
        }
        if (!question.normalIrradiance.empty()) light_.directKwh.assign(count, 0.0);
        if (question.bits) light_.bits.assign(count * rowBytes_, 0);
    }

    void add(std::size_t cell, std::span<const std::uint64_t> row) {
        forEachLit(row, [&](std::size_t i) {
            const auto position = static_cast<std::uint32_t>(i);
            if (light_.lit[cell]++ == 0) light_.first[cell] = position;
            light_.last[cell] = position;
            if (question_.months) ++light_.months[cell][months_[i]];
            if (!light_.directKwh.empty()) light_.directKwh[cell] += energyOf(cell, i);
            if (question_.bits)
                light_.bits[cell * rowBytes_ + i / 8] |= static_cast<std::uint8_t>(0x80u >> i % 8);
        });
    }

    CellLight result() { return std::move(light_); }

  private:
    /// kWh/m² of one position: its irradiance, by the cosine of its angle, over its step.
    double energyOf(std::size_t cell, std::size_t position) const {
        const double cosine =
            glm::dot(cells_.cells[cell].normal, question_.positions[position].direction);
        const double hours = static_cast<double>(question_.step.count()) / 60.0;
        return question_.normalIrradiance[position] * std::max(cosine, 0.0) * hours / 1000.0;
    }

    const SurfaceCells& cells_;
    const LightQuestion& question_;
    std::size_t rowBytes_;
    std::vector<std::uint8_t> months_;
    CellLight light_;
};

} // namespace

std::vector<Sensor> sensorsOf(const SurfaceCells& cells, std::size_t first, std::size_t end) {
    std::vector<Sensor> sensors;
    sensors.reserve(end - first);
    for (std::size_t i = first; i < end; ++i) {
        const Cell& cell = cells.cells[i];
        Sensor& sensor = sensors.emplace_back(Sensor{cell.point, cell.normal});
        if (cells.offset > 0.0) continue;
        sensor.batch = cells.triangleOf(cell).batch;
        sensor.firstIndex = cells.triangleOf(cell).firstIndex;
    }
    return sensors;
}

CellLight lightOf(const SurfaceCells& cells, const LightQuestion& question, const CellBits& bitsOf,
                  const std::function<void(double)>& onShare) {
    Measuring measuring(cells, question);
    const std::size_t count = cells.cells.size();
    const std::size_t block =
        std::clamp<std::size_t>(bitsOfBlock / std::max<std::size_t>(question.positions.size(), 1),
                                64, std::size_t{1} << 14);
    for (std::size_t first = 0; first < count; first += block) {
        onShare(static_cast<double>(first) / static_cast<double>(count));
        const std::size_t end = std::min(first + block, count);
        const rays::LitBits bits = bitsOf(first, end);
        for (std::size_t i = first; i < end; ++i)
            measuring.add(i, bits.of(i - first));
    }
    onShare(1.0);
    return measuring.result();
}

CellLight lightOf(const SurfaceCells& cells, const LightQuestion& question,
                  const SensorLight& light, const std::function<void(double)>& onShare) {
    std::vector<glm::dvec3> directions;
    for (const Position& position : question.positions)
        directions.push_back(position.direction);
    return lightOf(cells, question, CellBits([&](std::size_t first, std::size_t end) {
                       return light(sensorsOf(cells, first, end), directions);
                   }),
                   onShare);
}

} // namespace edgeshade::hours
