#pragma once

#include <initializer_list>
#include <utility>

namespace edgeshade {

/// The name of a value in a table that has all values.
template <class Value>
const char* nameIn(std::initializer_list<std::pair<Value, const char*>> names, Value value) {
    for (const auto& [known, name] : names)
        if (known == value) return name;
    return "";
}

} // namespace edgeshade
