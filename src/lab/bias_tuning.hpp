#pragma once

#include "src/lab/jury.hpp"

namespace edgeshade::lab {

/// The bias with the fewest wrong pixels over the first views, each in full.
float tunedBias(Jury& jury, const CompareTask& task, Renderer& renderer,
                const Contender& contender);

/// A contender whose bias is tuned, with its renderer.
struct Tuned {
    const Contender* contender = nullptr;
    Renderer* renderer = nullptr;
    float bias = 0.0f; ///< found, texels
};

/// The biases of several contenders at once, far quicker: over the first views, which are drawn
/// small and traced once for all of them, the better half of what is left after each. How many
/// texels suit a map hardly depends on the size of the picture. `goesOn`: asked after each view.
void tuneBiases(Jury& jury, const CompareTask& task, std::vector<Tuned>& contenders,
                const std::function<bool()>& goesOn);

} // namespace edgeshade::lab
