// Metal, emission, clear coats and textures in the browser, as in the native program.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { settled, smallElement, stateOf, useBrowser } from './support/browser.mjs';
import { rendered } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';
import { dataUri } from './support/png.mjs';
import { smallGltf, texelsAsPng, texturedGltf } from './support/scenes.mjs';

const shared = useBrowser();
const camera = { from: [5, 6, 8], to: [0, 0.8, 0], fov: 40 };
const sun = [0.5, 1, 0.3, 0];

const gloss = (metallicFactor, roughnessFactor) => ({ baseColorFactor: [0.8, 0.5, 0.3, 1], metallicFactor, roughnessFactor });
const coat = { KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatRoughnessFactor: 0.1 } };

/** A scene with a plastic ground, a metal pillar and a coated stone that glows. */
function sceneOfSorts() {
  const gltf = JSON.parse(smallGltf());
  delete gltf.animations;
  gltf.extensionsUsed = Object.keys(coat);
  gltf.materials = [
    { pbrMetallicRoughness: gloss(0, 0.4) },
    { pbrMetallicRoughness: gloss(0.9, 0.25) },
    { pbrMetallicRoughness: gloss(0, 0.6), emissiveFactor: [0.1, 0.3, 0.1], extensions: coat },
  ];
  return Buffer.from(JSON.stringify(gltf));
}

/** A texture whose texels serve as normals, metalness, roughness and emission. */
const textured = () => texturedGltf({ uri: dataUri(texelsAsPng()) }, {
  pbrMetallicRoughness: { metallicRoughnessTexture: { index: 0 } },
  normalTexture: { index: 0, scale: 0.5 },
  occlusionTexture: { index: 0 },
  emissiveTexture: { index: 0 },
  emissiveFactor: [0.2, 0.2, 0.2],
});

async function shown(page, bytes, changes) {
  await page.evaluate(async ([base64, state]) => {
    const content = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const viewer = document.querySelector('edgeshade-viewer');
    await viewer.load([new File([content], 'scene.gltf')]);
    viewer.change(state);
  }, [bytes.toString('base64'), { camera, ambient: 0.4, ...changes }]);
  await settled(page);
  return picture(page);
}

async function expectAsNatively(page, bytes, changes, options = []) {
  const { pixels, different, astray, colors } =
    await compare(page, await shown(page, bytes, changes), rendered(await stateOf(page), options, { scene: bytes }));
  assert.ok(different < 0.004 * pixels, `${different} of ${pixels} pixels differ`);
  assert.ok(astray < 40, `${astray} astray`);
  assert.ok(colors > 4, `${colors} colours`);
}

test('materials look as they do natively', async () => {
  const page = await shared.open(smallElement);
  await expectAsNatively(page, sceneOfSorts(), { lights: [sun] });
  await expectAsNatively(page, sceneOfSorts(), { lights: [sun], exposure: 1 }, ['--exposure', '1']);
  await expectAsNatively(page, sceneOfSorts(), { lights: [sun], shading: 'base' }, ['--shading', 'base']);
  await expectAsNatively(page, textured(), { lights: [sun], exposure: 0, shading: 'full' });
  await shared.check(page);
});

test('two lights are added up as they are natively', async () => {
  const page = await shared.open(smallElement);
  await expectAsNatively(page, sceneOfSorts(), { lights: [sun, [-3, 4, 2, 1]] });
  await shared.check(page);
});
