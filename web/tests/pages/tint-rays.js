// Light through see-through meshes by rays on the CPU: the colour of a white floor.

import * as three from 'three';

/** The display's value of linear light, 0 to 255. */
const shown = (light) => 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);

/**
 * Compares a picture, `rgba` with rows from the bottom, with rays, where the first mesh on a pixel's ray is solid. `tintOf(mesh, hit)`:
 * what a mesh lets through, [red, green, blue]; null: it is solid. Each mesh and instance counts once.
 * Returns numbers of pixels: compared, tinted, wrong by more than 3 of 255, and wrong with all
 * neighbours behind the same meshes.
 */
export function tintsComparedWithRays({ rgba, width, height }, scene, camera, light, tintOf) {
  const meshes = [], sides = new Map();
  scene.traverse((object) => {
    if (!object.isMesh) return;
    meshes.push(object);
    sides.set(object.material, object.material.side);
    object.material.side = three.DoubleSide;
  });
  const ray = new three.Raycaster(), aim = new three.Vector2(), normal = new three.Vector3(), towards = new three.Vector3();
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
    const [hit] = ray.intersectObjects(meshes, false);
    if (!hit || tintOf(hit.object)) return null;
    normal.copy(hit.face.normal).transformDirection(hit.object.matrixWorld);
    if (normal.dot(eye) > 0) normal.negate();
    towards.copy(light.position);
    if (near) towards.sub(hit.point);
    ray.near = 1e-5;
    ray.far = near ? towards.length() : Infinity;
    towards.normalize();
    ray.set(hit.point, towards);
    const colour = [1, 1, 1], met = new Set(), lit = normal.dot(towards) > 0;
    for (const crossed of ray.intersectObjects(meshes, false)) {
      const { object, instanceId } = crossed;
      const name = `${object.id} ${instanceId}`;
      if (!object.castShadow || met.has(name)) continue;
      met.add(name);
      const tint = tintOf(object, crossed) ?? [0, 0, 0];
      tint.forEach((share, i) => { colour[i] *= share; });
    }
    return { colour: lit ? colour : [0, 0, 0], key: `${hit.object.id} ${lit} ${[...met].sort()} ${normal.toArray().map(Math.round)}` };
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
