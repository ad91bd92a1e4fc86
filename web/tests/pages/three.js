// Tools for tests of the three.js adapter in a page: scenes, and pictures as bytes.

import * as three from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { ExactShadows, ExactShadowsPass } from 'edgeshade/three';
import { glbAsPosed, walkingFigure } from './figure.js';
import { comparedWithRays } from './rays.js';
import * as views from './views.js';

/** A renderer with its own canvas in the page. */
function rendererOf({ width = 480, height = 270, antialias = false, pixelRatio = 1, clear = 0x000000, ...others } = {}) {
  const renderer = new three.WebGLRenderer({ antialias, preserveDrawingBuffer: true, ...others });
  renderer.setPixelRatio(pixelRatio);
  renderer.setSize(width, height);
  renderer.setClearColor(clear, 1);
  renderer.shadowMap.enabled = false;
  if ('useLegacyLights' in renderer) renderer.useLegacyLights = false; // lights as bright as in later releases
  document.body.append(renderer.domElement);
  return renderer;
}

async function loaded(address) {
  const decoder = import.meta.resolve('three/addons/libs/draco/gltf/');
  const draco = new DRACOLoader().setDecoderPath(decoder);
  const { scene } = await new GLTFLoader().setDRACOLoader(draco).loadAsync(address);
  draco.dispose();
  scene.traverse((object) => {
    if (object.isMesh) object.castShadow = object.receiveShadow = true;
  });
  return scene;
}

/** Makes every mesh white, so that it shows only light and shadow, whatever its slope. */
function whiten(scene) {
  const made = new Map();
  scene.traverse((object) => {
    if (!object.isMesh) return;
    const { side, alphaTest, alphaMap, map, opacity, transparent } = object.material;
    const key = alphaTest > 0 || transparent ? object.material : side;
    if (!made.has(key)) {
      const material = new three.MeshToonMaterial({ color: 0xffffff, side });
      if (key === object.material) Object.assign(material, { alphaTest, alphaMap, map, opacity, transparent });
      material.gradientMap = new three.DataTexture(new Uint8Array([255, 255, 255, 255, 255, 255, 255, 255]), 2, 1);
      material.gradientMap.needsUpdate = true;
      made.set(key, material);
    }
    object.material = made.get(key);
  });
}

function cameraOf({ from, to, fov }, aspect) {
  const camera = new three.PerspectiveCamera(fov, aspect, 0.1, 200);
  camera.position.set(...from);
  camera.lookAt(...to);
  return camera;
}

/** A light that shows white surfaces as white, wherever they are, and its target. */
function lampOf({ kind, position }) {
  const light = kind === 'DirectionalLight' ? new three.DirectionalLight(0xffffff, Math.PI)
    : new three[kind](0xffffff, Math.PI, 0, ...(kind === 'SpotLight' ? [0.5, 0, 0] : [0]));
  light.position.set(...position);
  light.castShadow = true;
  return light.target ? [light, light.target] : [light];
}

/** Draws until all shadows are ready. */
async function drawn(shadows, scene, camera) {
  shadows.render(scene, camera);
  await shadows.ready();
  shadows.render(scene, camera);
}

const frame = () => new Promise((resolve) => { requestAnimationFrame(resolve); });

/**
 * Draws frames until this many lights are looked up, for at most a minute; returns their
 * number.
 */
async function rested(shadows, scene, camera, lights = 1) {
  await drawn(shadows, scene, camera);
  for (const since = Date.now(); shadows.cost.lookedUp !== lights && Date.now() - since < 60000;) {
    // Otherwise drawing takes the time that building needs.
    await new Promise((resolve) => { setTimeout(resolve, 150 * (window.haste ?? 1)); });
    shadows.render(scene, camera);
  }
  return shadows.cost.lookedUp;
}

/** A channel's bytes of the canvas, red unless told, one per pixel, rows from the top. */
function channelOf(renderer, channel = 0) {
  const gl = renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const rgba = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  const bytes = [];
  for (let y = height - 1; y >= 0; --y) for (let x = 0; x < width; ++x) bytes.push(rgba[4 * (y * width + x) + channel]);
  return bytes;
}

const redOf = (renderer) => channelOf(renderer);

/** Bytes as text, which leaves the page some fifty times as fast as a list of numbers. */
const base64Of = (bytes) => {
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text);
};

/** redOf() as text, for compareMasks(). */
const redTextOf = (renderer) => base64Of(Uint8Array.from(redOf(renderer)));

/** A ground, a box above it and a sun, for tests to change. */
function yard(size) {
  const renderer = rendererOf(size);
  const scene = new three.Scene();
  const material = new three.MeshStandardMaterial({ color: 0xffffff });
  const mesh = (geometry) => {
    const made = new three.Mesh(geometry, material);
    made.castShadow = made.receiveShadow = true;
    return made;
  };
  const ground = mesh(new three.BoxGeometry(8, 0.2, 8));
  ground.position.y = -0.1;
  const box = mesh(new three.BoxGeometry(1, 1, 1));
  box.position.set(0.3, 0.8, -0.2);
  const [light, target] = lampOf({ kind: 'DirectionalLight', position: [0.5, 1, -0.3] });
  scene.add(ground, box, light, target);
  return { three, renderer, scene, ground, box, light, material, mesh };
}

/**
 * 8 x 8 white texels, some without alpha or, if requested, without green; sampled with rotation and
 * offset.
 */
function pattern(inGreen = false) {
  const texels = new Uint8Array(4 * 64).fill(255);
  for (let i = 0; i < 64; ++i) if ((i % 8 + (i >> 3)) % 3 === 0) texels[4 * i + (inGreen ? 1 : 3)] = 0;
  const texture = new three.DataTexture(texels, 8, 8);
  texture.wrapS = texture.wrapT = three.RepeatWrapping;
  texture.repeat.set(2, 2); // equal in both directions, where glTF's rotation agrees with
                            // three.js's
  texture.offset.set(0.1, 0.2);
  texture.rotation = 0.3;
  texture.needsUpdate = true;
  return texture;
}

/** A sheet with holes between the eye and much of the yard. */
function fence({ mesh }, settings = {}) {
  const made = mesh(new three.PlaneGeometry(3.5, 2.5));
  made.position.set(1, 1.4, 1.8);
  made.rotation.set(-0.4, 0.6, 0);
  made.material = new three.MeshStandardMaterial({ alphaTest: 0.5, side: three.DoubleSide, ...settings });
  return made;
}

/** Replaces instanced meshes by meshes: GLTFExporter of r152 leaves instances out. */
function replaceInstances(scene) {
  const instanced = [];
  scene.traverse((object) => { if (object.isInstancedMesh) instanced.push(object); });
  for (const many of instanced) {
    for (let i = 0; i < many.count; ++i) {
      const one = new three.Mesh(many.geometry, many.material);
      one.matrixAutoUpdate = false;
      many.getMatrixAt(i, one.matrix);
      one.matrix.premultiply(many.matrix);
      many.parent.add(one);
    }
    many.removeFromParent();
  }
}

/**
 * Draws, changes the scene, and draws again; returns {red, glb}: redTextOf(), and three.js's export of
 * the visible scene.
 */
async function changedPicture(world, view, change) {
  const { renderer, scene } = world;
  const { width, height } = renderer.domElement;
  const camera = cameraOf(view, width / height);
  const shadows = new ExactShadows(renderer).add(scene);
  whiten(scene);
  await drawn(shadows, scene, camera);
  const other = change(world, shadows);
  if (other) {
    other.position.copy(camera.position);
    other.quaternion.copy(camera.quaternion);
  }
  whiten(scene);
  await drawn(shadows, scene, other ?? camera);
  const red = redTextOf(renderer);
  scene.traverse((object) => { if (!object.layers.test(camera.layers)) object.visible = false; });
  if (three.REVISION === '152') replaceInstances(scene);
  const glb = await new GLTFExporter().parseAsync(scene, { binary: true, onlyVisible: true });
  return { red, glb: base64Of(new Uint8Array(glb)) };
}

/** A number that identifies values. */
const hash = (values) => values.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 7);

/** Red at the pixel that shows a point of the world. */
function redAt(renderer, camera, point) {
  const gl = renderer.getContext();
  const at = new three.Vector3(...point).project(camera);
  const pixel = new Uint8Array(4);
  const place = (share, size) => Math.floor((0.5 * share + 0.5) * size);
  gl.readPixels(place(at.x, gl.drawingBufferWidth), place(at.y, gl.drawingBufferHeight), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  return pixel[0];
}

const names = new WeakMap();
let nextName = 1;

/** Replaces objects by numbers, so that results can be compared outside the page. */
function plainOf(value) {
  if (value === null || typeof value !== 'object') return value;
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return [...value];
  if (!names.has(value)) names.set(value, nextName++);
  return names.get(value);
}

/** All state that getParameter() can read, by name, and the bindings of every texture unit. */
function stateOf(gl) {
  const state = {};
  const skipped = /^(MAX_|ALIASED_|COMPRESSED_|DEPTH_BITS|STENCIL_BITS|RED_BITS|GREEN_BITS|BLUE_BITS|ALPHA_BITS|SUBPIXEL|VENDOR|RENDERER$|VERSION|SHADING|SAMPLES$|SAMPLE_BUFFERS|IMPLEMENTATION)/;
  const tried = new Set();
  for (const name in gl) {
    const value = gl[name];
    if (typeof value !== 'number' || !/^[A-Z0-9_]+$/.test(name) || skipped.test(name) || tried.has(value) || value < 0x0B00) continue;
    tried.add(value);
    const told = gl.getParameter(value);
    if (gl.getError() === gl.NO_ERROR && told !== undefined) state[name] = plainOf(told);
  }
  const active = gl.getParameter(gl.ACTIVE_TEXTURE);
  for (let i = 0; i < gl.getParameter(gl.MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++i) {
    gl.activeTexture(gl.TEXTURE0 + i);
    for (const name of ['TEXTURE_BINDING_2D', 'TEXTURE_BINDING_CUBE_MAP', 'TEXTURE_BINDING_3D', 'SAMPLER_BINDING'])
      if (gl[name] !== undefined) state[`${name} ${i}`] = plainOf(gl.getParameter(gl[name]));
  }
  gl.activeTexture(active);
  return state;
}

/** The attributes of the bound vertex array, or of the context. */
function attributesOf(gl) {
  const state = {};
  for (let i = 0; i < gl.getParameter(gl.MAX_VERTEX_ATTRIBS); ++i)
    for (const name of ['ENABLED', 'SIZE', 'STRIDE', 'TYPE', 'NORMALIZED', 'BUFFER_BINDING'])
      state[`${i} ${name}`] = plainOf(gl.getVertexAttrib(i, gl[`VERTEX_ATTRIB_ARRAY_${name}`]));
  for (let i = 0; i < gl.getParameter(gl.MAX_VERTEX_ATTRIBS); ++i)
    state[`${i} offset`] = gl.getVertexAttribOffset(i, gl.VERTEX_ATTRIB_ARRAY_POINTER);
  return state;
}

/** Name of the device that WebGL draws with. */
function rendererName() {
  const gl = document.createElement('canvas').getContext('webgl2');
  return gl?.getParameter(gl.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER) ?? '';
}

window.page = { ...views, ExactShadowsPass, rendererName, hash, redAt, stateOf, attributesOf, three, ExactShadows, rendererOf, loaded, whiten, cameraOf, lampOf, drawn, rested, frame, channelOf, redOf, redTextOf, base64Of, yard, pattern, fence, changedPicture, comparedWithRays, glbAsPosed, walkingFigure };
