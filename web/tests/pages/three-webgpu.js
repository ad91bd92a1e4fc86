// Tools for tests of edgeshade/three-webgpu in a page: the same scenes drawn by both renderers.

import * as three from 'three';
import { float } from 'three/tsl';
import { ClippingGroup, CubeRenderTarget, MeshBasicNodeMaterial, RenderTarget, WebGPURenderer } from 'three/webgpu';
import { ExactShadows } from 'edgeshade/three';
import { ExactShadows as NodeShadows } from 'edgeshade/three-webgpu';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { blobs, leafAtlas, treeOf } from './foliage.js';
import { comparedWithRays, normalOf } from './rays.js';
import { sampled } from './texel-alpha.js';
import { tintsComparedWithRays } from './tint-rays.js';

export const size = { width: 320, height: 240 };

/**
 * An initialised renderer with a canvas in the page. `backend`: 'WebGLRenderer', 'WebGL' or 'WebGPU', which
 * draws into a texture, as Chromium has no canvas for SwiftShader's WebGPU. Its light is linear: 8 bits were too few.
 */
export async function rendererOf(backend, { width, height } = size) {
  const renderer = backend === 'WebGLRenderer' ? new three.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true })
    : new WebGPURenderer({ antialias: false, forceWebGL: backend === 'WebGL' });
  renderer.setPixelRatio(1);
  renderer.setSize(width, height);
  renderer.setClearColor(0x000000, 1);
  await renderer.init?.();
  if (backend === 'WebGPU') renderer.setRenderTarget(new RenderTarget(width, height, { type: three.HalfFloatType }));
  document.body.append(renderer.domElement);
  return renderer;
}

/** White wherever it is lit, whatever its slope. */
export function white(settings = {}) {
  const gradientMap = new three.DataTexture(new Uint8Array(8).fill(255), 2, 1, three.RedFormat);
  gradientMap.needsUpdate = true;
  return new three.MeshToonMaterial({ color: 0xffffff, gradientMap, ...settings });
}

/** A light that shows such surfaces as white, and its target. */
export function lampOf(kind, position) {
  const light = kind === 'DirectionalLight' ? new three.DirectionalLight(0xffffff, Math.PI)
    : new three[kind](0xffffff, Math.PI, 0, ...(kind === 'SpotLight' ? [0.5, 0, 0] : [0]));
  light.position.set(...position);
  light.castShadow = true;
  return light.target ? [light, light.target] : [light];
}

export function cameraOf({ from, to, fov = 45 }, { width, height } = size) {
  const camera = new three.PerspectiveCamera(fov, width / height, 0.1, 200);
  camera.position.set(...from);
  camera.lookAt(...to);
  return camera;
}

/** A mesh that casts and receives, at a place. */
export function meshOf(geometry, material, place = [0, 0, 0]) {
  const mesh = new three.Mesh(geometry, material);
  mesh.position.set(...place);
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

/** A mesh that casts alone: no program that looks up, which takes seconds to compile, is made for its material. */
export function casterOf(...of) {
  const mesh = meshOf(...of);
  mesh.receiveShadow = false;
  return mesh;
}

/** A ground, a box, a ball, a knot, and an open sheet, seen from both of its sides. */
export function yard(material = white(), doubleSided = white({ side: three.DoubleSide })) {
  const scene = new three.Scene();
  const sheet = meshOf(new three.PlaneGeometry(1.6, 1.2), doubleSided, [-1.8, 0.9, 0.9]);
  sheet.rotation.set(-0.9, 0.4, 0.2);
  const knot = meshOf(new three.TorusKnotGeometry(0.5, 0.16, 64, 8), material, [1.6, 1.1, 0.9]);
  const box = meshOf(new three.BoxGeometry(1, 1, 1), material, [0.2, 0.8, -0.4]);
  box.rotation.y = 0.4;
  scene.add(meshOf(new three.BoxGeometry(8, 0.2, 8), material, [0, -0.1, 0]), box, knot,
    meshOf(new three.SphereGeometry(0.6, 24, 12), material, [-1.2, 0.6, -1.2]), sheet);
  return { scene, box, knot, sheet };
}

export const yardView = { from: [4.5, 4, 6], to: [0, 0.5, 0] };

/** The sample, white. */
export async function pavilion() {
  const draco = new DRACOLoader().setDecoderPath(import.meta.resolve('three/addons/libs/draco/gltf/'));
  const { scene } = await new GLTFLoader().setDRACOLoader(draco).loadAsync('/assets/pavilion.glb');
  draco.dispose();
  scene.traverse((mesh) => {
    if (!mesh.isMesh) return;
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.material = white({ side: mesh.material.side });
  });
  const all = new three.Scene();
  all.add(scene);
  return all;
}

/** 30 posts, instances of one mesh, on a ground. */
export function posts() {
  const scene = new three.Scene();
  const all = new three.InstancedMesh(new three.CylinderGeometry(0.12, 0.12, 1.2, 10), white(), 30);
  const place = new three.Matrix4();
  for (let i = 0; i < 30; ++i) all.setMatrixAt(i, place.makeRotationZ(0.05 * i).setPosition(-2.5 + (i % 6), 0.6, -2.4 + 1.2 * Math.floor(i / 6)));
  all.castShadow = all.receiveShadow = true;
  scene.add(all, meshOf(new three.BoxGeometry(8, 0.2, 8), all.material, [0, -0.1, 0]));
  return scene;
}

/** Grey panes, invisible to the eye, above one another and a ground, and a box among them. */
export function panes() {
  const scene = new three.Scene();
  const glass = (grey, opacity) => new three.MeshLambertMaterial({ color: new three.Color().setRGB(grey, grey, grey, three.LinearSRGBColorSpace),
    opacity, transparent: true, colorWrite: false, depthWrite: false, side: three.DoubleSide });
  const upper = casterOf(new three.PlaneGeometry(3, 2, 4, 4), glass(0.9, 0.3), [0.3, 1.9, 0.2]), thick = casterOf(new three.BoxGeometry(2, 0.2, 2), glass(0.8, 0.5), [-0.6, 0.9, 0.5]);
  upper.rotation.set(-1.4, 0.2, 0.1);
  thick.rotation.set(0.1, 0.3, 0);
  scene.add(meshOf(new three.BoxGeometry(8, 0.2, 8), white(), [0, -0.1, 0]), upper, thick, meshOf(new three.BoxGeometry(0.5, 0.5, 0.5), white(), [0.6, 1.4, 0.2]));
  return scene;
}

/** A tree of leaves on cards, two of them instances, above a ground and a box. */
export function leaves() {
  const scene = new three.Scene();
  scene.add(meshOf(new three.BoxGeometry(8, 0.2, 8), white(), [0, -0.1, 0]), meshOf(new three.BoxGeometry(0.6, 0.8, 0.6), white(), [-1.9, 0.41, 0.8]),
    treeOf(white({ map: leafAtlas(), alphaTest: 0.4, side: three.DoubleSide })));
  return scene;
}

/** Panes above sheets with holes: linear and mirrored, nearest and clamped, and without a texture; sheetOf() makes these. */
export function sheets(sheetOf = meshOf) {
  const scene = panes();
  const linear = alphas(11, 7), nearest = blobs(64, 48, { seed: 3 });
  Object.assign(linear, { wrapS: three.MirroredRepeatWrapping, wrapT: three.RepeatWrapping, rotation: 0.4 });
  linear.repeat.set(1.3, 0.8);
  linear.offset.set(0.2, -0.3);
  nearest.magFilter = nearest.minFilter = three.NearestFilter;
  nearest.wrapS = nearest.wrapT = three.ClampToEdgeWrapping;
  nearest.repeat.set(0.2, 0.15);
  const both = { side: three.DoubleSide, alphaTest: 0.45 };
  const added = (material, place) => {
    const sheet = sheetOf(new three.PlaneGeometry(1.6, 1.6), white({ ...both, ...material }), place);
    sheet.rotation.set(-1.3, 0.2, 0.3);
    scene.add(sheet);
  };
  added({ alphaMap: linear, opacity: 0.9 }, [1.4, 0.6, 1.2]);
  added({ map: nearest }, [-1.9, 0.8, -1]);
  added({ opacity: 0.3 }, [-2, 1.4, 1.9]); // nothing is left of it
  return scene;
}

/** Red, green and blue of noise, beside the alpha or the red and green of blobs(). */
function coloured(width, height, settings) {
  const texture = Object.assign(blobs(width, height), settings), { data } = texture.image;
  for (let i = 0; i < data.length; ++i) if (i % 4 < 3) data[i] = 60 + (i * 97 + (i >> 3) * 31) % 190;
  return texture;
}

/** blobs() in green, and in red, which WebGPURenderer takes of an alphaMap. */
function alphas(width, height, settings) {
  const texture = Object.assign(blobs(width, height, { green: true }), settings), { data } = texture.image;
  for (let i = 0; i < data.length; i += 4) data[i] = data[i + 1];
  return texture;
}

/**
 * The same, all of which cast alone, and panes, invisible to the eye, whose textures are of colour, alpha and transmission, and a sheet with
 * holes of two textures' alpha.
 */
export function stained() {
  const scene = sheets(casterOf), color = new three.Color().setRGB(1, 0.8, 0.6, three.LinearSRGBColorSpace);
  const added = (material, place, turned) => {
    const pane = casterOf(new three.PlaneGeometry(1.6, 1.4), material, place), { uv } = pane.geometry.attributes;
    pane.rotation.set(...turned);
    pane.geometry.setAttribute('uv1', uv.clone());
    for (const [i, at] of uv.array.entries()) pane.geometry.attributes.uv1.array[i] = 1 - 0.8 * at;
    scene.add(pane);
  };
  const unseen = { color, colorWrite: false, depthWrite: false, side: three.DoubleSide }, turnedMap = { wrapS: three.RepeatWrapping, rotation: 0.3 };
  added(new three.MeshLambertMaterial({ ...unseen, map: coloured(5, 4, turnedMap), alphaMap: alphas(3, 6, { channel: 1 }), transparent: true, opacity: 0.8 }), [-0.8, 1.2, -0.4], [-1.4, 0.1, 0.2]);
  added(new three.MeshPhysicalMaterial({ ...unseen, map: coloured(4, 4, turnedMap), transmissionMap: coloured(6, 5), transmission: 0.9 }), [0.9, 0.9, 0.3], [-1.6, 0.2, 0.1]);
  added(white({ map: blobs(7, 5), alphaMap: alphas(4, 6), alphaTest: 0.4, side: three.DoubleSide }), [-0.2, 0.7, 1.7], [-1.5, 0.1, 0]);
  return scene;
}

/** Light that a mesh of these lets through where a ray hits it, [red, green, blue]; null: it is solid. */
function throughStained({ material }, hit) {
  const { color, map, alphaMap, transmissionMap, opacity, transparent, transmission = 0, alphaTest } = material;
  if (!transparent && !(transmission > 0) && !(alphaTest > 0)) return null;
  if (!hit) return [1, 1, 1];
  const at = (texture, channel) => (texture ? sampled(texture, texture.channel === 1 ? hit.uv1 : hit.uv, channel) : 1);
  const alpha = opacity * at(map, 3) * at(alphaMap, 0);
  if (alphaTest > 0) return Array(3).fill(alpha < alphaTest ? 1 : 0);
  return ['r', 'g', 'b'].map((name, i) => color[name] * at(map, i) * (1 - (transparent ? alpha : 1) * (1 - transmission * at(transmissionMap, 0))));
}

/** The yard, and a pane that receives, and isn't one of the mask engine's meshes. */
export function softYard() {
  const material = white({ side: three.DoubleSide }), { scene } = yard(material, material); // fewer programs to compile
  const pane = meshOf(new three.PlaneGeometry(1.2, 1.2), white({ transparent: true, side: three.DoubleSide, forceSinglePass: true }), [-0.4, 0.5, 2]);
  pane.rotation.set(-1.5, 0, 0.3);
  pane.castShadow = false;
  scene.add(pane);
  return scene;
}

/** A house in a clipping group in another one, with a chest, on a floor that isn't cut: {scene, outer, inner, material}. */
export function house() {
  const scene = new three.Scene(), outer = new ClippingGroup(), inner = new ClippingGroup();
  const material = white({ side: three.DoubleSide });
  const boxOf = (size, place) => inner.add(meshOf(new three.BoxGeometry(...size), material, place));
  for (const side of [-1, 1]) {
    boxOf([0.2, 2, 4.4], [2.1 * side, 1.01, 0]);
    boxOf([4, 2, 0.2], [0, 1.01, 2.1 * side]);
  }
  boxOf([5, 0.2, 5], [0, 2.13, 0]);
  boxOf([0.9, 0.7, 0.6], [-0.6, 0.37, -0.5]);
  scene.add(meshOf(new three.BoxGeometry(9, 0.2, 9), white(), [0, -0.1, 0]), outer.add(inner));
  return { scene, outer, inner, material };
}

/** The yard and its camera, `x` and `z` from the world's origin. */
export function farYard(x = 1e6, z = -1e6) {
  const { scene } = yard(), far = new three.Scene(), place = new three.Group();
  place.position.set(x, 0, z);
  const camera = cameraOf(yardView);
  camera.position.add(place.position);
  place.add(...scene.children);
  far.add(place);
  return { scene: far, camera, place, options: { highPrecision: true } };
}

/**
 * {scene, camera, options: of lookedUp(); place: of its lights, if not the scene; tintOf: of
 * tintsComparedWithRays()} by name.
 */
export async function sceneOf(name) {
  if (name === 'far yard') return farYard();
  if (name === 'soft yard') return { scene: softYard(), camera: cameraOf(yardView), options: { lightSamples: 8, radius: 0.15, at: { width: 120, height: 90 } } };
  if (name === 'leaves') return { scene: leaves(), camera: cameraOf(yardView) };
  if (name === 'sheets') return { scene: sheets(), camera: cameraOf(yardView), options: { transparentCast: 'tint', at: { width: 160, height: 120 } } };
  if (name === 'stained') return { scene: stained(), camera: cameraOf(yardView), options: { transparentCast: 'tint', at: { width: 120, height: 90 } }, tintOf: throughStained };
  if (name === 'panes') return { scene: panes(), camera: cameraOf(yardView), options: { transparentCast: 'tint' } };
  if (name === 'pavilion') return { scene: await pavilion(), camera: cameraOf({ from: [-2.6, 3.6, 10.2], to: [0.2, 1.3, -0.2] }) };
  return { scene: name === 'instances' ? posts() : yard().scene, camera: cameraOf(yardView) };
}

/** Waits until a renderer counts another frame: within one, three.js draws its own maps once for a camera. */
export const nextFrame = () => new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); });

/** Draws until as many lights are looked up with all casters, for at most a minute. Returns their number. */
export async function rested(shadows, scene, camera, lights = 1) {
  shadows.render(scene, camera);
  await shadows.ready();
  shadows.render(scene, camera);
  const isWhole = () => shadows.cost.lookedUp === lights && !shadows.needsUpdate && !shadows.lights.some(({ method }) => method === 'lookup and movers');
  for (const since = Date.now(); !isWhole() && Date.now() - since < 60000;) {
    await new Promise((resolve) => { setTimeout(resolve, 200 * (window.haste ?? 1)); }); // otherwise drawing takes the time that building needs
    shadows.render(scene, camera);
  }
  return shadows.cost.lookedUp;
}

/** The red, green and blue bytes of what draw() draws, as on a canvas: three lists, one byte per pixel, rows from the top. */
export async function channelsOf(renderer, draw) {
  const { domElement, domElement: { width, height } } = renderer;
  const target = renderer.getRenderTarget(), channel = (rgba, k) => rgba.filter((_, i) => i % 4 === k);
  if (target) {
    draw();
    const halves = await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height), color = new three.Color();
    const shown = (half) => 255 * color.setScalar(Math.min(three.DataUtils.fromHalfFloat(half), 1)).convertLinearToSRGB().r + 0.5;
    return [0, 1, 2].map((k) => Uint8Array.from(channel(halves, k), shown));
  }
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  draw();
  context.drawImage(domElement, 0, 0); // in the task that drew it
  const { data } = context.getImageData(0, 0, width, height);
  return [0, 1, 2].map((k) => channel(data, k));
}

/** The first of these. */
export const redOf = async (renderer, draw) => (await channelsOf(renderer, draw))[0];

/** Shadows for a renderer, by its kind. */
export const shadowsOf = (renderer, options) => (renderer.isWebGLRenderer ? new ExactShadows(renderer, options) : new NodeShadows(renderer, options));

/** A picture of the size `at` with all lights looked up, `options` for their shadows: {lookedUp, channels: of channelsOf(), methods}. */
export async function lookedUp(backend, scene, camera, { lights = 1, radius = 0, at = size, highPrecision = false, ...options } = {}) {
  const renderer = await rendererOf(backend, at);
  renderer.highPrecision = highPrecision; // of a WebGPURenderer, for worlds far off
  const shadows = shadowsOf(renderer, { lookups: lights, ...options }).add(scene);
  scene.traverse((light) => { if (light.isLight) shadows.setRadius(light, radius); });
  const found = await rested(shadows, scene, camera, lights);
  const channels = await channelsOf(renderer, () => shadows.render(scene, camera));
  const methods = shadows.lights.map(({ method, reason }) => `${method}: ${reason}`);
  shadows.dispose();
  renderer.dispose();
  renderer.domElement.remove();
  return { lookedUp: found, channels, methods };
}

/** Whether a sun shines on what a ray from the camera meets at a place in the picture, in pixels. */
function shinesAt({ meshes, camera, light }, x, y) {
  const { width, height } = size, ray = new three.Raycaster();
  ray.setFromCamera(new three.Vector2(2 * x / width - 1, 1 - 2 * y / height), camera);
  const eye = ray.ray.direction.clone(), [hit] = ray.intersectObjects(meshes, false);
  if (!hit) return false;
  const normal = normalOf(hit);
  if (normal.dot(eye) > 0) normal.negate();
  const towards = light.position.clone().normalize();
  ray.near = 1e-5;
  ray.set(hit.point, towards);
  return normal.dot(towards) > 0 && ray.intersectObjects(meshes, false).length === 0;
}

/**
 * The pixels of `places` that are on no border of a sun's light by rays on the CPU: none through places 0.02
 * pixels from their middles finds another light.
 */
export function onNoBorder(scene, camera, places) {
  const meshes = [];
  let light = null;
  scene.traverse((object) => {
    if (object.isMesh) meshes.push(object);
    if (object.isDirectionalLight) light = object;
  });
  return places.filter((i) => {
    const x = i % size.width + 0.5, y = Math.floor(i / size.width) + 0.5;
    const found = [[0, 0], [-0.02, 0], [0.02, 0], [0, -0.02], [0, 0.02]].map(([u, v]) => shinesAt({ meshes, camera, light }, x + u, y + v));
    return found.every((shines) => shines === found[0]);
  });
}

/**
 * {differ: pixels whose light differs, beyond: those with no boundary of the first picture within a pixel,
 * places: their indices, shadow: dark ones, lit, grey} of two pictures, each of channelsOf().
 */
export function compared(a, b, { width } = size) {
  const around = [-1, 0, 1].flatMap((row) => [-1, 0, 1].map((column) => row * width + column));
  const places = [], [red] = a;
  let differ = 0, shadow = 0, lit = 0, grey = 0;
  for (let i = 0; i < red.length; ++i) {
    const differs = a.some((channel, k) => Math.abs(channel[i] - b[k][i]) > 2);
    differ += differs;
    if (differs && around.every((step) => red[i + step] === undefined || a.every((channel) => channel[i + step] === channel[i]))) places.push(i);
    shadow += red[i] < 20;
    lit += red[i] > 240;
    grey += red[i] >= 20 && red[i] <= 240;
  }
  return { differ, beyond: places.length, places, shadow, lit, grey };
}

/** Result of tintsComparedWithRays() for a picture of channelsOf(). */
export function comparedTints(channels, { width, height }, scene, camera, light, tintOf) {
  const rgba = new Uint8Array(4 * width * height);
  for (const [k, channel] of channels.entries())
    for (let i = 0; i < channel.length; ++i) rgba[4 * ((height - 1 - Math.floor(i / width)) * width + i % width) + k] = channel[i];
  return tintsComparedWithRays({ rgba, width, height }, scene, camera, light, tintOf);
}

export { ClippingGroup, comparedWithRays, CubeRenderTarget, float, MeshBasicNodeMaterial, NodeShadows, RenderTarget, three };
window.page = { ready: true };
