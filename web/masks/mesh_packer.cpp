#include "web/masks/mesh_packer.hpp"

#include "web/masks/mesh_arguments.hpp"
#include "web/masks/mesh_transfer.hpp"
#include "web/page_bytes.hpp"
#include "web/sentence.hpp"

namespace edgeshade::web {

void MeshPacker::clear() {
    meshes_.clear();
    merged_.clear();
}

std::string MeshPacker::pack(std::uintptr_t positions, std::size_t floats, std::uintptr_t indices,
                             std::size_t count, std::uintptr_t texcoords,
                             std::size_t texcoordFloats, unsigned flags) {
    bytes_ = {};
    meshes_.emplace_back(MaskMesh{});
    return sentenceOfFailure([&] {
        meshes_.back() = PreparedMesh(
            meshAt(positions, floats, indices, count, texcoords, texcoordFloats, flags));
        bytes_ = toTransfer(meshes_.back());
    });
}

std::string MeshPacker::merge(std::uintptr_t meshes, std::uintptr_t matrices, std::size_t count) {
    return sentenceOfFailure([&] {
        std::vector<MergedMeshes::Member> members;
        for (std::size_t i = 0; i < count; ++i)
            members.push_back({meshes_.at(static_cast<std::size_t>(at<int>(meshes)[i])),
                               matrixAt(matrices + i * sizeof(Matrix16))});
        merged_ = MergedMeshes::of(members);
    });
}

emscripten::val MeshPacker::members(std::size_t merged) {
    const auto of = merged_.at(merged).members();
    members_.assign(of.begin(), of.end());
    return emscripten::val(emscripten::typed_memory_view(members_.size(), members_.data()));
}

emscripten::val MeshPacker::mergedBytes(std::size_t merged) {
    bytes_ = toTransfer(merged_.at(merged));
    return viewOf(bytes_);
}

emscripten::val MeshPacker::bytes() const {
    return viewOf(bytes_);
}

} // namespace edgeshade::web
