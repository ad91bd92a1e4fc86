#include "web/map_transfer.hpp"

#include "web/archive.hpp"

namespace edgeshade::web {

template <class Archive>
void transfer(Archive& archive, Maybe<CutoutTexture> auto& texture) {
    archive(texture.place, texture.size, texture.wrapS, texture.wrapT, texture.linear,
            texture.cutoff, texture.own);
}

template <class Archive>
void transfer(Archive& archive, Maybe<Section> auto& section) {
    archive(section.planes, section.shadows, section.fill);
}

template <class Archive>
void transfer(Archive& archive, Maybe<PrimitiveMapTask> auto& task) {
    auto& settings = task.settings;
    archive(task.light, task.castersReceive, settings.size, settings.mostBytes, settings.splitAbove,
            settings.mostSplits, settings.othersReceive, settings.receivers, settings.cutouts,
            task.section);
}

template <class Archive>
void transfer(Archive& archive, Maybe<PrimitiveMap> auto& map) {
    auto& tiles = map.tiles;
    archive(tiles.directional, tiles.mapFromWorld, tiles.tiles, tiles.depthSpan, tiles.shape,
            tiles.farthestReceiver, map.size, map.texels, map.headers, map.entries, map.cutouts,
            map.extended, map.longestList, map.meanList);
}

template <class Archive>
void transfer(Archive& archive, Maybe<SidedTriangles> auto& triangles) {
    archive(triangles.lightSide, triangles.vertices, triangles.details, triangles.indices);
}

template <class Archive>
void transfer(Archive& archive, Maybe<BuiltPrimitiveMap> auto& built) {
    archive(built.light, built.mostBytes, built.tooFar, built.tooLong, built.milliseconds,
            built.map, built.triangles);
}

namespace {

template <class T>
Bytes given(const T& value) {
    Bytes bytes;
    Writer writer(bytes);
    writer(value);
    return bytes;
}

template <class T>
T taken(std::span<const std::uint8_t> bytes) {
    T value;
    Reader reader(bytes);
    reader(value);
    return value;
}

} // namespace

Bytes toTransfer(const PrimitiveMapTask& task) {
    return given(task);
}

PrimitiveMapTask taskFromTransfer(std::span<const std::uint8_t> bytes) {
    return taken<PrimitiveMapTask>(bytes);
}

Bytes toTransfer(const BuiltPrimitiveMap& built) {
    return given(built);
}

BuiltPrimitiveMap builtFromTransfer(std::span<const std::uint8_t> bytes) {
    return taken<BuiltPrimitiveMap>(bytes);
}

} // namespace edgeshade::web
