// Stained glass: each pane lets its own colour through, and panes behind each other multiply.
import * as THREE from 'three';
import { block, matt, stage, sunFrom } from 'stage';

const { scene, shadows } = stage({ eye: [1.8, 2.4, 5.2], look: [0, 1, 0.6], ambient: 0.5 });
shadows.transparentCast = 'tint';
const colors = [0xc8283c, 0x2456b8, 0xe8b020, 0x2a8f55, 0x7a3aa8];
const lead = matt(0x26241f), stone = matt(0xd9d0c2);

scene.add(block([14, 0.2, 14], [0, -0.2, 2], matt(0xded7ca)));
scene.add(block([0.6, 3, 0.3], [-1.55, 0, -0.6], stone), block([0.6, 3, 0.3], [1.55, 0, -0.6], stone));
scene.add(block([2.5, 0.4, 0.3], [0, 0, -0.6], stone), block([2.5, 0.4, 0.3], [0, 2.6, -0.6], stone));
for (let row = 0; row < 4; ++row)
  for (let column = 0; column < 5; ++column) {
    const pane = new THREE.Mesh(new THREE.PlaneGeometry(0.47, 0.52), new THREE.MeshStandardMaterial({
      color: colors[(2 * row + column * column) % 5], transparent: true, opacity: 0.4, side: THREE.DoubleSide }));
    pane.material.color.lerp(new THREE.Color(0xffffff), 0.15);
    pane.position.set(-1 + 0.5 * column, 0.68 + 0.55 * row, -0.6);
    pane.castShadow = true;
    scene.add(pane);
  }
for (let column = 0; column < 6; ++column) scene.add(block([0.03, 2.2, 0.05], [-1.25 + 0.5 * column, 0.4, -0.6], lead));
for (let row = 0; row < 5; ++row) scene.add(block([2.5, 0.03, 0.05], [0, 0.4 + 0.545 * row, -0.6], lead));
scene.add(block([0.5, 0.5, 0.5], [0.3, 0, 1], matt(0xffffff)), sunFrom(-1.6, 4, -5, 4));
