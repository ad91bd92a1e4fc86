#pragma once

#include "preprocess/scene/section.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade::cli {

/// `--section`, `--section-box`, `--section-shadows` and `--section-fill`, as typed.
struct SectionOptions {
    std::vector<glm::dvec4> planes;
    std::vector<glm::dvec4> box; ///< six planes, or none
    SectionShadows shadows{};
    std::string fill;
    bool typedHow = false; ///< how to cut was typed, not only where

    bool any() const { return !planes.empty() || !box.empty(); }
    /// Throws Error(usage) if only how to cut was typed.
    Section section() const;
};

/// Adds the options to a verb; `options` must outlive parsing.
void addSectionOptions(CLI::App& verb, SectionOptions& options);

} // namespace edgeshade::cli
