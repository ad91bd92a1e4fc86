// What the tests of the three.js adapter ask of a page: scenes, and pictures as bytes.

import * as three from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { ExactShadows } from 'edgeshade/three';

/** A renderer on a canvas of its own in the page. */
function rendererOf({ width = 480, height = 270, antialias = false, pixelRatio = 1, clear = 0x000000 } = {}) {
  const renderer = new three.WebGLRenderer({ antialias, preserveDrawingBuffer: true });
  renderer.setPixelRatio(pixelRatio);
  renderer.setSize(width, height);
  renderer.setClearColor(clear, 1);
  renderer.shadowMap.enabled = false;
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

/** Every mesh of white that only light and shadow show: what reaches it, whatever its slope. */
function whiten(scene) {
  const made = new Map();
  scene.traverse((object) => {
    if (!object.isMesh) return;
    const { side } = object.material;
    if (!made.has(side)) {
      const material = new three.MeshToonMaterial({ color: 0xffffff, side });
      material.gradientMap = new three.DataTexture(new Uint8Array([255, 255, 255, 255, 255, 255, 255, 255]), 2, 1);
      material.gradientMap.needsUpdate = true;
      made.set(side, material);
    }
    object.material = made.get(side);
  });
}

function cameraOf({ from, to, fov }, aspect) {
  const camera = new three.PerspectiveCamera(fov, aspect, 0.1, 200);
  camera.position.set(...from);
  camera.lookAt(...to);
  return camera;
}

/** Draws until all shadows are there. */
async function drawn(shadows, scene, camera) {
  shadows.render(scene, camera);
  await shadows.ready();
  shadows.render(scene, camera);
}

/** The canvas' rows from the top, one byte a pixel: its red. */
function redOf(renderer) {
  const gl = renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const rgba = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  const red = [];
  for (let y = height - 1; y >= 0; --y) for (let x = 0; x < width; ++x) red.push(rgba[4 * (y * width + x)]);
  return red;
}

window.page = { three, ExactShadows, rendererOf, loaded, whiten, cameraOf, drawn, redOf };
