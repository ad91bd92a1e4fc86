#pragma once

#include "src/lab/oracle.hpp"

namespace edgeshade::lab {

/// What the program's picture would be if every pixel were lit as the oracle says: the program's
/// own shading with the oracle's visibility.
class OraclePicture {
  public:
    using Color = std::array<int, 3>;

    using Draw = std::function<std::vector<std::uint8_t>(std::uint32_t lights)>;

    /// `unshadowed`: as in Pictures.
    explicit OraclePicture(Draw unshadowed) : unshadowed_(std::move(unshadowed)) {}

    /// Draws what is needed for these answers, as far as they are others than those before.
    void follow(const std::vector<Answer>& answers);

    const Color& at(std::size_t pixel) const { return colors_[pixel]; }

  private:
    Draw unshadowed_;
    std::vector<Color> colors_;
    std::vector<std::uint32_t> lit_; ///< by which lights the colours were drawn
};

} // namespace edgeshade::lab
