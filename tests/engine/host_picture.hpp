#pragma once

#include "src/gl/program.hpp"
#include "tests/engine/masks_in_a_host.hpp"

namespace edgeshade::test {

/// A foreign renderer that looks up a light's map in its own shader: white where the light reaches,
/// tinted behind tinted meshes, black elsewhere, and white where there is no surface.
class HostPicture {
  public:
    /// `version3`: GLSL ES 3.00, else 1.00; with derivatives, or with normals that the host passes;
    /// with other casters than solid ones, or without.
    struct Language {
        bool version3 = false, derivatives = true;
        LookupCasters casters{};
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

/// One byte per pixel, rows top to bottom.
using Mask = std::vector<std::uint8_t>;

/// The red of the bound framebuffer.
Mask redOf(const gl::HeadlessContext& context);

/// Pixels that differ, and those among them whose neighbours are all equal in the expected mask.
struct Wrong {
    std::size_t all = 0, beyond = 0;
};
Wrong compared(const Mask& mask, const Mask& expected);

/// Builds a lookup and uploads it in pieces.
ShadowMasks::LookupId lookedUp(ShadowMasks& masks, const MaskLight& light,
                               const LookupSettings& settings = {});

} // namespace edgeshade::test
