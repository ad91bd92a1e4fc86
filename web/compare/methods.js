// Ways of drawing shadows, each behind the same calls: draw(frame) draws the world in the current target and viewport,
// bytes() says what it has on the GPU, release() frees what one light's maps take.
//
// A frame is {light, look, biases, softness, redraws}: see LightRig.aim(); `softness`: the light's extent, degrees of a
// sun's disc, hundredths of the scene's radius of a lamp; `redraws`: whether something that casts may have moved.

import { BasicShadowMap, PCFShadowMap, ShaderChunk, VSMShadowMap } from 'three';
import { CSM } from 'three/addons/csm/CSM.js';
import { CSMShader } from 'three/addons/csm/CSMShader.js';
import { bytesOfMaps, LightRig, releaseMaps } from './light-rig.js';
import { withPcss } from './pcss.glsl.js';

/** Sizes that maps come in, texels a side; of a lamp each of six. */
export const mapSizes = [512, 1024, 2048, 4096];

/** A sun's half angle in radians, a lamp's radius. */
const extentOf = ({ light, softness }, radius) =>
  (light.kind === 'sun' ? (0.5 * softness * Math.PI) / 180 : 0.01 * softness * radius);

/** What methods have in common: a rig that is lit while they draw, and copies of the materials. */
class Method {
  constructor(world, id, mapSize) {
    this.world = world;
    this.id = id;
    this.rig = new LightRig(mapSize);
    world.scene.add(this.rig.group);
  }

  /** What it makes of a copy of the file's materials. */
  change() {}

  draw(frame) {
    const { world, rig } = this;
    world.skins.wear(this.id, frame.look, (material) => this.change(material));
    rig.aim(frame.light, world, frame.look, frame.biases);
    rig.redraws = frame.redraws;
    rig.group.visible = true;
    world.setLook(frame.look);
    try {
      this.render(frame);
    } finally {
      rig.group.visible = false;
    }
  }

  bytes() {
    return bytesOfMaps(this.rig.light.shadow);
  }

  release() {
    this.rig.release();
  }

  dispose() {
    this.release();
    this.world.scene.remove(this.rig.group);
    this.world.skins.drop(this.id);
  }
}

class Unshadowed extends Method {
  render() {
    const { renderer, scene, camera } = this.world;
    renderer.shadowMap.enabled = false;
    this.rig.light.castShadow = false;
    renderer.render(scene, camera);
  }

  bytes() {
    return 0;
  }
}

class Exact extends Method {
  constructor(world, id, mapSize, { soft }) {
    super(world, id);
    this.soft = soft;
  }

  render(frame) {
    const { exact, renderer, scene, camera, radius } = this.world;
    renderer.shadowMap.enabled = false;
    this.rig.light.castShadow = true;
    exact.setRadius(this.rig.light, this.soft ? extentOf(frame, radius) : 0);
    exact.render(scene, camera);
  }

  bytes() {
    return this.world.exact.cost?.bytes ?? 0;
  }
}

class Mapped extends Method {
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

class Pcss extends Mapped {
  #uniforms = { pcssSize: { value: 0 }, pcssExtent: { value: null } };

  change(material) {
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.#uniforms);
      shader.fragmentShader = withPcss(shader.fragmentShader, ShaderChunk);
    };
    material.customProgramCacheKey = () => this.id; // programs keep the uniforms that they were made with
  }

  render(frame) {
    const extent = extentOf(frame, this.world.radius);
    this.#uniforms.pcssSize.value = frame.light.kind === 'sun' ? Math.tan(extent) : extent;
    this.#uniforms.pcssExtent.value = this.rig.sunExtent;
    super.render(frame);
  }
}

/** three.js's cascades; its sun is one of their lights each, not the rig's. */
class Cascades extends Method {
  #csm = null;
  #mapSize;
  #seen = ''; // what the cascades were cut for

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
    // It puts its chunks in place of everybody's; change() gives them to its own materials.
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

/**
 * By name, in the order of tables. `lights`: which it draws shadows of; `sized`: whether it has maps of a size;
 * `reference`: the method whose shadows it means to draw; `keepsMap`: whether its map is right as long as the light
 * rests, whatever the camera does.
 */
export const methods = {
  exact: { label: 'edgeshade', Kind: Exact, soft: false, lights: ['sun', 'lamp'], reference: 'exact' },
  'exact-soft': { label: 'edgeshade, soft', Kind: Exact, soft: true, lights: ['sun', 'lamp'], reference: 'exact-soft' },
  basic: { label: 'Map, no filter', Kind: Mapped, type: BasicShadowMap, lights: ['sun', 'lamp'], sized: true, reference: 'exact', keepsMap: true },
  pcf: { label: 'Map, PCF', Kind: Mapped, type: PCFShadowMap, lights: ['sun', 'lamp'], sized: true, reference: 'exact', keepsMap: true },
  vsm: { label: 'Map, VSM', Kind: Mapped, type: VSMShadowMap, lights: ['sun'], sized: true, reference: 'exact', keepsMap: true },
  pcss: { label: 'Map, PCSS', Kind: Pcss, type: BasicShadowMap, lights: ['sun', 'lamp'], sized: true, reference: 'exact-soft', keepsMap: true },
  csm: { label: '3 cascades (CSM)', Kind: Cascades, lights: ['sun'], sized: true, reference: 'exact', keepsMap: false },
  none: { label: 'No shadows', Kind: Unshadowed, lights: ['sun', 'lamp'], reference: null },
};

/** A method's name with its map's size, as addresses and results have it: 'pcf-2048'. */
export const idOf = (name, mapSize) => (methods[name].sized ? `${name}-${mapSize}` : name);

export const labelOf = (name, mapSize) => (methods[name].sized ? `${methods[name].label}, ${mapSize}` : methods[name].label);

export function makeMethod(world, name, mapSize) {
  const { Kind, ...of } = methods[name];
  return new Kind(world, idOf(name, mapSize), mapSize, of);
}
