// Sliders for the chosen light's extent, with the progress of its soft shadow.

import { isSun, withExtent } from '../element/lights.js';
import { slider } from './inputs.js';

const $ = (id) => document.getElementById(id);
const largestShare = 0.1; // largest radius of a lamp, as a share of the scene's size

/** Connects the sliders. Returns refresh(state). */
export function connectSoftness(viewer) {
  const change = (value) => {
    const { lights, chosen_light: chosen } = viewer.state;
    lights[chosen] = withExtent(lights[chosen], value);
    viewer.change({ lights });
  };
  // A lamp's slider follows the square root, so that small radii can be distinguished.
  const largest = () => largestShare * viewer.sceneSize;
  const radiusOf = (value) => (value / 100) ** 2 * largest();
  const angle = slider('sun-angle', (v) => (v > 0 ? `${v.toFixed(2)}°` : 'hard'), change);
  const radius = slider('light-radius',
    (v) => (v > 0 ? Number(radiusOf(v).toPrecision(2)) : 'hard'), (v) => change(radiusOf(v)));
  const showPoints = () => {
    const { shown, of } = viewer.lightPoints;
    $('light-points').hidden = of === 0;
    $('light-points').textContent = shown < of
      ? `Soft shadow: ${shown} of ${of} points` : `Soft shadow: ${of} points`;
  };
  viewer.addEventListener('frame', showPoints);
  return function refresh(state) {
    const light = state.lights[state.chosen_light];
    const sun = isSun(light);
    $('sun-angle').parentElement.hidden = !sun;
    $('light-radius').parentElement.hidden = sun;
    if (sun) angle(light.angle ?? 0);
    else radius(100 * Math.sqrt(Math.min((light.radius ?? 0) / (largest() || 1), 1)));
    showPoints();
  };
}
