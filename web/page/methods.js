// The method of each light's shadows and the reason for it, in words.

const ways = {
  volumes: 'counted by shadow volumes',
  'primitive-map': 'looked up in a primitive map',
  'irregular-z-buffer': 'tested point by point',
  map: 'sampled from a shadow map',
  planar: 'projected onto planes',
  none: 'left out',
};

/** Methods that users choose; the viewer describes them, where it gives a reason for others. */
const described = ['map', 'planar'];

/** A sentence about a light. `method`, `why`: from the viewer's statistics; `why` is empty if the method was chosen. */
export function methodText({ method, why }, index) {
  const reason = described.includes(method) || !why ? ['as chosen', why].filter(Boolean).join(': ') : `reason: ${why}`;
  return `Light ${index + 1}: shadows are ${ways[method] ?? method}; ${reason}.`;
}

const most = 6; // lines; further lights are summed up

/** Lines about all lights. */
export function methodLines(lights) {
  const lines = lights.slice(0, most).map(methodText);
  return lights.length > most ? [...lines, `${lights.length - most} further lights`] : lines;
}

/** Keeps a list in step with the viewer, at most four times a second. */
export function connectMethods(viewer, list) {
  let waiting = null;
  let shown = null;
  const show = () => {
    waiting = null;
    const lines = methodLines(viewer.stats?.lights ?? []);
    if (lines.join('\n') === shown) return;
    shown = lines.join('\n');
    list.replaceChildren(...lines.map((line) => Object.assign(document.createElement('li'), { textContent: line })));
  };
  // The first frame of a scene comes with `load`, not `frame`.
  for (const type of ['load', 'change', 'frame'])
    viewer.addEventListener(type, () => { waiting ??= setTimeout(show, 250); });
}
