// The canvas' size in device pixels, exact for every zoom and screen.

/**
 * Calls onSize(width, height, pixelRatio) now and whenever it changes; returns a function that
 * stops this.
 */
export function watchPictureSize(canvas, onSize) {
  let box = null;
  const report = () => {
    const ratio = window.devicePixelRatio || 1;
    const exact = box?.devicePixelContentBoxSize?.[0];
    const pixels = (length, told) => {
      const about = length * ratio;
      // The reported size is exact, but in pixels of the screen; the page may be shown smaller.
      return Math.max(1, told && Math.abs(told - about) < 2 ? told : Math.round(about));
    };
    onSize(pixels(canvas.clientWidth, exact?.inlineSize),
      pixels(canvas.clientHeight, exact?.blockSize), ratio);
  };
  const observer = new ResizeObserver((entries) => {
    box = entries[entries.length - 1];
    report();
  });
  try {
    observer.observe(canvas, { box: 'device-pixel-content-box' });
  } catch {
    observer.observe(canvas); // for browsers that can't report device pixels
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
