// three.js's cascaded shadow maps.

import { PCFShadowMap, ShaderChunk } from 'three';
import { CSM } from 'three/addons/csm/CSM.js';
import { CSMShader } from 'three/addons/csm/CSMShader.js';
import { bytesOfMaps, releaseMaps } from './light-rig.js';
import { Method } from './method.js';

/** Each cascade has its own light in place of the rig's sun. */
export class Cascades extends Method {
  #csm = null;
  #mapSize;
  #seen = ''; // the view that the cascades were last fitted to

  constructor(world, id, mapSize) {
    super(world, id);
    this.#mapSize = mapSize;
  }

  #made() {
    if (this.#csm) return this.#csm;
    const { camera, radius } = this.world;
    const { lights_fragment_begin, lights_pars_begin } = ShaderChunk;
    this.#csm = new CSM({ camera, parent: this.rig.group, cascades: 3, maxFar: Infinity, shadowMapSize: this.#mapSize,
      lightMargin: 2 * radius, lightNear: 0.01 * radius, lightFar: 8 * radius });
    // CSM replaces shader chunks for all materials: this restores them, and change() gives CSM's to
    // its own materials.
    Object.assign(ShaderChunk, { lights_fragment_begin, lights_pars_begin });
    this.#seen = '';
    return this.#csm;
  }

  change(material) {
    this.#made().setupMaterial(material);
    const { onBeforeCompile } = material;
    material.onBeforeCompile = (shader) => {
      onBeforeCompile(shader);
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <lights_pars_begin>', CSMShader.lights_pars_begin)
        .replace('#include <lights_fragment_begin>', CSMShader.lights_fragment_begin);
    };
    material.customProgramCacheKey = () => this.id;
  }

  render({ light, biases }) {
    const { renderer, scene, camera } = this.world;
    const csm = this.#made();
    csm.lightDirection.set(...light.direction).normalize().negate();
    const sun = this.rig.light;
    sun.visible = false;
    for (const each of csm.lights) {
      each.intensity = sun.intensity;
      Object.assign(each.shadow, biases);
    }
    const seen = camera.projectionMatrix.elements.join();
    if (this.#seen !== seen) csm.updateFrustums();
    this.#seen = seen;
    camera.updateMatrixWorld();
    csm.update();
    Object.assign(renderer.shadowMap, { enabled: true, type: PCFShadowMap });
    renderer.render(scene, camera);
  }

  bytes() {
    return (this.#csm?.lights ?? []).reduce((sum, { shadow }) => sum + bytesOfMaps(shadow), 0);
  }

  release() {
    for (const { shadow } of this.#csm?.lights ?? []) releaseMaps(shadow);
  }

  dispose() {
    super.dispose();
    this.#csm?.remove();
  }
}
