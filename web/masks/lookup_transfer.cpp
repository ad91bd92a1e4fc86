#include "web/masks/lookup_transfer.hpp"

#include "web/archive.hpp"

namespace edgeshade::web {

template <class Archive>
void transfer(Archive& archive, Maybe<PackedPrimitiveMap> auto& map) {
    archive(map.kind, map.mapFromWorld, map.size, map.longestList, map.begins, map.count);
}

template <class Archive>
void transfer(Archive& archive, Maybe<BuiltLookup> auto& built) {
    archive(built.why, built.map, built.milliseconds);
}

namespace {

/// The fields that both directions share.
template <class Archive>
void transferStart(Archive& archive, Maybe<LookupWork::Data> auto& data) {
    archive(data.task.light, data.task.settings, data.task.why, data.held);
}

/// A caster's place, and the index of its shape.
struct Place {
    std::size_t shape = 0;
    glm::dmat4 worldFromBatch{1.0};
};

} // namespace

Bytes taskToTransfer(const LookupWork& work) {
    const LookupWork::Data& data = *work.data();
    std::map<const PlanePairShadow*, std::size_t> numbers;
    std::vector<const PlanePairShadow*> shapes;
    std::vector<Place> places;
    for (const LookupTask::Caster& caster : data.task.casters) {
        const auto [known, isNew] = numbers.emplace(caster.shadow.get(), shapes.size());
        if (isNew) shapes.push_back(caster.shadow.get());
        places.push_back({known->second, caster.worldFromBatch});
    }
    std::size_t size = 4096 + places.size() * sizeof(Place);
    for (const PlanePairShadow* shape : shapes)
        size += shape->caps.size() * sizeof(CapRecord) + sizeof size;
    Bytes bytes;
    bytes.reserve(size);
    Writer writer(bytes);
    transferStart(writer, data);
    writer(places, shapes.size());
    for (const PlanePairShadow* shape : shapes)
        writer(shape->caps);
    return bytes;
}

LookupWork taskFromTransfer(std::span<const std::uint8_t> bytes) {
    auto data = std::make_shared<LookupWork::Data>();
    Reader reader(bytes);
    transferStart(reader, *data);
    std::vector<Place> places;
    std::size_t count = 0;
    reader(places, count);
    std::vector<std::shared_ptr<PlanePairShadow>> shapes(count);
    for (auto& shape : shapes) {
        shape = std::make_shared<PlanePairShadow>();
        reader(shape->caps);
    }
    for (const Place& place : places)
        data->task.casters.push_back({shapes[place.shape], place.worldFromBatch});
    return LookupWork(std::move(data));
}

Bytes resultToTransfer(const LookupWork& work) {
    const LookupWork::Data& data = *work.data();
    Bytes bytes;
    Writer writer(bytes);
    transferStart(writer, data);
    writer(data.built);
    return bytes;
}

LookupWork resultFromTransfer(std::span<const std::uint8_t> bytes) {
    auto data = std::make_shared<LookupWork::Data>();
    Reader reader(bytes);
    transferStart(reader, *data);
    reader(data->built);
    data->done = true;
    return LookupWork(std::move(data));
}

} // namespace edgeshade::web
