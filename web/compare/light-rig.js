// The light of one method: its own sun and lamp, one of them lit, with maps that fit the scene.

import { DirectionalLight, Group, Matrix4, PointLight, Vector3 } from 'three';

const corner = new Vector3(), sunSpace = new Matrix4();

/** Brightness of a white surface that faces the light; in masks, the value that is written. */
const brightness = { shown: 3, mask: Math.PI };

/** The corners of a Box3. */
function* cornersOf({ min, max }) {
  for (const x of [min.x, max.x]) for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) yield corner.set(x, y, z);
}

export class LightRig {
  group = new Group();
  #sun = new DirectionalLight();
  #lamp = new PointLight();

  /** `mapSize`: 0 for none. */
  constructor(mapSize = 0) {
    this.group.add(this.#sun, this.#sun.target, this.#lamp);
    this.group.visible = false;
    for (const light of [this.#sun, this.#lamp]) if (mapSize) light.shadow.mapSize.set(mapSize, mapSize);
  }

  /** The light that is on. */
  get light() {
    return this.#lamp.visible ? this.#lamp : this.#sun;
  }

  /**
   * `light`: {kind: 'sun', direction: towards it} or {kind: 'lamp', position}; `scene`: {box,
   * radius, center}; `biases`: three.js's {bias, normalBias}.
   */
  aim(light, { box, radius, center }, look, { bias, normalBias }) {
    const isSun = light.kind === 'sun';
    this.#sun.visible = isSun;
    this.#lamp.visible = !isSun;
    Object.assign(this.light.shadow, { bias, normalBias });
    if (isSun) this.#aimSun(light.direction, box, radius, center);
    else this.#placeLamp(light.position, radius, center);
    this.#sun.intensity = brightness[look];
    // The lamp is as bright as the sun at a distance of 0.4 radii; in masks it is so everywhere.
    Object.assign(this.#lamp, look === 'mask' ? { decay: 0, intensity: brightness.mask }
      : { decay: 2, intensity: brightness.shown * (0.4 * radius) ** 2 });
  }

  #aimSun(direction, box, radius, center) {
    const sun = this.#sun, lens = sun.shadow.camera;
    sun.target.position.copy(center);
    sun.position.set(...direction).setLength(2 * radius).add(center);
    // Fits the sun's map as tightly as the box allows.
    sunSpace.lookAt(sun.position, center, sun.up).setPosition(sun.position).invert();
    const [low, high] = [new Vector3(Infinity, Infinity, Infinity), new Vector3(-Infinity, -Infinity, -Infinity)];
    for (const at of cornersOf(box)) {
      at.applyMatrix4(sunSpace);
      low.min(at);
      high.max(at);
    }
    const spare = 0.002 * radius;
    Object.assign(lens, { left: low.x - spare, right: high.x + spare, bottom: low.y - spare, top: high.y + spare,
      near: -high.z - spare, far: -low.z + spare });
    lens.updateProjectionMatrix();
  }

  #placeLamp(position, radius, center) {
    const lens = this.#lamp.shadow.camera;
    this.#lamp.position.set(...position);
    lens.near = 0.01 * radius;
    lens.far = this.#lamp.position.distanceTo(center) + 1.01 * radius;
    lens.updateProjectionMatrix();
  }

  /** Width, height and depth that the sun's map covers. */
  get sunExtent() {
    const { left, right, top, bottom, near, far } = this.#sun.shadow.camera;
    return new Vector3(right - left, top - bottom, far - near);
  }

  /** Whether every frame redraws the map. */
  set redraws(always) {
    for (const { shadow } of [this.#sun, this.#lamp]) shadow.autoUpdate = always;
  }

  release() {
    for (const { shadow } of [this.#sun, this.#lamp]) releaseMaps(shadow);
  }
}

/** Frees the textures of a light's map. */
export function releaseMaps(shadow) {
  shadow.map?.depthTexture?.dispose();
  shadow.dispose();
  shadow.map = shadow.mapPass = null;
}

/** Size of a map on the GPU: its depths, and the colours that three.js allocates with them. */
export function bytesOfMaps({ map, mapPass }) {
  if (!map) return 0;
  const texels = map.width * map.height * (map.isWebGLCubeRenderTarget ? 6 : 1);
  const colors = 4; // RGBA of 8 bits, or two halves
  return texels * (colors + 4) + (mapPass ? mapPass.width * mapPass.height * colors : 0);
}
