// A street in the evening: long shadows of houses, balconies and lamp posts.
import { block, matt, post, stage, sunFrom } from 'stage';

const { scene } = stage({ eye: [3.5, 5.2, 17], look: [0, 2, 0], sky: 0xf2d9bd, ambient: 0.8 });
const plaster = [0xd8b48a, 0xc98f78, 0xb7b9a5, 0xe3d3b1, 0x9fb0ba].map((color) => matt(color));
const glass = matt(0x4b5a66, { roughness: 0.3 }), iron = matt(0x2f3236);

scene.add(block([60, 0.2, 60], [0, -0.2, 0], matt(0x8d8a84)));
for (const side of [-1, 1]) {
  scene.add(block([2, 0.12, 50], [side * 4, 0, 0], matt(0xb5b0a6)));            // pavement
  for (let i = 0; i < 6; ++i) {
    const z = 12 - 5 * i, floors = 2 + ((i * 7 + (side > 0 ? 3 : 0)) % 3), x = side * 7;
    scene.add(block([4, 1 + 2 * floors, 4.8], [x, 0, z], plaster[(i + (side > 0 ? 2 : 0)) % 5]));
    for (let floor = 0; floor < floors; ++floor)
      for (const along of [-1.2, 1.2]) {
        scene.add(block([0.1, 1.2, 0.9], [x - side * 1.98, 1 + 2 * floor, z + along], glass));
        if (floor) scene.add(block([0.7, 0.08, 1.4], [x - side * 2.3, 0.9 + 2 * floor, z + along], iron),
          block([0.04, 0.5, 1.4], [x - side * 2.62, 0.98 + 2 * floor, z + along], iron));
      }
  }
  for (let i = 0; i < 4; ++i) {
    const z = 10 - 7 * i;
    scene.add(post(0.05, 4, [side * 3.2, 0, z], iron), block([0.9, 0.06, 0.12], [side * 2.8, 4, z], iron));
  }
}
for (const [x, z, color] of [[-1.6, 6, 0xb03a2e], [1.6, 1, 0x2e5f8a], [-1.6, -7, 0xe0b83c]])
  scene.add(block([1.7, 0.6, 3.6], [x, 0.3, z], matt(color)), block([1.5, 0.5, 1.8], [x, 0.9, z], glass),
    ...[-1.1, 1.1].map((along) => block([1.6, 0.5, 0.5], [x, 0, z + along], iron)));
scene.add(sunFrom(3.4, 3.6, 9, 3.5));
