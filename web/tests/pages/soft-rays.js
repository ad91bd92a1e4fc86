// Penumbras by rays on the CPU to each point of a light: the grey of white surfaces.

import * as three from 'three';
import { normalOf } from './rays.js';

/** The display's value of linear light, 0 to 255. */
const shown = (light) => 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);

/**
 * Compares the canvas of a scene of white meshes with rays. `points`: [x, y, z, w] of the light. Returns
 * numbers of pixels: compared, grey, wrong by more than 3 of 255, and wrong where that isn't between
 * what neighbours on the same mesh and side have, either.
 */
export function comparedShares(renderer, scene, camera, points) {
  const gl = renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const rgba = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  const meshes = [];
  scene.traverse((object) => { if (object.isMesh) meshes.push(object); });
  const ray = new three.Raycaster(), aim = new three.Vector2(), towards = new three.Vector3();
  const casting = meshes.filter((mesh) => mesh.castShadow);
  const found = [];
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      ray.setFromCamera(aim.set(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1), camera);
      ray.near = 0;
      ray.far = Infinity;
      const eye = ray.ray.direction.clone();
      const [hit] = ray.intersectObjects(meshes, false);
      if (!hit) {
        found.push(null);
        continue;
      }
      const normal = normalOf(hit);
      if (normal.dot(eye) > 0) normal.negate();
      let lit = 0;
      for (const [px, py, pz, w] of points) {
        towards.set(px, py, pz).addScaledVector(hit.point, -w);
        ray.near = 1e-5;
        ray.far = w ? towards.length() : Infinity;
        ray.set(hit.point, towards.normalize());
        if (normal.dot(towards) > 0 || !hit.object.castShadow) lit += ray.intersectObjects(casting, false).length ? 0 : 1;
      }
      found.push({ share: lit / points.length, on: `${hit.object.id} ${normal.toArray().map(Math.round)}` });
    }
  const told = { compared: 0, grey: 0, wrong: 0, beyond: 0 };
  for (const [i, here] of found.entries()) {
    if (!here) continue;
    const red = rgba[4 * i], x = i % width;
    told.compared += 1;
    told.grey += here.share > 0 && here.share < 1 ? 1 : 0;
    if (Math.abs(shown(here.share) - red) <= 3) continue;
    told.wrong += 1;
    let edge = false, least = 1, most = 0;
    for (const v of [-width, 0, width])
      for (const u of [-1, 0, 1]) {
        const other = x + u >= 0 && x + u < width ? found[i + v + u] : here;
        edge ||= other?.on !== here.on;
        if (other) [least, most] = [Math.min(least, other.share), Math.max(most, other.share)];
      }
    told.beyond += !edge && (red < shown(least) - 3 || red > shown(most) + 3) ? 1 : 0;
  }
  return told;
}
