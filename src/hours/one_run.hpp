#pragma once

#include "src/hours/part.hpp"

#include <algorithm>
#include <concepts>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::hours {

/// Checks that a file's values are those of the run's first file. All functions throw InputError
/// naming both files, the field and its values.
class OneRun {
  public:
    OneRun(std::string path, std::string firstPath)
        : path_(std::move(path)), firstPath_(std::move(firstPath)) {}

    [[noreturn]] void fail(const std::string& field, const std::string& value,
                           const std::string& firstValue) const;

    void requireSame(const std::string& field, const nlohmann::ordered_json& value,
                     const nlohmann::ordered_json& firstValue) const;

    /// Compares arrays; `element`: the name of one, as in "pixel", of so many numbers.
    template <std::totally_ordered T>
    void requireSameArrays(const std::string& field, const char* element,
                           const std::vector<T>& values, const std::vector<T>& firstValues,
                           std::size_t components = 1) const {
        const auto [here, there] = std::ranges::mismatch(values, firstValues);
        if (here != values.end() && there != firstValues.end())
            fail(field + " of " + element + " " +
                     std::to_string(static_cast<std::size_t>(here - values.begin()) / components),
                 nlohmann::ordered_json(*here).dump(), nlohmann::ordered_json(*there).dump());
        if (values.size() != firstValues.size())
            fail(field, "of length " + std::to_string(values.size()),
                 "of length " + std::to_string(firstValues.size()));
    }

  private:
    std::string path_, firstPath_;
};

/// A part's file and its place in the run.
struct NumberedFile {
    std::string path;
    std::size_t number = 1; ///< 1 <= number <= the number of parts
};

/// The index in `files` of each part, in the order of their numbers. Throws InputError for a part
/// that is repeated or missing of `of`.
std::vector<std::size_t> partsInOrder(std::span<const NumberedFile> files, std::size_t of);

/// Throws InputError if a position of the run isn't later than the one before it. `index`: of the
/// later one in its file.
void requireLater(const Position& position, const std::vector<Position>& before,
                  const std::string& path, std::size_t index);

} // namespace edgeshade::hours
