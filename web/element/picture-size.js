// The canvas' size in device pixels, exactly, whatever the zoom and the screen.

/** Calls onSize(width, height, pixelRatio) now and whenever it changes; returns what stops it. */
export function watchPictureSize(canvas, onSize) {
  let box = null;
  const report = () => {
    const ratio = window.devicePixelRatio || 1;
    const exact = box?.devicePixelContentBoxSize?.[0];
    const width = exact ? exact.inlineSize : Math.round(canvas.clientWidth * ratio);
    const height = exact ? exact.blockSize : Math.round(canvas.clientHeight * ratio);
    onSize(Math.max(1, width), Math.max(1, height), ratio);
  };
  const observer = new ResizeObserver((entries) => {
    box = entries[entries.length - 1];
    report();
  });
  try {
    observer.observe(canvas, { box: 'device-pixel-content-box' });
  } catch {
    observer.observe(canvas); // a browser that can't tell device pixels
  }
  let stopWatchingRatio = () => {};
  const watchRatio = () => {
    const query = matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    const changed = () => {
      stopWatchingRatio();
      box = null;
      report();
      watchRatio();
    };
    query.addEventListener('change', changed);
    stopWatchingRatio = () => query.removeEventListener('change', changed);
  };
  watchRatio();
  report();
  return () => {
    observer.disconnect();
    stopWatchingRatio();
  };
}
