// Images of a scene: a missing one is left out with a sentence, and the browser decodes WebP.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drop, loaded, noticesOf, settled, smallElement, stateOf, useBrowser, waitForNotice } from './support/browser.mjs';
import { packed, rendered } from './support/native.mjs';
import { compare, picture } from './support/pictures.mjs';
import { dataUri } from './support/png.mjs';
import { texelsAsPng, texelsAsWebp, texturedGltf } from './support/scenes.mjs';

const shared = useBrowser();
const eye = { camera: { from: [5, 6, 8], to: [0, 0.8, 0], fov: 40 }, lights: [[0.5, 1, 0.3, 0]], ambient: 0.4 };

/** A page with only the element, whose picture has the size of the native one. */
const open = () => shared.open(smallElement);

/** Shows a scene from these bytes; returns its picture and the sentences about it. */
async function shown(page, bytes, name) {
  const warnings = await page.evaluate(async ([base64, file, changes]) => {
    const content = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const viewer = document.querySelector('edgeshade-viewer');
    const detail = await viewer.load([new File([content], file)]);
    viewer.change(changes);
    return detail.warnings;
  }, [bytes.toString('base64'), name, eye]);
  await settled(page);
  return { png: await picture(page), warnings };
}

const plain = () => texturedGltf({ uri: 'gone.png' });

test('images come along with a .gltf from an address', async () => {
  const page = await shared.open('/#model=tests/found/scene.gltf');
  assert.deepEqual(await noticesOf(page), []);
  assert.ok(shared.server.asked.includes('/tests/found/texture%20of%20it.png'));
  await shared.check(page);
});

test('an image that is not there is left out, and a sentence says so', async () => {
  const page = await shared.open('/#model=tests/gone/scene.gltf');
  await waitForNotice(page, /^'scene\.gltf': images\[0\]: 'gone\.png' was not found: the server answered 404; it is left out\.$/);
  assert.deepEqual(await noticesOf(page, 'error'), []);
  assert.match(await page.textContent('#scene-name'), /^scene\.gltf: 36 triangles/);
  await shared.check(page, [/404/]);
});

test('a WebP is drawn as the PNG of its pixels, and as natively', async () => {
  const page = await open();
  const without = await shown(page, plain(), 'plain.gltf');
  for (const material of [{}, { alphaMode: 'MASK', alphaCutoff: 0.25 }, { alphaMode: 'BLEND' }])
    for (const animated of [false, true]) {
      const what = `${material.alphaMode ?? 'OPAQUE'}${animated ? ', animated' : ''}`;
      const scene = texturedGltf({ uri: dataUri(texelsAsWebp) }, material, { animated });
      const webp = await shown(page, scene, 'webp.gltf');
      assert.deepEqual(webp.warnings, [], what);
      const png = await shown(page, texturedGltf({ uri: dataUri(texelsAsPng()) }, material, { animated }), 'png.gltf');
      assert.equal((await compare(page, webp.png, png.png)).different, 0, what);
      const { different, pixels, colors } = await compare(page, webp.png, without.png);
      assert.ok(different > 0.01 * pixels && colors > 50, `${what}: ${different} pixels, ${colors} colours`);
      if (animated || material.alphaMode === 'BLEND') continue; // blending rounds differently on
                                                                // each device
      const native = rendered(await stateOf(page), [], { scene });
      const { astray } = await compare(page, webp.png, native);
      // Where alpha decides, the filters of two rasterisers may disagree along texel edges.
      const most = material.alphaMode ? 0.002 * pixels : 20;
      assert.ok(astray <= most, `${what}: ${astray} pixels are not as natively`);
    }
  await shared.check(page);
});

test('casters with holes of a WebP throw the native shadows', async () => {
  const page = await open();
  const material = { alphaMode: 'MASK', alphaCutoff: 0.25 };
  const scene = packed(texturedGltf({ uri: dataUri(texelsAsWebp) }, material), ['--cast-masked']);
  const holes = await shown(page, scene, 'holes.glb');
  assert.deepEqual(holes.warnings, []);
  const native = rendered(await stateOf(page), [], { scene });
  const { astray, pixels: all } = await compare(page, holes.png, native);
  assert.ok(astray <= 0.002 * all, `${astray} pixels are not as natively`);
  const solid = packed(texturedGltf({ uri: dataUri(texelsAsWebp) }), ['--cast-masked']);
  const { different, pixels } = await compare(page, holes.png, (await shown(page, solid, 'solid.glb')).png);
  assert.ok(different > 0.01 * pixels, 'holes let light through');
  await shared.check(page);
});

test('a lost context gets its WebP back', async () => {
  const page = await open();
  const before = await shown(page, texturedGltf({ uri: dataUri(texelsAsWebp) }), 'webp.gltf');
  await page.evaluate(() => new Promise((resolve) => {
    const viewer = document.querySelector('edgeshade-viewer');
    const lose = viewer.shadowRoot.querySelector('canvas').getContext('webgl').getExtension('WEBGL_lose_context');
    viewer.addEventListener('contextlost', () => setTimeout(() => lose.restoreContext()), { once: true });
    viewer.addEventListener('contextrestored', resolve, { once: true });
    lose.loseContext();
  }));
  await settled(page);
  const { different, pixels } = await compare(page, before.png, await picture(page));
  assert.ok(different < 1e-4 * pixels, `${different} pixels differ`);
  await shared.check(page, [/CONTEXT_LOST_WEBGL/, /context lost/i]);
});

test('pictures that can\'t be decoded are left out, and the scene is shown without', async () => {
  const page = await open();
  const without = await shown(page, plain(), 'plain.gltf');
  assert.match(without.warnings[0], /^'plain\.gltf': images\[0\]\.uri: 'gone\.png' does not exist; it is left out\.$/);
  const ktx2 = Buffer.from('\xabKTX 20\xbb\r\n\x1a\n\0\0\0\0', 'latin1');
  for (const [bytes, pattern] of [
    [ktx2, /^'bad\.gltf': images\[0\] is KTX2.*'gltf-transform ktxdecompress IN\.glb OUT\.glb'.*left out\.$/],
    [texelsAsWebp.subarray(0, 40), /^'bad\.gltf': images\[0\]: this browser can't decode its WebP data; it is left out\.$/],
    [texelsAsPng().subarray(0, 60), /^'bad\.gltf': images\[0\] can't be decoded/],
    [Buffer.from('GIF89a'), /^'bad\.gltf': images\[0\] is neither PNG, JPEG nor WebP; it is left out\.$/],
  ]) {
    const { png, warnings } = await shown(page, texturedGltf({ uri: dataUri(bytes) }), 'bad.gltf');
    assert.equal(warnings.length, 1);
    assert.match(warnings[0], pattern);
    assert.equal((await compare(page, png, without.png)).different, 0);
  }
  await shared.check(page);
});
