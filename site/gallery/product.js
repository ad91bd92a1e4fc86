// A chair on a turntable: the slats' shadows begin at the slats.
import * as THREE from 'three';
import { block, matt, post, solid, stage, sunFrom } from 'stage';

const { scene, animate } = stage({ eye: [1.6, 1.2, 2.2], look: [0, 0.55, 0], sky: 0xe8e2da });
const oak = matt(0xc08a55), steel = matt(0x4a4d52, { metalness: 0.6, roughness: 0.4 });

const chair = new THREE.Group();
for (let i = 0; i < 7; ++i) chair.add(block([0.055, 0.02, 0.46], [-0.24 + 0.08 * i, 0.45, 0], oak));
for (let i = 0; i < 5; ++i) chair.add(block([0.5, 0.05, 0.02], [0, 0.58 + 0.09 * i, -0.23], oak));
for (const x of [-0.25, 0.25])
  chair.add(post(0.014, 1.0, [x, 0.02, -0.25], steel), post(0.014, 0.66, [x, 0.02, 0.23], steel),
    block([0.05, 0.03, 0.5], [x, 0.66, -0.01], oak));
const table = post(0.62, 0.02, [0, 0, 0], matt(0xf3efe8));
chair.add(table);
scene.add(solid(chair), block([30, 0.2, 30], [0, -0.2, 0], matt(0xd9d2c7)));

scene.add(sunFrom(-2.2, 3, 2.4));
animate((seconds) => { chair.rotation.y = seconds / 4; });
