#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

// The values that settings may have, as constants. src/cli/ reads and writes them as text,
// src/viewer/ as members of a view's state.

namespace edgeshade {

enum class WordUse {
    both,
    typed,   ///< help lists it; reports and states write another word for the value
    written, ///< reports and states write it; help lists another word for the value
};

/// A word for a value. Every word is read, whatever its use.
template <class Value>
struct Word {
    const char* text;
    Value value;
    WordUse use = WordUse::both;
};

/// One of a few words.
template <class Value, std::size_t N>
using Words = std::array<Word<Value>, N>;

/// The word to write for a value that has one.
template <class Value, std::size_t N>
constexpr const char* wordOf(const Words<Value, N>& words, Value value) {
    for (const Word<Value>& word : words)
        if (word.value == value && word.use != WordUse::typed) return word.text;
    return "";
}

/// One of a few whole numbers.
template <std::size_t N>
struct Numbers {
    std::array<int, N> all;
};

/// A whole number from `low` to `high`.
struct WholeRange {
    std::int64_t low, high;
};

/// A finite number from `low` to `high`.
struct NumberRange {
    double low, high;
};

/// An optional value; `none` is the word for nothing.
template <class Domain>
struct Optional {
    Domain domain;
    const char* none;
};

/// A file's name; `none` is the word for an empty one.
struct FileName {
    const char* none;
};

} // namespace edgeshade
