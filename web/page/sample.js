// The scene that ships, and its best view in a picture of a given shape.

const eye = { from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2], fov: 45 };
const seenAspect = 1.45; // of the picture for which `eye` was chosen

export const sampleUrl = 'assets/pavilion.glb';

/** `aspect`: width over height; `covered`: share of the width that the panel hides at the right. */
export function sampleView(aspect, covered) {
  const back = Math.max(1, seenAspect / (aspect * (1 - covered)));
  const away = eye.from.map((value, i) => (value - eye.to[i]) * back);
  const distance = Math.hypot(...away);
  const width = 2 * Math.tan((eye.fov * Math.PI) / 360) * distance * aspect;
  // Moves sideways, so that the scene is in the middle of the visible part.
  const level = Math.hypot(away[0], away[2]);
  const side = [away[2] / level, 0, -away[0] / level].map((value) => value * covered * width * 0.5);
  const to = eye.to.map((value, i) => value + side[i]);
  return {
    camera: { from: to.map((value, i) => value + away[i]), to, fov: eye.fov },
    lights: [[-0.62, 0.62, -0.3, 0]],
    ambient: 0.4,
  };
}
