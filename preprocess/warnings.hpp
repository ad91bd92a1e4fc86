#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace edgeshade {

/// Sentences for the user about what was left out or changed; each is kept once.
class Warnings {
  public:
    void add(const std::string& sentence) {
        if (std::find(sentences_.begin(), sentences_.end(), sentence) == sentences_.end())
            sentences_.push_back(sentence);
    }
    const std::vector<std::string>& sentences() const { return sentences_; }

  private:
    std::vector<std::string> sentences_;
};

} // namespace edgeshade
