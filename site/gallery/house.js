// A house cut open: planes that clip the house cut its shadow too (clipShadows), so the sun shines in.
import * as THREE from 'three';
import { block, matt, stage, sunFrom } from 'stage';

const { scene, renderer, draw } = stage({ eye: [6, 7.5, 8], look: [0, 0.8, 0] });
renderer.localClippingEnabled = true;
const cut = new THREE.Plane(new THREE.Vector3(0, -1, 0), 1.9);  // keeps what lies below
const cutOpen = { clippingPlanes: [cut], clipShadows: true, side: THREE.DoubleSide };
const wall = matt(0xe9e1d4, cutOpen), roof = matt(0xb0553a, cutOpen), wood = matt(0x8d5f3a, cutOpen);
const put = (size, place, material) => scene.add(block(size, place, material));

put([6, 0.1, 4.5], [0, 0, 0], matt(0xc9a77e));                   // floor
for (const z of [-2.15, 2.15]) {                                 // long walls, each with two windows
  put([6, 0.9, 0.2], [0, 0.1, z], wall);
  put([6, 0.5, 0.2], [0, 2.2, z], wall);
  for (const [x, width] of [[-2.6, 0.8], [0, 1.6], [2.6, 0.8]]) put([width, 1.2, 0.2], [x, 1, z], wall);
}
for (const x of [-2.9, 2.9]) put([0.2, 2.6, 4.1], [x, 0.1, 0], wall);
put([0.15, 2.6, 2.6], [0.2, 0.1, -0.75], wall);                  // a wall between two rooms
put([1.4, 0.45, 2], [-1.9, 0.1, -1], wood);                      // bed, table, bench
put([1.3, 0.06, 0.8], [1.6, 0.75, -0.6], wood);
for (const x of [1.05, 2.15]) put([0.07, 0.65, 0.7], [x, 0.1, -0.6], wood);
put([1.6, 0.4, 0.4], [-1.4, 0.1, 1.5], wood);
for (const [side, turn] of [[-1, 0.5], [1, -0.5]]) {             // roof
  const half = block([6.6, 0.12, 2.9], [0, 3.2, side * 1.25], roof);
  half.rotation.x = -turn;
  scene.add(half);
}
scene.add(block([40, 0.2, 40], [0, -0.2, 0], matt(0x93a878)), sunFrom(-4, 5, 3));

const height = document.createElement('input');
Object.assign(height, { type: 'range', min: 0.5, max: 4.4, step: 0.05, value: 1.9, ariaLabel: 'Height of the cut' });
height.addEventListener('input', () => { cut.constant = Number(height.value); draw(); });
document.body.append(height);
