// A small scene and its pictures in render targets, for tests of other cameras.

import * as three from 'three';
import { comparedWithRays } from './rays.js';

/** A white court with a wall, a chest and columns, seen from above, and a sun or a lamp. */
export function court({ lamp = false, side = three.FrontSide, renderer = null } = {}) {
  const scene = new three.Scene();
  const gradientMap = new three.DataTexture(new Uint8Array(8).fill(255), 2, 1);
  gradientMap.needsUpdate = true;
  const material = new three.MeshToonMaterial({ color: 0xffffff, side, gradientMap });
  const placed = (geometry, at) => {
    const mesh = new three.Mesh(geometry, material);
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.position.set(...at);
    scene.add(mesh);
    return mesh;
  };
  const boxOf = (size, at) => placed(new three.BoxGeometry(...size), at);
  const ground = boxOf([9, 0.2, 9], [0, -0.1, 0]);
  const wall = boxOf([5, 1.6, 0.2], [0.3, 0.8, -2.1]);
  const chest = boxOf([0.9, 0.7, 0.6], [-0.6, 0.65, 0.4]);
  const columns = [[1.2, 0.8, 0.9], [1.4, 0.8, -0.8], [-1.8, 0.8, -0.9]].map((at) => placed(new three.CylinderGeometry(0.2, 0.2, 1.6, 7), at));
  const light = lamp ? new three.PointLight(0xffffff, Math.PI, 0, 0) : new three.DirectionalLight(0xffffff, Math.PI);
  light.position.set(...(lamp ? [0.15, 3.47, 0.31] : [-0.9, 1, -0.3]));
  light.castShadow = true;
  scene.add(light);
  const camera = new three.PerspectiveCamera(50, 1.6, 0.1, 100);
  camera.position.set(4.3, 5.1, 5.2);
  camera.lookAt(0, 0.4, 0);
  return { renderer, scene, camera, light, material, ground, wall, chest, columns, placed, boxOf };
}

/** A target of bytes, as readable as a canvas. */
export const targetOf = (width, height) => new three.WebGLRenderTarget(width, height, { minFilter: three.NearestFilter, magFilter: three.NearestFilter });

/** Red bytes of a target, or of a cube's face, rows from the top. */
export function redOfTarget(renderer, target, face) {
  const { width, height, texture } = target;
  const halves = texture.type === three.HalfFloatType;
  const rgba = new (halves ? Uint16Array : Uint8Array)(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, rgba, face);
  const red = [];
  for (let y = height - 1; y >= 0; --y)
    for (let x = 0; x < width; ++x) red.push(halves ? 255 * three.DataUtils.fromHalfFloat(rgba[4 * (y * width + x)]) : rgba[4 * (y * width + x)]);
  return red;
}

/** The part of a picture's red bytes at x, y from the top. */
export function partOf(red, wide, x, y, width, height) {
  const part = [];
  for (let row = y; row < y + height; ++row) part.push(...red.slice(row * wide + x, row * wide + x + width));
  return part;
}

/** comparedWithRays() for a picture of any size. */
export function judged(red, width, height, scene, camera, light, { clippingPlanes = [] } = {}) {
  const pretended = { getContext: () => ({ drawingBufferWidth: width, drawingBufferHeight: height }), clippingPlanes, localClippingEnabled: true };
  return comparedWithRays(red, pretended, scene, camera, light);
}
