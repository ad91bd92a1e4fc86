// The background of the scene: the colour that CSS gives the element, so that it follows the theme.

const dark = '(prefers-color-scheme: dark)';

/** The element's CSS background as [r, g, b] in 0..1; null if there is none, or no plain colour. */
export function backgroundOf(element) {
  const parts = getComputedStyle(element).backgroundColor.match(/^rgba?\(([^)]+)\)$/)?.[1]
    .split(/[\s,/]+/).map(Number);
  if (!parts || !parts.every(Number.isFinite) || parts[3] === 0) return null;
  return parts.slice(0, 3).map((value) => value / 255);
}

/** Calls onChange() whenever the theme changes; returns a function that stops this. */
export function watchTheme(onChange) {
  const query = matchMedia(dark);
  query.addEventListener('change', onChange);
  return () => query.removeEventListener('change', onChange);
}
