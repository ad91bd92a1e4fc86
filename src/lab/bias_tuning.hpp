#pragma once

#include "src/lab/jury.hpp"

namespace edgeshade::lab {

/// The bias with the fewest wrong pixels over the first views, at full size.
float tunedBias(Jury& jury, const CompareTask& task, Renderer& renderer,
                const Contender& contender);

/// A contender whose bias is tuned, with its renderer.
struct Tuned {
    const Contender* contender = nullptr;
    Renderer* renderer = nullptr;
    float bias = 0.0f; ///< the bias found, in texels
};

/// Finds the biases of several contenders at once, which is far quicker. The first views are drawn
/// small and traced once for all. After each view the better half of the remaining biases is kept.
/// The texels that suit a map hardly depend on the picture's size. `goesOn` is called after each
/// view, and returns whether to continue.
void tuneBiases(Jury& jury, const CompareTask& task, std::vector<Tuned>& contenders,
                const std::function<bool()>& goesOn);

} // namespace edgeshade::lab
