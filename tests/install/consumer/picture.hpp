// A box over a floor, shaded by edgeshade's mask: 51 of 255 in shadow, 204 where lit, blue where
// there is nothing.
#pragma once
#include <edgeshade/shadow_masks.hpp>

constexpr int pictureWidth = 320, pictureHeight = 240;

/// Draws it with its own shader into the bound framebuffer of the current context. Throws
/// edgeshade's errors.
void drawPicture(edgeshade::ShadowMasks::LookUp lookUp);

/// Reads the picture back into a PPM.
void writePicture(const char* path);
