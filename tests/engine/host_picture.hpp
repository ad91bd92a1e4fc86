#pragma once

#include "src/gl/program.hpp"
#include "tests/engine/masks_in_a_host.hpp"

#include <algorithm>
#include <vector>

namespace edgeshade::test {

/// A foreign renderer that looks up a light's map in its own shader: white where the light reaches,
/// tinted behind tinted meshes, grey in penumbras, black elsewhere, and white with an
/// alpha of 0 where there is no surface.
class HostPicture {
  public:
    /// `version3`: GLSL ES 3.00, else 1.00; with derivatives, or with normals that the host passes;
    /// with other casters than solid ones, or without; `soft`: for a light with a radius.
    struct Language {
        bool version3 = false, derivatives = true;
        LookupCasters casters{};
        bool soft = false;
    };

    HostPicture(const ShadowMasks& masks, ShadowMasks::LookupId lookup, const MaskLight& light,
                const MaskView& view, Language language);
    ~HostPicture();
    HostPicture(const HostPicture&) = delete;
    HostPicture& operator=(const HostPicture&) = delete;

    /// Draws a mesh into the bound framebuffer. `casts`: as it was added.
    void draw(const Geometry& geometry, const Matrix16& worldFromObject, bool casts);

  private:
    gl::ProgramObject program_;
    MaskView view_;
};

/// The languages that a device has, for these casters.
std::vector<HostPicture::Language> languages(const gl::Capabilities& has,
                                             LookupCasters casters = {});

/// One byte per pixel, rows top to bottom.
using Mask = std::vector<std::uint8_t>;

/// The red of the bound framebuffer.
Mask redOf(const gl::HeadlessContext& context);

/// The points at which the view's pixels, rows top to bottom, see the plane y = 0.
std::vector<glm::dvec3> pointsOfGround(const MaskView& view);

/// Whether a pixel of a picture of the host's size has a neighbour with another value.
template <class Value>
bool isAtBorder(const std::vector<Value>& picture, int x, int y) {
    const auto at = [&](int u, int v) {
        return picture[static_cast<std::size_t>(v * hostWidth + u)];
    };
    for (int v = std::max(0, y - 1); v <= std::min(hostHeight - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(hostWidth - 1, x + 1); ++u)
            if (at(u, v) != at(x, y)) return true;
    return false;
}

/// Pixels that differ, and those among them whose neighbours are all equal in the expected mask.
struct Wrong {
    std::size_t all = 0, beyond = 0;
};
Wrong compared(const Mask& mask, const Mask& expected);

/// Builds a lookup and uploads it in pieces.
ShadowMasks::LookupId lookedUp(ShadowMasks& masks, const MaskLight& light,
                               const LookupSettings& settings = {});

} // namespace edgeshade::test
