// Six coloured spots: four of them rest and are looked up, two move and have masks.
import * as THREE from 'three';
import { block, matt, post, stage } from 'stage';

const { scene, animate } = stage({ eye: [0, 4.4, 8], look: [0, 0.8, 0], sky: 0x15171c, ambient: 0.15, options: { lookups: 4 } });
scene.add(block([16, 0.1, 12], [0, -0.1, 0], matt(0xbdbdbd)));
for (let i = 0; i < 9; ++i) {
  const angle = 2 * Math.PI * i / 9;
  scene.add(post(0.12, 1.6, [2.2 * Math.cos(angle), 0, 2.2 * Math.sin(angle)], matt(0xe8e8e8)));
}
scene.add(block([4.8, 0.15, 0.4], [0, 1.6, -2.2], matt(0xe8e8e8)), post(0.5, 0.4, [0, 0, 0], matt(0xe8e8e8)));

const colors = [0xff5544, 0x44aaff, 0x66dd77, 0xffcc33, 0xcc66ff, 0x55e0dd];
const spots = colors.map((color, i) => {
  const spot = new THREE.SpotLight(color, 50, 0, 0.5, 0.4);
  const angle = 2 * Math.PI * i / colors.length;
  spot.position.set(5 * Math.cos(angle), 4.5, 5 * Math.sin(angle));
  spot.castShadow = true;
  scene.add(spot, spot.target);
  return spot;
});
animate((seconds) => {
  for (const [i, spot] of spots.slice(4).entries())
    spot.target.position.set(1.6 * Math.sin(seconds + 3 * i), 0, 1.6 * Math.cos(0.7 * seconds + i));
});
