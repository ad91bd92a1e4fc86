// three.js's addon SunLight: two cascades that it fits itself.

import { PCFShadowMap } from 'three';
import { SunLight } from 'three/addons/lights/SunLight.js';
import { bytesOfMaps, releaseMaps } from './light-rig.js';
import { Method } from './method.js';

/** A SunLight takes the place of the rig's sun. */
export class TwoCascades extends Method {
  #sun = new SunLight();

  constructor(world, id, mapSize) {
    super(world, id);
    this.#sun.shadow.mapSize.set(mapSize, mapSize);
    this.#sun.castShadow = true;
    this.rig.group.add(this.#sun);
  }

  render({ light, biases }) {
    const { renderer, scene, camera, radius } = this.world;
    const sun = this.#sun, { shadow, position } = sun;
    position.set(...light.direction);
    sun.intensity = this.rig.light.intensity;
    this.rig.light.visible = false;
    Object.assign(shadow, biases);
    shadow.camera.far = Math.max(shadow.camera.far, camera.far, 8 * radius);
    Object.assign(renderer.shadowMap, { enabled: true, type: PCFShadowMap });
    renderer.render(scene, camera);
  }

  bytes() {
    return bytesOfMaps(this.#sun.shadow);
  }

  release() {
    releaseMaps(this.#sun.shadow);
  }
}
