#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/json_field.hpp"

#include <optional>
#include <vector>

namespace edgeshade {

/// Calls read(JsonField) for every item of the member, if it is there: of things that a scene can
/// do without, `thing` in the singular. Items that it refuses, and a member that is no array, get a
/// warning; `broken` is told the items' indices.
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

/// What read(JsonField) makes of every item; nothing where it refuses one.
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
