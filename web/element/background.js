// What is behind the scene: the colour that CSS gives the element, so that it follows the theme.

const dark = '(prefers-color-scheme: dark)';

/** The element's CSS background as [r, g, b] in 0..1; null where it is none or no plain colour. */
function backgroundOf(element) {
  const parts = getComputedStyle(element).backgroundColor.match(/^rgba?\(([^)]+)\)$/)?.[1]
    .split(/[\s,/]+/).map(Number);
  if (!parts || !parts.every(Number.isFinite) || parts[3] === 0) return null;
  return parts.slice(0, 3).map((value) => value / 255);
}

/** Calls onColor([r, g, b]) now and with every change of the theme; returns what stops it. */
export function watchBackground(element, onColor) {
  const query = matchMedia(dark);
  const report = () => {
    const color = backgroundOf(element);
    if (color) onColor(color);
  };
  query.addEventListener('change', report);
  report();
  return () => query.removeEventListener('change', report);
}
