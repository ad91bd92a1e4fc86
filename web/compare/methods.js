// All compared ways of drawing shadows.

import { BasicShadowMap, PCFShadowMap, VSMShadowMap } from 'three';
import { Rays } from './bvh.js';
import { Cascades } from './cascades.js';
import { Mapped, Pcss } from './mapped.js';
import { extentOf, Method } from './method.js';
import { TwoCascades } from './sun-light.js';

/** Sizes of maps, in texels per side; a lamp has six maps of that size. */
export const mapSizes = [512, 1024, 2048, 4096];

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

const map = { sized: true, reference: 'exact', keepsMap: true };

/**
 * Methods by name, in the order of tables. `lights`: the lights whose shadows it draws; `sized`:
 * whether it has maps of a size; `reference`: the method whose shadows it approximates; `keepsMap`:
 * whether its map stays valid while the light rests, whatever the camera does.
 */
export const methods = {
  exact: { label: 'edgeshade', Kind: Exact, soft: false, lights: ['sun', 'lamp'], reference: 'exact' },
  'exact-soft': { label: 'edgeshade, soft', Kind: Exact, soft: true, lights: ['sun', 'lamp'], reference: 'exact-soft' },
  basic: { label: 'Map, no filter', Kind: Mapped, type: BasicShadowMap, lights: ['sun', 'lamp'], ...map },
  pcf: { label: 'Map, PCF', Kind: Mapped, type: PCFShadowMap, lights: ['sun', 'lamp'], ...map },
  vsm: { label: 'Map, VSM', Kind: Mapped, type: VSMShadowMap, lights: ['sun'], ...map },
  pcss: { label: 'Map, PCSS', Kind: Pcss, type: BasicShadowMap, lights: ['sun', 'lamp'], ...map, reference: 'exact-soft' },
  csm: { label: '3 cascades (CSM)', Kind: Cascades, lights: ['sun'], ...map, keepsMap: false },
  sunlight: { label: '2 cascades (SunLight)', Kind: TwoCascades, lights: ['sun'], ...map, keepsMap: false },
  bvh: { label: 'A ray a pixel (three-mesh-bvh)', Kind: Rays, lights: ['sun', 'lamp'], reference: 'exact' },
  none: { label: 'No shadows', Kind: Unshadowed, lights: ['sun', 'lamp'], reference: null },
};

/** A method's name with its map's size, as in addresses and results: 'pcf-2048'. */
export const idOf = (name, mapSize) => (methods[name].sized ? `${name}-${mapSize}` : name);

export const labelOf = (name, mapSize) => (methods[name].sized ? `${methods[name].label}, ${mapSize}` : methods[name].label);

export function makeMethod(world, name, mapSize) {
  const { Kind, ...of } = methods[name];
  return new Kind(world, idOf(name, mapSize), mapSize, of);
}
