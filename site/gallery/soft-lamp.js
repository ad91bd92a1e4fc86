// A lamp with a radius: shadows are sharp where things touch, and soften with distance.
import * as THREE from 'three';
import { block, matt, post, stage } from 'stage';

const { scene, shadows, draw } = stage({ eye: [1.7, 1.6, 2.6], look: [0, 0.35, 0], sky: 0x2b2724, ambient: 0.35,
  options: { lightSamples: 24 } });
scene.add(block([6, 0.1, 6], [0, -0.1, 0], matt(0xcabfae)), block([6, 2.5, 0.1], [0, 0, -1.4], matt(0xb9b2a6)));
for (let i = 0; i < 5; ++i) scene.add(post(0.05, 0.25 + 0.14 * i, [-0.8 + 0.4 * i, 0, 0.1 * (i % 2)], matt(0x4f7f8f)));
scene.add(block([0.4, 0.06, 0.4], [0.5, 0.35, 0.55], matt(0xb5683c)), post(0.02, 0.35, [0.5, 0, 0.55], matt(0xb5683c)));

const lamp = new THREE.PointLight(0xffd9a8, 14);
lamp.position.set(-0.9, 1.5, 1);
lamp.castShadow = true;
const bulb = new THREE.Mesh(new THREE.SphereGeometry(1, 24, 16), new THREE.MeshBasicMaterial({ color: 0xffe7c4 }));
lamp.add(bulb);
scene.add(lamp);

const radius = document.createElement('input');
Object.assign(radius, { type: 'range', min: 0, max: 0.25, step: 0.01, value: 0.1, ariaLabel: "The lamp's radius" });
const change = () => {
  shadows.setRadius(lamp, Number(radius.value));
  bulb.scale.setScalar(Math.max(0.02, Number(radius.value)));
  draw();
};
radius.addEventListener('input', change);
document.body.append(radius);
change();
