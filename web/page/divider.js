// The handle of the split, labelled with the method of each side.

import { connectHandle, showHandle } from './handle.js';

const names = { auto: 'Exact', volumes: 'Volumes', 'primitive-map': 'Exact, lookup', none: 'No shadows' };
const nameOf = (side) => names[side.shadows] ?? `Map ${side.map_size}`;

/** Returns refresh(), which moves the handle to the state's position. */
export function connectDivider(viewer, divider) {
  connectHandle(divider, viewer, {
    at: () => viewer.state.split_at,
    moveTo: (split_at) => viewer.change({ split_at }),
  });
  return function refresh() {
    const state = viewer.state;
    divider.hidden = !viewer.loaded || !state.split || state.sun_hours;
    if (!divider.hidden) showHandle(divider, state.split_at, nameOf(state.left), nameOf(state.right));
  };
}
