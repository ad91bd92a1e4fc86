#include "src/city/job_memory.hpp"

#include <algorithm>

namespace edgeshade::city {
namespace {

/// The program, its libraries and a block of rays.
constexpr std::uint64_t base = std::uint64_t{128} << 20;
/// A cell while surfaces are found and its rays are traced.
constexpr std::uint64_t bytesOfCounting = 16;
/// A cell in a result: as numbers, as bytes of a file, and deflated twice, no smaller at worst.
constexpr std::uint64_t copiesOfResult = 4;
/// A triangle that casts: its corners, 72 bytes, and its share of Embree's tree while that is
/// built, about 130. Over the target it is in tiles instead, twice at most, before there are
/// corners.
constexpr std::uint64_t bytesOfCaster = 288;
/// A triangle that cells are on: with floats and indices.
constexpr std::uint64_t bytesOfSurface = 208;
/// A triangle of the source that is being read.
constexpr std::uint64_t bytesOfRead = 256;

/// Bytes for each byte of a file while it is read: itself, and what a parser makes of it.
std::uint64_t parsingOf(SourceKind kind) {
    switch (kind) {
    case SourceKind::cityJson:
        return 20;
    case SourceKind::cityJsonSequence:
    case SourceKind::raster:
        return 3;
    case SourceKind::gltf:
    case SourceKind::b3dm:
        break;
    }
    return 8;
}

} // namespace

std::uint64_t memoryOf(const Job& job, const std::vector<PlannedSource>& sources,
                       std::uint64_t casters, std::size_t resultBytesOfCell) {
    std::uint64_t reading = 0;
    for (const std::size_t number : job.sources) {
        const PlannedSource& source = sources[number];
        reading = std::max(reading, source.bytes * parsingOf(source.source.kind) +
                                        source.triangles * bytesOfRead);
    }
    return base + (bytesOfCounting + copiesOfResult * resultBytesOfCell) * job.cells.count() +
           bytesOfCaster * casters +
           bytesOfSurface * std::min<std::uint64_t>(casters, job.cells.count()) + reading;
}

} // namespace edgeshade::city
