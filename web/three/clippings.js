// Clipping planes of three.js in the mask engine's form.

/** For meshes that no plane clips. */
export const unclipped = [];

/** three.js's planes as rows of four numbers. One that is not finite clips all or nothing. */
export const rowsOf = (planes) => planes.map(({ normal: { x, y, z }, constant }) => {
  const row = [x, y, z, constant];
  return row.every(Number.isFinite) ? row : [0, 0, 0, constant === -Infinity ? -1 : 1];
});

/** Whether the planes have the numbers of these rows; makes no garbage. */
export function sameRows(rows, planes) {
  if (rows.length !== planes.length) return false;
  for (let i = 0; i < rows.length; ++i) {
    const { normal, constant } = planes[i], row = rows[i];
    if (row[0] !== normal.x || row[1] !== normal.y || row[2] !== normal.z || row[3] !== constant) return false;
  }
  return true;
}

export class Clippings {
  #renderer;
  #known = new WeakMap(); // by material

  constructor(renderer) {
    this.#renderer = renderer;
  }

  /**
   * What clips a material's surfaces, for ShadowMasks.setClippings(): the same array until a number
   * changes. As in three.js's own shadow maps, the renderer's planes leave casters whole, and so do
   * a material's without clipShadows.
   */
  of(material) {
    const { clippingPlanes: everywhere, localClippingEnabled } = this.#renderer;
    const own = (localClippingEnabled && material.clippingPlanes) || unclipped;
    if (everywhere.length + own.length === 0) return unclipped;
    const intersection = Boolean(material.clipIntersection), casts = !material.clipShadows;
    const known = this.#known.get(material);
    if (known && sameRows(known[0].planes, everywhere) && sameRows(known[1].planes, own) &&
        known[1].intersection === intersection && known[1].casts === casts) return known;
    const clippings = [{ planes: rowsOf(everywhere), casts: true }, { planes: rowsOf(own), intersection, casts }];
    this.#known.set(material, clippings);
    return clippings;
  }
}
