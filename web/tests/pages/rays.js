// Shadows of small clipped scenes by rays on the CPU, and comparisons of pictures with them.

import * as three from 'three';
import { isHole } from './texel-alpha.js';

const materialOf = ({ object: { material }, face }) => (Array.isArray(material) ? material[face.materialIndex] : material);

/** Whether masks show the surface that a ray has hit, and it may cast. */
const isSolid = (hit, seeThroughCasts) => {
  const { transparent, wireframe } = materialOf(hit);
  return (!transparent || seeThroughCasts) && !wireframe;
};

const isBeyond = (point) => (plane) => plane.distanceToPoint(point) < 0;

/** Whether a material's own planes clip a point. */
function clipsLocally(renderer, { clippingPlanes, clipIntersection }, point) {
  if (!renderer.localClippingEnabled || !clippingPlanes?.length) return false;
  return clipIntersection ? clippingPlanes.every(isBeyond(point)) : clippingPlanes.some(isBeyond(point));
}

/** The instance's number in an instanced or batched mesh, or undefined. */
const numberOf = ({ instanceId, batchId }) => instanceId ?? batchId;

const place = new three.Matrix4(), turning = new three.Matrix3();

/** Normal in the world of the triangle that a ray has hit, on its front. */
export function normalOf(hit) {
  const { object, face } = hit, number = numberOf(hit);
  if (number === undefined) place.identity();
  else object.getMatrixAt(number, place);
  return face.normal.clone().applyNormalMatrix(turning.getNormalMatrix(place.premultiply(object.matrixWorld)));
}

/**
 * By pixel, rows from the top: 0 no surface, 1 in shadow, 2 lit, and the mesh's number times 4 and
 * face's times 256 besides, so that outlines can be told.
 */
function rayPicture(renderer, scene, camera, light, { seeThroughCasts = false, unit = 1 }) {
  const { drawingBufferWidth: width, drawingBufferHeight: height } = renderer.getContext();
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  const meshes = [];
  scene.traverseVisible((object) => { if (object.isMesh) meshes.push(object); });
  const ray = new three.Raycaster(), aim = new three.Vector2(), towards = new three.Vector3(), axis = new three.Vector3();
  const found = new Float64Array(width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      ray.setFromCamera(aim.set(2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height), camera);
      ray.near = 0;
      ray.far = Infinity;
      ray.layers.mask = camera.layers.mask;
      const eye = ray.ray.direction.clone();
      const hit = ray.intersectObjects(meshes, false).find((one) => isSolid(one, seeThroughCasts) && !isHole(one) &&
        !renderer.clippingPlanes.some(isBeyond(one.point)) && !clipsLocally(renderer, materialOf(one), one.point));
      if (!hit) continue;
      const normal = normalOf(hit);
      if (normal.dot(eye) > 0) normal.negate();
      towards.copy(light.position);
      const near = light.isPointLight || light.isSpotLight;
      if (near) towards.sub(hit.point);
      else towards.sub(light.target.position);
      ray.near = 1e-5 * unit;
      ray.far = near ? towards.length() : Infinity;
      towards.normalize();
      const inCone = !light.isSpotLight || towards.dot(axis.copy(light.position).sub(light.target.position).normalize()) > Math.cos(light.angle);
      const faces = inCone && (normal.dot(towards) > 0 || !hit.object.castShadow); // white is lit from behind, too, where nothing casts
      ray.set(hit.point, towards);
      ray.layers.enableAll();
      const lit = faces && !ray.intersectObjects(meshes, false).some((one) => one.object.castShadow && isSolid(one, seeThroughCasts) && !isHole(one) &&
        !(materialOf(one).clipShadows && clipsLocally(renderer, materialOf(one), one.point)));
      const side = Math.round(normal.x) + 3 * Math.round(normal.y) + 9 * Math.round(normal.z) + 13;
      found[y * width + x] = (lit ? 2 : 1) + 4 * (1 + meshes.indexOf(hit.object)) + 256 * side + 8192 * (numberOf(hit) ?? 0);
    }
  return { found, width, height };
}

/**
 * Compares red bytes (redOf()) of white surfaces with rays. Returns numbers of pixels: with
 * surfaces, in shadow, wrong, and wrong with no outline or border of shadow within a pixel.
 */
export function comparedWithRays(red, renderer, scene, camera, light, options = {}) {
  const { found, width, height } = rayPicture(renderer, scene, camera, light, options);
  const told = { surfaces: 0, dark: 0, wrong: 0, beyond: 0 };
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const here = found[y * width + x];
      if (here === 0) continue;
      const lit = here % 4 === 2;
      told.surfaces += 1;
      told.dark += lit ? 0 : 1;
      if ((red[y * width + x] > 127) === lit) continue;
      told.wrong += 1;
      let border = false;
      for (let v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); ++v)
        for (let u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); ++u) border ||= found[v * width + u] !== here;
      told.beyond += border ? 0 : 1;
    }
  return told;
}
