// Leaves: holes in a texture (alphaTest) are holes in the shadow, texel for texel.
import * as THREE from 'three';
import { block, matt, post, stage, sunFrom } from 'stage';

const { scene } = stage({ eye: [2.6, 3, 5.4], look: [0.3, 1.2, 0] });

/** A texture with alpha: leaves on twigs. */
function twigs(size = 256) {
  const canvas = Object.assign(document.createElement('canvas'), { width: size, height: size });
  const pen = canvas.getContext('2d');
  pen.strokeStyle = '#6b4a2b';
  pen.lineWidth = size / 64;
  for (let i = 0; i < 26; ++i) {
    const [x, y, turn] = [size * ((i * 0.618) % 1), size * ((i * 0.377) % 1), i * 2.4];
    pen.fillStyle = `hsl(${85 + (i * 17) % 40} 45% ${32 + (i * 7) % 18}%)`;
    pen.beginPath();
    pen.ellipse(x, y, size / 9, size / 22, turn, 0, 2 * Math.PI);
    pen.fill();
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x + size / 7 * Math.cos(turn), y + size / 7 * Math.sin(turn));
    pen.stroke();
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

const leaf = new THREE.MeshStandardMaterial({ map: twigs(), alphaTest: 0.5, side: THREE.DoubleSide, roughness: 0.9 });
const turned = new THREE.Euler();
for (let i = 0; i < 22; ++i) {
  const card = new THREE.Mesh(new THREE.PlaneGeometry(1.1, 1.1), leaf);
  turned.set(i * 1.3, i * 2.1, i * 0.7);
  card.position.set(0, 0.55, 0).applyEuler(turned).add(new THREE.Vector3(0, 1.9, 0));
  card.rotation.copy(turned);
  card.castShadow = card.receiveShadow = true;
  scene.add(card);
}
scene.add(post(0.07, 1.9, [0, 0, 0], matt(0x76573a)), block([12, 0.2, 12], [0, -0.2, 0], matt(0xd8d0bf)));
scene.add(sunFrom(-2.2, 4, 1.6));
