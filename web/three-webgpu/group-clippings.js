// The clipping groups of a WebGPURenderer in the mask engine's form.

import { rowsOf, sameRows, unclipped } from '../three/clippings.js';

/** Clipping groups that cut what a mesh casts, the innermost first. */
function groupsOf(mesh) {
  const groups = [];
  for (let at = mesh.parent; at; at = at.parent) if (at.isClippingGroup && at.enabled && at.clipShadows) groups.push(at);
  return groups;
}

export class GroupClippings {
  #known = new WeakMap(); // by the innermost group: {union, intersection: rows, clippings}

  /**
   * What clips a mesh, for ShadowMasks.setClippings(): the same array until a number changes. A material's own
   * planes clip nothing in a WebGPURenderer. What all planes of groups with clipIntersection clip is clipped,
   * and what any plane of the others does.
   */
  of(material, mesh) {
    const groups = groupsOf(mesh);
    if (groups.length === 0) return unclipped;
    const planesOf = (intersection) => groups.filter(({ clipIntersection }) => Boolean(clipIntersection) === intersection).flatMap(({ clippingPlanes }) => clippingPlanes);
    const union = planesOf(false), intersection = planesOf(true);
    const known = this.#known.get(groups[0]);
    if (known && sameRows(known.union, union) && sameRows(known.intersection, intersection)) return known.clippings;
    const rows = { union: rowsOf(union), intersection: rowsOf(intersection) };
    const clippings = Object.entries(rows).filter(([, planes]) => planes.length > 0)
      .map(([name, planes]) => ({ planes, intersection: name === 'intersection', casts: false }));
    this.#known.set(groups[0], { ...rows, clippings: clippings.length > 0 ? clippings : unclipped });
    return this.#known.get(groups[0]).clippings;
  }
}
