#pragma once

#include "src/lab/bias_tuning.hpp"

namespace edgeshade::lab {

/// Counts contenders' wrong pixels as compareAll() does, but view by view, of those that are asked
/// for, and in their images alone.
class ErrorSurvey {
  public:
    /// Both must outlive it. Throws Error.
    ErrorSurvey(const LoadedScene& loaded, const CompareTask& task);

    /// Makes the renderers of `who`, indices of contenders, and tunes their maps' biases, by more
    /// than one view if `goesOn` says so.
    void prepare(std::span<const std::size_t> who, const std::function<bool()>& goesOn);

    /// What is wrong in a view of the task, of each of `who`.
    std::vector<WrongCounts> count(std::size_t view, std::span<const std::size_t> who);

    /// The bias that was tuned, texels; nothing where none was.
    std::optional<float> tunedBias(std::size_t contender) const { return entries_[contender].bias; }

  private:
    struct Entry {
        std::unique_ptr<Renderer> renderer;
        std::optional<float> bias;
    };

    const CompareTask& task_;
    Jury jury_;
    std::vector<Entry> entries_; ///< one a contender
};

} // namespace edgeshade::lab
