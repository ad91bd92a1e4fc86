#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/json_field.hpp"

#include <optional>
#include <vector>

namespace edgeshade {

/// Calls read(JsonField) for every item of the member, if it exists. The items are optional parts
/// of a scene; `thing` is their name in the singular. Items that `read` refuses, and a member that
/// is no array, get a warning; `broken` is called with those items' indices.
template <class Read, class Broken>
void forEachSoundItem(const JsonField& parent, const char* key, const char* thing,
                      Warnings& warnings, Read read, Broken broken) {
    const auto section = parent.find(key);
    if (!section) return;
    const std::string leftOut = std::string("the ") + thing;
    if (!readOrWarn(warnings, leftOut + "s are left out", [&] { section->requireArray(); })) return;
    std::size_t index = 0;
    section->forEachItem([&](const JsonField& item) {
        if (!readOrWarn(warnings, leftOut + " is left out", [&] { read(item); })) broken(index);
        ++index;
    });
}

/// The results of read(JsonField) for every item; null for items it refuses.
template <class Read>
auto soundItems(const JsonField& parent, const char* key, const char* thing, Warnings& warnings,
                Read read) {
    std::vector<std::optional<decltype(read(parent))>> items;
    forEachSoundItem(
        parent, key, thing, warnings,
        [&](const JsonField& item) {
            items.emplace_back();
            items.back() = read(item);
        },
        [](std::size_t) {});
    return items;
}

} // namespace edgeshade
