#pragma once

#include "src/lab/bias_tuning.hpp"

namespace edgeshade::lab {

/// Counts contenders' wrong pixels as compareAll() does, but one requested view at a time, and in
/// their images only.
class ErrorSurvey {
  public:
    /// `loaded` and `task` must outlive it. Throws Error.
    ErrorSurvey(const LoadedScene& loaded, const CompareTask& task);

    /// Creates the renderers of `who`, indices of contenders, and tunes their maps' biases, with
    /// further views as long as `goesOn` returns true.
    void prepare(std::span<const std::size_t> who, const std::function<bool()>& goesOn);

    /// Wrong pixels in a view of the task, for each of `who`.
    std::vector<WrongCounts> count(std::size_t view, std::span<const std::size_t> who);

    /// The tuned bias in texels; null if there is none.
    std::optional<float> tunedBias(std::size_t contender) const { return entries_[contender].bias; }

  private:
    struct Entry {
        std::unique_ptr<Renderer> renderer;
        std::optional<float> bias;
    };

    const CompareTask& task_;
    Jury jury_;
    std::vector<Entry> entries_; ///< one per contender
};

} // namespace edgeshade::lab
