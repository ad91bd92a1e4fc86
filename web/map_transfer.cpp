#include "web/map_transfer.hpp"

#include "web/archive.hpp"

namespace edgeshade::web {

template <class Archive>
void transfer(Archive& archive, Maybe<PrimitiveMapTask> auto& task) {
    auto& settings = task.settings;
    archive(task.light, settings.size, settings.mostBytes, settings.splitAbove, settings.mostSplits,
            settings.othersReceive, settings.cutouts);
}

template <class Archive>
void transfer(Archive& archive, Maybe<PrimitiveMap> auto& map) {
    auto& tiles = map.tiles;
    archive(tiles.directional, tiles.mapFromWorld, tiles.tiles, tiles.depthSpan, map.size,
            map.header, map.entries, map.records, map.cutouts, map.longestList);
}

template <class Archive>
void transfer(Archive& archive, Maybe<SidedTriangles> auto& triangles) {
    archive(triangles.lightSide, triangles.vertices, triangles.details, triangles.indices);
}

namespace {

template <class T>
T taken(std::span<const std::uint8_t> bytes) {
    T value;
    Reader reader(bytes);
    transfer(reader, value);
    return value;
}

} // namespace

Bytes toTransfer(const PrimitiveMapTask& task) {
    Bytes bytes;
    Writer writer(bytes);
    transfer(writer, task);
    return bytes;
}

PrimitiveMapTask taskFromTransfer(std::span<const std::uint8_t> bytes) {
    return taken<PrimitiveMapTask>(bytes);
}

Bytes toTransfer(const BuiltPrimitiveMap& built) {
    Bytes bytes;
    Writer writer(bytes);
    writer(built.light, built.tooFar, built.milliseconds, built.map.has_value());
    if (built.map) transfer(writer, *built.map);
    writer(built.triangles.size());
    for (const auto& batch : built.triangles)
        writer(batch);
    return bytes;
}

BuiltPrimitiveMap builtFromTransfer(std::span<const std::uint8_t> bytes) {
    BuiltPrimitiveMap built;
    Reader reader(bytes);
    bool hasMap = false;
    std::size_t batches = 0;
    reader(built.light, built.tooFar, built.milliseconds, hasMap);
    if (hasMap) transfer(reader, built.map.emplace());
    reader(batches);
    built.triangles.resize(batches);
    for (auto& batch : built.triangles)
        reader(batch);
    return built;
}

} // namespace edgeshade::web
