// A handle between two parts of a picture, moved by dragging or by keys.

const step = 0.02;

/**
 * `at()`: its place as a share of the area's width, 0 to 1; `moveTo(share)` is called with its new
 * place, in the same range.
 */
export function connectHandle(handle, area, { at, moveTo }) {
  const within = (share) => moveTo(Math.min(1, Math.max(0, share)));
  const shareOf = (event) => {
    const box = area.getBoundingClientRect();
    return (event.clientX - box.left) / box.width;
  };
  handle.addEventListener('pointerdown', (event) => {
    handle.setPointerCapture(event.pointerId);
    handle.focus({ preventScroll: true });
    event.preventDefault();
  });
  handle.addEventListener('pointermove', (event) => {
    if (handle.hasPointerCapture(event.pointerId)) within(shareOf(event));
  });
  handle.addEventListener('keydown', (event) => {
    const goal = { ArrowLeft: at() - step, ArrowRight: at() + step, Home: 0, End: 1 }[event.key];
    if (goal === undefined) return;
    within(goal);
    event.preventDefault();
  });
}

/** Places it at a share, and describes the parts to its left and right in words. */
export function showHandle(handle, share, left, right) {
  handle.style.left = `${100 * share}%`;
  handle.setAttribute('aria-valuenow', String(Math.round(100 * share)));
  handle.setAttribute('aria-valuetext', `${Math.round(100 * share)} % ${left}`);
  handle.querySelector('.left').textContent = left;
  handle.querySelector('.right').textContent = right;
}
