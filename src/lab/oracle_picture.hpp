#pragma once

#include "src/lab/oracle.hpp"
#include "src/lab/pictures.hpp"

namespace edgeshade::lab {

/// The program's picture if every pixel were lit as the oracle says: the program's own shading with
/// the oracle's visibility.
class OraclePicture {
  public:
    using Color = std::array<int, 3>;

    /// `unshadowed`, `litAs`: as in Pictures.
    explicit OraclePicture(Pictures::Unshadowed unshadowed, Pictures::LitAs litAs = {})
        : unshadowed_(std::move(unshadowed)), litAs_(std::move(litAs)) {}

    /// Draws the colours for these answers, as far as they differ from the previous ones.
    void follow(const std::vector<Answer>& answers);

    const Color& at(std::size_t pixel) const { return colors_[pixel]; }

  private:
    Pictures::Unshadowed unshadowed_;
    Pictures::LitAs litAs_;
    std::vector<Color> colors_;
    std::vector<LightSet> lit_; ///< the lights that each colour was drawn with
};

} // namespace edgeshade::lab
