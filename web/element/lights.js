// A light of the state, an array or by names (see edgeshade-viewer.d.ts), for the panel and the
// attributes.

export const isSun = (light) => (Array.isArray(light) ? light[3] === 0 : 'direction' in light);

/** Position of a point light, or direction to a sun: x, y, z. */
export const placeOf = (light) =>
  (Array.isArray(light) ? light.slice(0, 3) : light.direction ?? light.position);

/** The sun with another direction. */
export const aimed = (sun, direction) =>
  (Array.isArray(sun) ? [...direction, 0] : { ...sun, direction });

/** Name of its kind: sun, spot or point light. */
export function kindOf(light) {
  if (isSun(light)) return 'sun';
  return light.cone ? 'spot' : 'point light';
}

/** The light with another extent, by names; 0: none. A rectangle becomes a sphere. */
export function withExtent(light, value) {
  const named = Array.isArray(light)
    ? { [isSun(light) ? 'direction' : 'position']: light.slice(0, 3), ...(light[4] && { range: light[4] }) }
    : { ...light };
  for (const key of ['radius', 'size', 'facing', 'angle']) delete named[key];
  if (value > 0) named[isSun(light) ? 'angle' : 'radius'] = value;
  return named;
}
