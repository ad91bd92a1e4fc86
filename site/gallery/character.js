// A figure with a skeleton: its shadow follows every frame's pose.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { block, matt, solid, stage, sunFrom } from 'stage';

const { scene, animate, draw } = stage({ eye: [2.6, 1.8, 3.4], look: [0, 0.8, 0] });
scene.add(sunFrom(-2.5, 3, 1.8));
for (let i = 0; i < 6; ++i)                                   // a fence behind it
  scene.add(block([0.08, 1.3, 0.08], [-1.5 + 0.6 * i, 0, -1], matt(0xb08a5b)));
scene.add(block([3.2, 0.08, 0.04], [0, 0.9, -0.94], matt(0xb08a5b)));
scene.add(block([12, 0.2, 12], [0, -0.22, 0], matt(0xc9c2b4)));

const { scene: figure, animations } = await new GLTFLoader().loadAsync('../models/walking-figure.glb');
scene.add(solid(figure));
const mixer = new THREE.AnimationMixer(figure);
mixer.clipAction(animations[0]).play();
animate((seconds) => mixer.setTime(seconds));
draw();
