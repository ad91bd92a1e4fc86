// The shadow nodes of casting lights, and the casters that three.js's own maps draw.

import { LightShadowNode } from './light-shadow-node.js';

/** Compiles what the light is in again: three.js asks for its shadow node then. */
const compileAgain = (light) => light.dispose();

/** Whether some or all (`which`) of a mesh's materials pass a test. */
const passes = ({ material }, which, test) => (Array.isArray(material) ? material[which](test) : test(material));

export class LightShadows {
  #isHeld;
  #casts;
  #lacksTint;
  #cast = new WeakMap(); // by mesh: whether all of it cast in the last picture
  #nodes = new Map(); // by light: {node, before: its shadow node before, others: casters for three.js's own map; untinted: number of meshes}

  /**
   * `isHeld(mesh, light, map)`: whether all of a mesh casts, and the light's map of RestingLights holds it;
   * `casts(material)`: whether its surfaces cast, if their mesh does; `lacksTint(mesh, light, map)`: whether it is
   * to tint the light, and that map, or null, lacks it.
   */
  constructor(isHeld, casts, lacksTint) {
    this.#isHeld = isHeld;
    this.#casts = casts;
    this.#lacksTint = lacksTint;
  }

  /** Whether all of a mesh casts. */
  #allCasts(mesh) {
    return mesh.castShadow && passes(mesh, 'every', this.#casts);
  }

  /** `maps`: of RestingLights, by light; `meshes`: all that take part; `wanted`: of LightShadowNode.require(). */
  show(lights, maps, meshes, wanted) {
    for (const light of this.#nodes.keys()) if (!lights.includes(light)) this.#drop(light);
    const casting = meshes.filter((mesh) => mesh.castShadow && passes(mesh, 'some', this.#casts));
    const changed = this.#castsChanged(meshes);
    for (const [i, light] of lights.entries()) {
      const entry = this.#nodes.get(light) ?? this.#attach(light);
      if (entry.node.require({ ...wanted, soft: maps[i] ? maps[i].places[1] > 0 : undefined })) compileAgain(light);
      entry.others = maps[i] ? casting.filter((mesh) => !this.#isHeld(mesh, light, maps[i])) : casting;
      entry.untinted = meshes.filter((mesh) => this.#lacksTint(mesh, light, maps[i])).length;
      entry.node.show(maps[i], entry.others, changed);
    }
  }

  /** How a light is shadowed, and why. `resting`: RestingLights.methodOf() of it. */
  methodOf(light, resting) {
    const { others, untinted } = this.#nodes.get(light);
    const told = (method, reason) => ({ light, method, reason: untinted > 0 ? `${reason}; see-through casters that tint nothing meanwhile: ${untinted}` : reason });
    if (!resting) return told('map', 'meshes are being prepared');
    if (resting.method === 'mask') return told('map', resting.reason);
    if (others.length > 0) return told('lookup and movers', `three.js's own map has the casters that came or moved lately: ${others.length}`);
    return untinted > 0 ? told('lookup and movers', 'it rests, and other casters, too') : told('lookup', 'it rests, and so do all casters');
  }

  clear() {
    for (const light of [...this.#nodes.keys()]) this.#drop(light);
  }

  /** Whether a mesh casts that didn't before, or the other way round. */
  #castsChanged(meshes) {
    let changed = false;
    for (const mesh of meshes) {
      const casts = this.#allCasts(mesh);
      changed ||= (this.#cast.get(mesh) ?? casts) !== casts;
      this.#cast.set(mesh, casts);
    }
    return changed;
  }

  #attach(light) {
    const { shadowNode: before } = light.shadow;
    if (before instanceof LightShadowNode) console.warn(`Light '${light.name}' has the shadows of other ExactShadows: dispose() of those first.`);
    const entry = { node: new LightShadowNode(light, (mesh) => this.#allCasts(mesh)), before, others: [], untinted: 0 };
    this.#nodes.set(light, entry);
    light.shadow.shadowNode = entry.node;
    compileAgain(light);
    return entry;
  }

  #drop(light) {
    const { node, before } = this.#nodes.get(light);
    this.#nodes.delete(light);
    if (light.shadow.shadowNode === node) light.shadow.shadowNode = before?.isGone ? undefined : before;
    compileAgain(light);
    node.end();
  }
}
