// Globals that the README's lines for three.js need: a ground, a box above it and a sun. The meshes
// are so large that a worker finds their edges.

import * as three from 'three';

const renderer = new three.WebGLRenderer({ preserveDrawingBuffer: true });
renderer.setSize(160, 120);
document.body.append(renderer.domElement);
const scene = new three.Scene();
const mesh = (size, y) => {
  const made = new three.Mesh(new three.BoxGeometry(...size, 10, 10, 10), new three.MeshStandardMaterial());
  made.position.y = y;
  return made;
};
const sun = new three.DirectionalLight(0xffffff, 3);
sun.position.set(0.5, 1, -0.3);
scene.add(mesh([8, 0.2, 8], -0.1), mesh([1, 1, 1], 0.8), sun, sun.target);
const camera = new three.PerspectiveCamera(50, 4 / 3, 0.1, 50);
camera.position.set(0, 7, 0.01);
camera.lookAt(0, 0, 0);
camera.updateMatrixWorld();

/** Red at two points of the ground: one in shadow, one in light. */
function shadowAndLight() {
  const gl = renderer.getContext();
  return [[-0.75, 0, 0.45], [1.5, 0, 1]].map((point) => {
    const at = new three.Vector3(...point).project(camera);
    const pixel = new Uint8Array(4);
    gl.readPixels(80 + 80 * at.x, 60 + 60 * at.y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return pixel[0];
  });
}

Object.assign(window, { renderer, scene, camera, sun, shadowAndLight });
