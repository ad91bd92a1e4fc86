// A forest: 350 trees are two instanced meshes, and each tree shades the others.
import * as THREE from 'three';
import { block, matt, solid, stage, sunFrom } from 'stage';

const { scene } = stage({ eye: [0, 15, 20], look: [0, 0.5, 1] });
const trees = 350;
const trunks = new THREE.InstancedMesh(new THREE.CylinderGeometry(0.08, 0.12, 1.2, 6), matt(0x7a5a3d), trees);
const crowns = new THREE.InstancedMesh(new THREE.ConeGeometry(0.6, 2.6, 7), matt(0x4f7a4a, { flatShading: true }), trees);

let seed = 7;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
const place = new THREE.Matrix4(), turn = new THREE.Quaternion(), up = new THREE.Vector3(0, 1, 0);
for (let i = 0; i < trees; ++i) {
  const [radius, angle, size] = [3 + 13 * Math.sqrt(random()), 2 * Math.PI * random(), 0.6 + 0.7 * random()];
  const [x, z] = [radius * Math.cos(angle), radius * Math.sin(angle)];
  turn.setFromAxisAngle(up, angle * 5);
  const scale = new THREE.Vector3(size, size, size);
  trunks.setMatrixAt(i, place.compose(new THREE.Vector3(x, 0.6 * size, z), turn, scale));
  crowns.setMatrixAt(i, place.compose(new THREE.Vector3(x, 2.2 * size, z), turn, scale));
  crowns.setColorAt(i, new THREE.Color().setHSL(0.27 + 0.06 * random(), 0.35, 0.35 + 0.15 * random()));
}
scene.add(solid(trunks), solid(crowns), block([50, 0.2, 50], [0, -0.2, 0], matt(0xa9b284)), sunFrom(-6, 4, -2));
