// The handle of the split, dragged or moved by keys, with what each side shows.

const names = { auto: 'Exact', volumes: 'Volumes', 'primitive-map': 'Exact, looked up', none: 'No shadows' };
const nameOf = (side) => names[side.shadows] ?? `Map ${side.map_size}`;
const step = 0.02;

/** Returns refresh(), which puts the handle where the state says. */
export function connectDivider(viewer, divider) {
  const moveTo = (share) => viewer.change({ split_at: Math.min(1, Math.max(0, share)) });
  const shareOf = (event) => {
    const box = viewer.getBoundingClientRect();
    return (event.clientX - box.left) / box.width;
  };
  divider.addEventListener('pointerdown', (event) => {
    divider.setPointerCapture(event.pointerId);
    divider.focus({ preventScroll: true });
    event.preventDefault();
  });
  divider.addEventListener('pointermove', (event) => {
    if (divider.hasPointerCapture(event.pointerId)) moveTo(shareOf(event));
  });
  divider.addEventListener('keydown', (event) => {
    const at = viewer.state.split_at;
    const goal = { ArrowLeft: at - step, ArrowRight: at + step, Home: 0, End: 1 }[event.key];
    if (goal === undefined) return;
    moveTo(goal);
    event.preventDefault();
  });
  return function refresh() {
    const state = viewer.state;
    divider.hidden = !viewer.loaded || !state.split || state.sun_hours;
    if (divider.hidden) return;
    divider.style.left = `${100 * state.split_at}%`;
    divider.setAttribute('aria-valuenow', String(Math.round(100 * state.split_at)));
    divider.setAttribute('aria-valuetext', `${Math.round(100 * state.split_at)} % ${nameOf(state.left)}`);
    divider.querySelector('.left').textContent = nameOf(state.left);
    divider.querySelector('.right').textContent = nameOf(state.right);
  };
}
