#include "src/engine/merged_meshes.hpp"

#include "src/engine/mesh_place.hpp"

#include <algorithm>

namespace edgeshade {

std::vector<MergedMeshes> MergedMeshes::of(std::span<const Member> meshes) {
    std::vector<PlacedMesh> placed;
    std::vector<MergeCandidate> left;
    for (const Member& of : meshes) {
        placed.push_back({of.mesh.data(), placeOf(of.worldFromObject)});
        if (mayMerge(*of.mesh.data()))
            left.push_back(candidateOf(placed.size() - 1, placed.back()));
    }
    std::vector<MergedMeshes> made;
    while (left.size() >= fewestMembers) {
        std::vector<std::size_t> numbers = neighbours(left);
        std::erase_if(left, [&](const MergeCandidate& of) {
            return std::find(numbers.begin(), numbers.end(), of.number) != numbers.end();
        });
        if (numbers.size() < fewestMembers) continue;
        std::vector<PlacedMesh> members;
        for (const std::size_t number : numbers)
            members.push_back(placed[number]);
        MergedMesh merged = merge(members);
        made.emplace_back(std::make_shared<const Data>(
            Data{std::move(numbers), std::move(members), std::move(merged)}));
    }
    return made;
}

std::span<const std::size_t> MergedMeshes::members() const {
    return data_->numbers;
}

} // namespace edgeshade
