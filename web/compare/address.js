// Parameters of the address: ?model=…&camera=…&light=…, as on the viewer's page, or model=pavilion
// or room; left=pcf-1024 and right=…, layout=side, bias=…, normal-bias=…, antialias=off.

import { anglesOf } from '../page/sun.js';
import { readHash } from '../page/url-state.js';
import { mapSizes, methods } from './methods.js';

/** 'pcf-1024'. */
function sideOf(text, otherwise) {
  const [, name, size] = /^([a-z-]+?)(?:-(\d+))?$/.exec(text ?? '') ?? [];
  if (!methods[name]) return otherwise;
  return { name, mapSize: mapSizes.includes(Number(size)) ? Number(size) : otherwise.mapSize };
}

function viewOf({ camera, lights }) {
  const view = camera ? { camera } : {};
  if (!lights) return view;
  const [[x, y, z, w]] = lights;
  return { ...view, ...(w === 0 ? { light: 'sun', sun: anglesOf([x, y, z]) } : { light: 'lamp', lamp: [x, y, z] }) };
}

/**
 * Returns {model or null, view: as in samples.js, or part of it, layout, left, right, biases,
 * antialias, problems: sentences}.
 */
export function readAddress(query) {
  const words = new URLSearchParams(query);
  const { model, changes, problems } = readHash(query.replace('?', '#'));
  return {
    model: model?.url ?? null,
    view: viewOf(changes),
    problems,
    layout: words.get('layout') === 'side' ? 'side' : 'split',
    left: sideOf(words.get('left'), { name: 'exact', mapSize: 2048 }),
    right: sideOf(words.get('right'), { name: 'pcf', mapSize: 2048 }),
    biases: { bias: Number(words.get('bias')) || 0, normalBias: Number(words.get('normal-bias')) || 0 },
    antialias: words.get('antialias') !== 'off',
  };
}
