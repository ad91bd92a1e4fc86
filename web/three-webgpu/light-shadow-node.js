// A light's shadow node, which three.js takes from light.shadow.shadowNode: it looks the light up in
// its primitive map, and samples three.js's own map of the casters that this lacks.

import { BackSide, Vector2 } from 'three';
import { bool, float, Fn, frontFacing, If, Loop, min, mix, reference, renderGroup, uniform, vec3 } from 'three/tsl';
import { ShadowBaseNode } from 'three/webgpu';
import { lookUp, lookUpPoints, placeOnTriangle } from './lookup.js';
import { MapNodes } from './map-nodes.js';
import { ownMapOf } from './own-map.js';

export class LightShadowNode extends ShadowBaseNode {
  isGone = false; // end() was called
  #map = new MapNodes();
  #casters = new Set();
  #drawsOwn = uniform(0, 'int').setGroup(renderGroup);
  #own;
  #casts;
  #isHigher = false; // light.shadow.mapSize, by one texel
  #ownSize = new Vector2();
  #lookups = { cutouts: false, tints: false, soft: false }; // that shaders have

  static get type() {
    return 'EdgeshadeLightShadowNode';
  }

  /** `casts(mesh)`: whether all of a mesh casts. */
  constructor(light, casts) {
    super(light);
    this.updateBeforeType = 'none';
    this.#own = ownMapOf(light, this.#casters, () => {
      this.#ownSize.copy(light.shadow.mapSize);
      if (this.#isHigher) this.#ownSize.height -= 1;
      return this.#ownSize;
    });
    this.#casts = uniform(0, 'int').onObjectUpdate(({ object }) => (casts(object) ? 1 : 0));
  }

  /**
   * What shaders look up that are compiled from now on, cutouts and tints in addition to what they did: {cutouts,
   * tints; soft: points of a light with a radius}. Returns whether they differ.
   */
  require({ cutouts, tints, soft = this.#lookups.soft }) {
    const before = this.#lookups;
    this.#lookups = { cutouts: Boolean(before.cutouts || cutouts), tints: Boolean(before.tints || tints), soft };
    return Object.keys(before).some((name) => before[name] !== this.#lookups[name]);
  }

  /**
   * `map`: of RestingLights, or null; `others`: casters for three.js's own map; `changed`: whether
   * the answers of casts() have changed.
   */
  show(map, others, changed) {
    this.#casters.clear();
    for (const mesh of others) this.#casters.add(mesh);
    const before = this.#drawsOwn.value;
    this.#drawsOwn.value = this.#casters.size > 0 ? 1 : 0;
    // three.js's own map may have another size than when it was last drawn.
    if (this.#map.show(map) || changed || before < this.#drawsOwn.value) this.#rebind();
  }

  setup({ material, camera }) {
    const front = material.side === BackSide ? bool(true) : frontFacing; // the backs are the map's fronts
    const intensity = reference('intensity', 'float', this.light.shadow).setGroup(renderGroup);
    return Fn(() => {
      const place = placeOnTriangle(Boolean(camera?.isArrayCamera)); // whose views differ within a render
      const share = { lit: float(1).toVar(), tint: this.#lookups.tints ? vec3(1).toVar() : null, cutouts: this.#lookups.cutouts };
      const given = { map: this.#map, directional: Boolean(this.light.isDirectionalLight), place, casts: this.#casts.equal(1).toVar(),
        held: this.#drawsOwn.equal(0), front, share };
      // A loop, since a branch doesn't keep software renderers from sampling a map that isn't there.
      Loop({ start: 0, end: this.#map.present, type: 'int', condition: '<', name: 'lookup' }, () => (this.#lookups.soft ? lookUpPoints : lookUp)(given));
      const shown = mix(vec3(1), vec3(share.tint ? share.tint.mul(share.lit) : share.lit), intensity).toVar();
      If(this.#drawsOwn.equal(1), () => { shown.assign(min(shown, vec3(float(this.#own)))); });
      return shown;
    })();
  }

  /**
   * Makes three.js bind textures again, and ask for the uniforms of objects that rest: it does so when
   * light.shadow.mapSize changes. The map that it draws keeps its size.
   */
  #rebind() {
    this.light.shadow.mapSize.height += this.#isHigher ? -1 : 1;
    this.#isHigher = !this.#isHigher;
  }

  dispose() {
    this.#own.dispose();
    super.dispose();
  }

  /** Frees the map's table, too. */
  end() {
    this.isGone = true;
    if (this.#isHigher) this.#rebind();
    this.dispose();
    this.#map.dispose();
  }
}
