#include "src/scene/plane_pair_buffers.hpp"

#include <cstring>

namespace edgeshade {
namespace {

/// Copies every record `count` times, each copy with its corner's number in front.
template <class Record>
void appendCopies(std::vector<float>& floats, const Record& record, int firstCorner, int count) {
    constexpr std::size_t size = sizeof(Record) / sizeof(float);
    for (int corner = firstCorner; corner < firstCorner + count; ++corner) {
        floats.push_back(static_cast<float>(corner));
        const std::size_t at = floats.size();
        floats.resize(at + size);
        std::memcpy(floats.data() + at, &record, sizeof(Record));
    }
}

template <class Record>
gl::Buffer uploadSides(std::span<const Record> records, bool copied) {
    if (records.empty()) return {};
    if (!copied) return gl::vertexBuffer<Record>(records);
    std::vector<float> floats;
    floats.reserve(records.size() * verticesPerQuad * (1 + sizeof(Record) / sizeof(float)));
    for (const Record& record : records)
        appendCopies(floats, record, 0, verticesPerQuad);
    return gl::vertexBuffer<float>(floats);
}

} // namespace

gl::Buffer uploadPairs(std::span<const PairRecord> records, SidesLayout layout) {
    return uploadSides(records, layout == SidesLayout::notInstanced);
}

CapBuffers uploadCaps(std::span<const CapRecord> records, std::span<const glm::vec4> alphaCorners,
                      SidesLayout layout) {
    CapBuffers buffers;
    buffers.count = static_cast<std::uint32_t>(records.size());
    if (records.empty()) return buffers;
    if (layout != SidesLayout::notInstanced) {
        buffers.records = gl::vertexBuffer<CapRecord>(records);
        if (!alphaCorners.empty()) buffers.alphaCorners = gl::vertexBuffer<glm::vec4>(alphaCorners);
        return buffers;
    }
    std::vector<float> floats;
    std::vector<glm::vec4> copies;
    for (const int first : {0, verticesPerCap})
        for (std::size_t i = 0; i < records.size(); ++i) {
            appendCopies(floats, records[i], first, verticesPerCap);
            if (alphaCorners.empty()) continue;
            const auto of = alphaCorners.subspan(3 * i, 3);
            for (int corner = 0; corner < verticesPerCap; ++corner)
                copies.insert(copies.end(), of.begin(), of.end());
        }
    buffers.records = gl::vertexBuffer<float>(floats);
    if (!copies.empty()) buffers.alphaCorners = gl::vertexBuffer<glm::vec4>(copies);
    return buffers;
}

PlanePairBuffers::PlanePairBuffers(std::shared_ptr<const PlanePairShadow> shadow,
                                   std::vector<glm::vec4> alphaCorners, SidesLayout layout)
    : shadow_(std::move(shadow)), alphaCorners_(std::move(alphaCorners)), layout_(layout),
      singles_(uploadSides(std::span(shadow_->singles), copied())),
      caps_(shadow_->clusters.size()) {}

void PlanePairBuffers::take(std::shared_ptr<const PlanePairShadow> posed) {
    *this = PlanePairBuffers(std::move(posed), std::move(alphaCorners_), layout_);
}

void PlanePairBuffers::uploadAllPairs() {
    if (!pairs_) pairs_ = uploadPairs(shadow_->pairs, layout_);
}

void PlanePairBuffers::uploadCapsOf(std::size_t cluster) {
    if (caps_[cluster]) return;
    const ShadowCluster& of = shadow_->clusters[cluster];
    std::span<const glm::vec4> alphaCorners;
    if (of.alphaTested)
        alphaCorners = std::span(alphaCorners_).subspan(3 * of.caps.first, 3 * of.caps.count);
    caps_[cluster] = uploadCaps(std::span(shadow_->caps).subspan(of.caps.first, of.caps.count),
                                alphaCorners, layout_);
}

std::size_t PlanePairBuffers::capBytes() const {
    std::size_t total = 0;
    for (const auto& caps : caps_)
        if (caps) total += caps->records.size() + caps->alphaCorners.size();
    return total;
}

} // namespace edgeshade
