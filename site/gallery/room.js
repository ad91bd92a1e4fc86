// A room in the morning: bars of a window on the floor, the wall and a table.
import * as THREE from 'three';
import { block, matt, post, stage, sunFrom } from 'stage';

const { scene } = stage({ eye: [2.6, 2.1, 3.6], look: [-0.3, 0.9, -0.4], ambient: 0.7 });
const wall = matt(0xece6dc), wood = matt(0x9c6b43), frame = matt(0xffffff);

scene.add(block([5, 0.1, 5], [0, -0.1, 0], matt(0xb98d62)));            // floor
scene.add(block([5, 2.7, 0.2], [0, 0, -2.6], wall));                    // back wall
scene.add(block([0.2, 0.8, 5], [-2.6, 0, 0], wall), block([0.2, 0.4, 5], [-2.6, 2.3, 0], wall));
scene.add(block([0.2, 1.5, 1.2], [-2.6, 0.8, -1.9], wall), block([0.2, 1.5, 1.2], [-2.6, 0.8, 1.9], wall));
for (let i = 0; i < 5; ++i)                                             // the window's bars
  scene.add(block([0.05, 1.5, 0.04], [-2.55, 0.8, -1.3 + 0.65 * i], frame));
for (let i = 0; i < 4; ++i) scene.add(block([0.05, 0.04, 2.6], [-2.55, 0.8 + 0.49 * i, 0], frame));

scene.add(block([1.5, 0.06, 0.9], [-0.3, 0.7, -0.6], wood));            // a table
for (const x of [-0.95, 0.35]) for (const z of [-0.95, -0.25]) scene.add(block([0.06, 0.7, 0.06], [x, 0, z], wood));
scene.add(post(0.09, 0.22, [-0.5, 0.76, -0.6], matt(0x3f7d8c)), post(0.05, 0.12, [0, 0.76, -0.45], matt(0xd65f3c)));
const knot = new THREE.Mesh(new THREE.TorusKnotGeometry(0.22, 0.07, 96, 16), matt(0xb8863b));
knot.position.set(1.1, 0.42, -1.2);
knot.castShadow = knot.receiveShadow = true;
scene.add(knot, sunFrom(-6, 3.6, 1.4, 4));
