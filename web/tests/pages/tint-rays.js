// Light through see-through meshes by rays on the CPU: the colour of a white floor.

import * as three from 'three';
import { normalOf } from './rays.js';
import { isHole } from './texel-alpha.js';

/** The display's value of linear light, 0 to 255. */
const shown = (light) => 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);

/** Tints that count of a mesh on a ray: a solid's at one of its sides. */
const sideOf = ({ in: entered, out }) => (entered.length > out.length ? entered : out);

/**
 * Compares a picture, `rgba` with rows from the bottom, with rays, where the first mesh on a pixel's ray is solid.
 * `tintOf(mesh, hit)`: what a mesh lets through, [red, green, blue]; null: it is solid where it has no hole. A closed
 * mesh counts once for each time that light enters it. `unit`: the length of what would be 1. Returns numbers of
 * pixels: compared, tinted, wrong by more than 3 of 255, and wrong with all neighbours behind the same meshes.
 */
export function tintsComparedWithRays({ rgba, width, height }, scene, camera, light, tintOf, unit = 1) {
  const meshes = [], sides = new Map();
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  scene.traverseVisible((object) => {
    if (!object.isMesh) return;
    meshes.push(object);
    for (const material of [object.material].flat()) {
      if (!sides.has(material)) sides.set(material, material.side);
      material.side = three.DoubleSide;
    }
  });
  const ray = new three.Raycaster(), aim = new three.Vector2(), towards = new three.Vector3();
  const near = !light.isDirectionalLight;
  const found = new Map();
  const at = (x, y) => {
    const key = y * width + x;
    if (x < 0 || y < 0 || x >= width || y >= height) return null;
    if (!found.has(key)) found.set(key, one(x, y));
    return found.get(key);
  };
  const one = (x, y) => {
    ray.setFromCamera(aim.set(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1), camera);
    ray.far = Infinity;
    ray.near = 0;
    const eye = ray.ray.direction.clone();
    const hit = ray.intersectObjects(meshes, false).find((crossed) => !isHole(crossed));
    if (!hit || tintOf(hit.object)) return null;
    const normal = normalOf(hit);
    if (normal.dot(eye) > 0) normal.negate();
    towards.copy(light.position).sub(near ? hit.point : light.target.position);
    ray.near = 1e-5 * unit;
    ray.far = near ? towards.length() : Infinity;
    towards.normalize();
    ray.set(hit.point, towards);
    const inCone = !light.isSpotLight || towards.dot(light.position.clone().sub(light.target.position).normalize()) > Math.cos(light.angle);
    const met = new Map(), lit = inCone && (normal.dot(towards) > 0 || !hit.object.castShadow);
    for (const crossed of ray.intersectObjects(meshes, false)) {
      const { object, instanceId } = crossed;
      if (!object.castShadow || isHole(crossed)) continue;
      const name = `${object.id} ${instanceId}`;
      if (!met.has(name)) met.set(name, { in: [], out: [] });
      met.get(name)[normalOf(crossed).dot(towards) > 0 ? 'in' : 'out'].push(tintOf(object, crossed) ?? [0, 0, 0]);
    }
    const colour = [1, 1, 1];
    for (const sidesMet of met.values()) for (const tint of sideOf(sidesMet)) tint.forEach((share, i) => { colour[i] *= share; });
    const names = [...met].map(([name, sidesMet]) => `${name} ${sideOf(sidesMet).length}`).sort();
    return { colour: lit ? colour : [0, 0, 0], key: `${hit.object.id} ${lit} ${names} ${normal.toArray().map(Math.round)}` };
  };
  const told = { compared: 0, tinted: 0, wrong: 0, beyond: 0 };
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const here = at(x, y);
      if (!here) continue;
      told.compared += 1;
      told.tinted += here.colour.some((share) => share > 0 && share < 1) ? 1 : 0;
      if (here.colour.every((share, i) => Math.abs(shown(share) - rgba[4 * (y * width + x) + i]) <= 3)) continue;
      told.wrong += 1;
      let border = false;
      for (const v of [-1, 0, 1]) for (const u of [-1, 0, 1]) border ||= at(x + u, y + v)?.key !== here.key;
      told.beyond += border ? 0 : 1;
    }
  for (const [material, side] of sides) material.side = side;
  return told;
}

/** The same for the canvas of a WebGLRenderer. */
export function comparedTints(renderer, ...others) {
  const gl = renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const rgba = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  return tintsComparedWithRays({ rgba, width, height }, ...others);
}
