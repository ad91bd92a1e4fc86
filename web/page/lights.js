// A light of the state, an array or by names (see edgeshade-viewer.d.ts), as the panel needs it.

export const isSun = (light) => (Array.isArray(light) ? light[3] === 0 : 'direction' in light);

/** Where a point light is, or where a sun stands: x, y, z. */
export const placeOf = (light) =>
  (Array.isArray(light) ? light.slice(0, 3) : light.direction ?? light.position);

/** The sun with another direction towards it. */
export const aimed = (sun, direction) =>
  (Array.isArray(sun) ? [...direction, 0] : { ...sun, direction });

/** What it is called: sun, spot or point light. */
export function kindOf(light) {
  if (isSun(light)) return 'sun';
  return light.cone ? 'spot' : 'point light';
}
