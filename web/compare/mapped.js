// three.js's own maps, and this project's filter for them.

import { ShaderChunk } from 'three';
import { extentOf, Method } from './method.js';
import { withPcss } from './pcss.glsl.js';

/** `type`: three.js's name of the filter. */
export class Mapped extends Method {
  constructor(world, id, mapSize, { type }) {
    super(world, id, mapSize);
    this.type = type;
  }

  render() {
    const { renderer, scene, camera } = this.world;
    Object.assign(renderer.shadowMap, { enabled: true, type: this.type });
    this.rig.light.castShadow = true;
    renderer.render(scene, camera);
  }
}

export class Pcss extends Mapped {
  #uniforms = { pcssSize: { value: 0 }, pcssExtent: { value: null } };

  change(material) {
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.#uniforms);
      shader.fragmentShader = withPcss(shader.fragmentShader, ShaderChunk);
    };
    material.customProgramCacheKey = () => this.id; // programs keep the uniforms they were compiled
                                                    // with
  }

  render(frame) {
    const extent = extentOf(frame, this.world.radius);
    this.#uniforms.pcssSize.value = frame.light.kind === 'sun' ? Math.tan(extent) : extent;
    this.#uniforms.pcssExtent.value = this.rig.sunExtent;
    super.render(frame);
  }
}
