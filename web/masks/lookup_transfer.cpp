#include "web/masks/lookup_transfer.hpp"

#include "web/mesh_archive.hpp"

#include <algorithm>
#include <map>

namespace edgeshade::web {

template <class Archive>
void transfer(Archive& archive, Maybe<PackedPrimitiveMap> auto& map) {
    archive(map.kind, map.mapFromWorld, map.size, map.longestList, map.begins, map.places,
            map.sixteens, map.count);
}

template <class Archive>
void transfer(Archive& archive, Maybe<BuiltLookup> auto& built) {
    archive(built.why, built.map, built.milliseconds);
}

template <class Archive>
void transfer(Archive& archive, Maybe<MaskTexels> auto& texels) {
    archive(texels.width, texels.height, texels.alpha, texels.wrapS, texels.wrapT, texels.linear);
}

namespace {

/// The fields that both directions share.
template <class Archive>
void transferStart(Archive& archive, Maybe<LookupWork::Data> auto& data) {
    archive(data.task.light, data.task.settings, data.task.why, data.task.receivers, data.held);
}

constexpr std::size_t none = ~std::size_t{0};

/// A caster's place, with indices of its shape, or of the mesh and the texels that cut it out.
struct Place {
    std::size_t shape = none, mesh = none, texels = none;
    std::size_t tints = 0; ///< 0 or 1, as wide as the others, so that no byte is undefined
    float opacity = 1.0f, cutoff = 0.5f;
    std::array<float, 9> texcoordTransform{};
    std::array<float, 3> tint{};
    glm::dmat4 worldFromBatch{1.0};
};

/// Numbers of values that casters share, by first use; a null pointer has none.
class Numbers {
  public:
    /// `all`: the values so far, to which a new one is added.
    template <class T>
    std::size_t of(const std::shared_ptr<const T>& value, std::vector<const T*>& all) {
        if (!value) return none;
        const auto [known, isNew] = numbers_.emplace(value.get(), all.size());
        if (isNew) all.push_back(value.get());
        return known->second;
    }

  private:
    std::map<const void*, std::size_t> numbers_;
};

/// Reads as many values as its number says; `take(value)` keeps each.
template <class T, class Take>
void readAll(Reader& reader, Take take) {
    std::size_t count = 0;
    for (reader(count); count > 0; --count) {
        T value;
        reader(value);
        take(std::move(value));
    }
}

} // namespace

TaskTransfer::TaskTransfer(const LookupWork& work) : work_(work.data()) {
    Numbers numbers;
    std::vector<Place> places;
    for (const LookupTask::Caster& caster : work_->task.casters) {
        const auto& [mesh, alpha, tint] = caster.cutout;
        places.push_back({numbers.of(caster.shadow, shapes_), numbers.of(mesh, meshes_),
                          numbers.of(alpha.texels, texels_), tint ? 1u : 0u, alpha.opacity,
                          alpha.cutoff, alpha.texcoordTransform,
                          tint.value_or(std::array<float, 3>{}), caster.worldFromBatch});
    }
    Writer writer(own_);
    transferStart(writer, *work_);
    writer(places, shapes_.size());
}

bool TaskTransfer::begin() {
    own_.clear();
    shared_ = {};
    begun_ = 0;
    Writer writer(own_);
    const std::size_t number = next_++;
    const std::size_t meshes = shapes_.size(), texels = meshes + 1 + meshes_.size();
    if (number < meshes) {
        const std::vector<CapRecord>& caps = shapes_[number]->caps;
        writer(caps.size());
        shared_ = {reinterpret_cast<const std::uint8_t*>(caps.data()),
                   caps.size() * sizeof(CapRecord)};
    } else if (number == meshes) {
        writer(meshes_.size());
    } else if (number < texels) {
        writer(*meshes_[number - meshes - 1]->geometry);
    } else if (number == texels) {
        writer(texels_.size());
    } else if (number <= texels + texels_.size()) {
        writer(*texels_[number - texels - 1]);
    }
    return !own_.empty();
}

Bytes TaskTransfer::next(std::size_t most) {
    Bytes bytes;
    bytes.reserve(most);
    while (bytes.size() < most) {
        const bool isOwn = begun_ < own_.size();
        const std::span<const std::uint8_t> from =
            isOwn ? std::span<const std::uint8_t>(own_) : shared_;
        const std::size_t start = isOwn ? begun_ : begun_ - own_.size();
        const auto part = from.subspan(start, std::min(most - bytes.size(), from.size() - start));
        bytes.insert(bytes.end(), part.begin(), part.end());
        begun_ += part.size();
        if (begun_ == own_.size() + shared_.size() && !begin()) break;
    }
    return bytes;
}

LookupWork taskFromTransfer(std::span<const std::uint8_t> bytes) {
    auto data = std::make_shared<LookupWork::Data>();
    Reader reader(bytes);
    transferStart(reader, *data);
    std::vector<Place> places;
    reader(places);
    std::vector<std::shared_ptr<const PlanePairShadow>> shapes;
    readAll<std::vector<CapRecord>>(reader, [&](std::vector<CapRecord> caps) {
        auto shape = std::make_shared<PlanePairShadow>();
        shape->caps = std::move(caps);
        shapes.push_back(std::move(shape));
    });
    std::vector<std::shared_ptr<const PreparedMesh::Data>> meshes;
    readAll<Geometry>(reader, [&](Geometry geometry) {
        meshes.push_back(std::make_shared<const PreparedMesh::Data>(
            PreparedMesh::Data{CopyOnWrite<Geometry>(std::move(geometry)), nullptr, true}));
    });
    std::vector<std::shared_ptr<const MaskTexels>> texels;
    readAll<MaskTexels>(reader, [&](MaskTexels of) {
        texels.push_back(std::make_shared<const MaskTexels>(std::move(of)));
    });
    for (const Place& place : places) {
        LookupTask::Caster& caster = data->task.casters.emplace_back();
        caster.worldFromBatch = place.worldFromBatch;
        if (place.shape != none) caster.shadow = shapes[place.shape];
        if (place.mesh == none) continue;
        MaskAlpha alpha{.opacity = place.opacity,
                        .cutoff = place.cutoff,
                        .texcoordTransform = place.texcoordTransform};
        if (place.texels != none) alpha.texels = texels[place.texels];
        caster.cutout = {meshes[place.mesh], std::move(alpha), {}};
        if (place.tints > 0) caster.cutout.tint = place.tint;
    }
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
