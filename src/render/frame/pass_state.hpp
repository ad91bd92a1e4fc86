#pragma once

#include <array>
#include <GLES2/gl2.h>
#include <optional>

namespace edgeshade {

/// The GL state that one pass of a frame draws with (docs/architecture.md, Passes and GL state).
struct PassState {
    struct Blend {
        GLenum source, target, alphaSource, alphaTarget;
    };
    /// A stencil test against 0 over all bits. Fragments that pass it and the depth test apply
    /// `then` to the stencil; others keep it.
    struct Stencil {
        GLenum function, then;
    };

    std::array<bool, 4> color = {true, true, true, true}; ///< whether red, green, blue, alpha are
                                                          ///< written
    bool depthWrites = false;
    std::optional<GLenum> depth{};    ///< the depth test's function; null: off
    std::optional<Blend> blend{};     ///< null: off
    std::optional<Stencil> stencil{}; ///< null: off
};

/// Sets all of this state.
void set(const PassState& state);

/// Sets the blend functions only.
void set(const PassState::Blend& blend);

namespace passes {

/// Depth and ambient light, perhaps with the first light.
inline constexpr PassState surfaces{.depthWrites = true, .depth = GL_LESS};

/// Counting and marking in the stencil; the pass sets the stencil operations itself.
inline constexpr PassState counting{.color = {false, false, false, false},
                                    .depth = GL_LESS,
                                    .stencil = PassState::Stencil{GL_ALWAYS, GL_KEEP}};

/// Surfaces drawn again in ambient light alone, in shadow. Of coinciding surfaces the first is
/// drawn, as it was with the light.
inline constexpr PassState ambientInShadow{.depth = GL_EQUAL,
                                           .stencil = PassState::Stencil{GL_NOTEQUAL, GL_ZERO}};

/// Adds light where the stencil is 0. Of coinciding surfaces the first is lit, as it is by ambient
/// light. `marked`: alpha is 0 in the shadow of any group, and blocks the light there. `replaces`:
/// the light replaces ambient light instead.
constexpr PassState addingLight(bool marked, bool replaces) {
    const GLenum light = marked ? GL_DST_ALPHA : GL_ONE;
    const GLenum dark = marked ? GL_ONE_MINUS_DST_ALPHA : GL_ZERO;
    return {.depth = GL_EQUAL,
            .blend = PassState::Blend{light, replaces ? dark : GLenum{GL_ONE}, GL_ZERO, GL_ONE},
            .stencil = PassState::Stencil{GL_EQUAL, GL_INCR}};
}

/// See-through surfaces. `adds`: a further light, added to the first one's picture.
/// `premultiplied`: colours are already multiplied by alpha.
constexpr PassState::Blend seeThroughBlend(bool adds, bool premultiplied) {
    if (adds) return {GL_ONE, GL_ONE, GL_ONE, GL_ONE};
    return {premultiplied ? GLenum{GL_ONE} : GLenum{GL_SRC_ALPHA}, GL_ONE_MINUS_SRC_ALPHA, GL_ONE,
            GL_ONE_MINUS_SRC_ALPHA};
}
constexpr PassState seeThrough(bool adds, bool premultiplied) {
    return {.depth = GL_LESS, .blend = seeThroughBlend(adds, premultiplied)};
}

/// A mask's alpha, which says where surfaces are.
inline constexpr PassState alpha{.color = {false, false, false, true}};

} // namespace passes
} // namespace edgeshade
