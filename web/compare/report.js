// Results as a table, and as a file.

import { sizeText } from '../element/files.js';

const milliseconds = (value) => value.toFixed(value < 10 ? 2 : 1);
const none = '–';

const spread = (times, more = '') => (times ? [milliseconds(times.median), `${milliseconds(times.least)}–${milliseconds(times.most)}${more}`] : [none]);
const times = (ratio) => (ratio === null ? none : `${ratio.toFixed(2)} ×`);
const percent = (value) => (value === null ? none : `${value.toFixed(value < 0.1 && value > 0 ? 3 : 2)} %`);

/** Columns: a heading, and a result's cell, which is a text or [text, smaller text]. */
const columnsOf = ({ gpu_timer: gpuTimer }) => {
  const motion = (title, key) => [
    { title: `Light ${title}, ms`, cell: ({ [key]: { frame_ms: frame, cost } }) => spread(frame, cost?.lookedUp ? ', looked up' : '') },
    ...(gpuTimer ? [{ title: 'of it GPU', cell: (result) => spread(result[key].gpu_ms)[0] }] : []),
    { title: "of it the page's thread", cell: (result) => spread(result[key].cpu_ms)[0] },
    { title: 'to exact', cell: (result) => times(result[key].ratio_to_exact) },
  ];
  return [
    ...motion('moves', 'light_moves'),
    ...motion('rests', 'light_rests'),
    { title: 'On the GPU', cell: ({ bytes_gpu: bytes }) => (bytes ? sizeText(bytes) : none) },
    { title: 'Wrong pixels', cell: ({ wrong_percent: wrong }) => percent(wrong) },
    { title: 'beyond 1 px', cell: ({ wrong_beyond_1px_percent: wrong }) => percent(wrong) },
  ];
};

/** The conditions under which the table's figures were measured. */
export function notesOf({ device, browser, processors, model, triangles, size, antialias, three_revision: revision, settings, gpu_timer: gpuTimer }) {
  return `Median of ${settings.frames} frames of ${size.width} × ${size.height} pixels until they are finished, and the ` +
    `fastest and slowest; to exact: the median of the ratios in ${settings.rounds} turns beside each other. ${model}, ${triangles.toLocaleString('en')} triangles, ` +
    `${settings.light.kind === 'sun' ? 'a sun' : 'a lamp'}; antialiasing ${antialias ? 'on' : 'off'}; bias ${settings.bias}, normal bias ` +
    `${settings.normal_bias}. three.js r${revision}; ${browser}; ${device}${processors ? `; ${processors} processors` : ''}. ` +
    'Where the light rests the camera moves, and three.js keeps its map, but for cascades, which follow the camera. ' +
    'Wrong: of the pixels with a surface those where more than half of the light is other than exact, of soft methods than exact soft. ' +
    `${gpuTimer ? '' : 'There are no timer queries here.'}`;
}

export function tableOf(results) {
  const table = document.createElement('table');
  const columns = columnsOf(results);
  const head = table.createTHead().insertRow();
  for (const title of ['Method', ...columns.map((column) => column.title)])
    head.append(Object.assign(document.createElement('th'), { scope: 'col', textContent: title }));
  const body = table.createTBody();
  for (const result of results.results) {
    const row = body.insertRow();
    row.classList.toggle('ours', result.id.startsWith('exact'));
    row.append(Object.assign(document.createElement('th'), { scope: 'row', textContent: result.label }));
    for (const { cell } of columns) {
      const [text, smaller] = [cell(result)].flat();
      const at = row.insertCell();
      at.textContent = text;
      if (smaller) at.append(Object.assign(document.createElement('small'), { textContent: smaller }));
    }
  }
  return table;
}

/** Saves the results as a file of the user's. */
export function save(results) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([`${JSON.stringify(results, null, 2)}\n`], { type: 'application/json' }));
  link.download = `edgeshade-${results.model.replace(/\.\w+$/, '')}-${results.date}.json`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
