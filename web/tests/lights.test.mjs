// Lights in the element's attributes, in the address, and in the panel's texts.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { changesFromAttributes } from '../element/attributes.js';
import { aimed, isSun, kindOf, placeOf } from '../element/lights.js';
import { hashOf, readHash } from '../page/url-state.js';

const lightsOf = (attributes) => changesFromAttributes((name) => attributes[name] ?? null).lights;

test('attributes without colours are arrays', () => {
  assert.deepEqual(lightsOf({ light: '1,2,3; 4,5,6,7', sun: '0,1,0' }),
    [[0, 1, 0, 0], [1, 2, 3, 1], [4, 5, 6, 1, 7]]);
});

test('attributes may have colours and intensities', () => {
  const [sun, lamp] = lightsOf({ light: '1,2,3,9:#ff8000:12.5', sun: '0,1,0:#ffffff' });
  assert.deepEqual(sun, { direction: [0, 1, 0], color: [1, 1, 1] });
  assert.deepEqual(lamp.position, [1, 2, 3]);
  assert.equal(lamp.range, 9);
  assert.equal(lamp.intensity, 12.5);
  assert.ok(Math.abs(lamp.color[1] - 0.21586) < 1e-4, 'made linear');
});

test('attributes of wrong colours and intensities are refused', () => {
  for (const light of ['1,2,3:red', '1,2,3:', '1,2,3:#ffff', '1,2,3:#ffffff:', '1,2,3:#ffffff:x'])
    assert.throws(() => lightsOf({ light }), /The attribute light/, light);
});

const state = {
  camera: { from: [1, 2, 3], to: [0, 0, 0], fov: 45 },
  lights: [
    [1.5, 2.25, 2, 1, 6.5],
    { position: [1, 2, 3], color: [1, 0.5, 0], intensity: 8, cone: { axis: [0, -1, 0], inner: 10, outer: 30 } },
  ],
  chosen_light: 0,
  ambient: 0.3,
  ground: 'off',
  left: { shadows: 'auto', mask_scale: 1 },
  split: false,
  debug: 'none',
  show_lights: true,
  playing: false,
  speed: 1,
  time: 0,
};

test('the address keeps lights by names', () => {
  const { changes, problems } = readHash(hashOf(null, state));
  assert.deepEqual(problems, []);
  assert.deepEqual(changes.lights, state.lights);
});

test('an address with a light that is no JSON says so', () => {
  const { changes, problems } = readHash('#light={position');
  assert.equal(changes.lights, undefined);
  assert.match(problems[0], /'light' is '\{position', which is not JSON/);
});

test('the panel knows both forms', () => {
  const sun = { direction: [0, 1, 0], intensity: 3 };
  assert.deepEqual([...state.lights, sun, [0, 1, 0, 0]].map(kindOf), ['point light', 'spot', 'sun', 'sun']);
  assert.ok(isSun(sun) && !isSun(state.lights[1]));
  assert.deepEqual(placeOf(state.lights[0]), [1.5, 2.25, 2]);
  assert.deepEqual(placeOf(sun), [0, 1, 0]);
  assert.deepEqual(aimed(sun, [1, 0, 0]), { direction: [1, 0, 0], intensity: 3 });
  assert.deepEqual(aimed([0, 1, 0, 0], [1, 0, 0]), [1, 0, 0, 0]);
});
