#pragma once

#include "preprocess/base/error.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace edgeshade {

/// Sentences for the user about what was left out or changed, each kept once. Beyond a hundred they
/// are only counted.
class Warnings {
  public:
    void add(const std::string& sentence) {
        constexpr std::size_t most = 100;
        if (std::find(sentences_.begin(), sentences_.end(), sentence) != sentences_.end()) return;
        if (sentences_.size() < most) {
            sentences_.push_back(sentence);
            return;
        }
        sentences_.resize(most);
        sentences_.push_back("There are " + std::to_string(++more_) + " more warnings.");
    }
    const std::vector<std::string>& sentences() const { return sentences_; }

  private:
    std::vector<std::string> sentences_;
    std::size_t more_ = 0; ///< count of those not kept
};

/// Calls `read`, which reads an optional part of a scene. If it throws InputError, that becomes a
/// warning, which ends with the `outcome`, such as "the camera is left out". Returns whether it
/// succeeded.
template <class Read>
bool readOrWarn(Warnings& warnings, const std::string& outcome, Read read) {
    try {
        read();
        return true;
    } catch (const InputError& error) {
        warnings.add(clauseOf(error.what()) + "; " + outcome + ".");
        return false;
    }
}

} // namespace edgeshade
