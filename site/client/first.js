// The first screen: the element, and the sun that is dragged on a dial or by sliders.

import '../app/element/edgeshade-viewer.js';
import { anglesOf, directionOf } from '../app/page/sun.js';
import { connectMethods } from '../app/page/methods.js';
import { sampleView } from '../app/page/sample.js';

const $ = (id) => document.getElementById(id);
const [viewer, dial, disc, azimuth, elevation] = ['first', 'dial', 'disc', 'azimuth', 'elevation'].map($);
const rim = 54; // of the dial, in its own units: the horizon

/** The sun on the dial: its middle is the zenith, its rim the horizon. */
function showDisc() {
  const [angle, radius] = [Number(azimuth.value) * Math.PI / 180, rim * (90 - Number(elevation.value)) / 90];
  disc.setAttribute('cx', radius * Math.sin(angle));
  disc.setAttribute('cy', -radius * Math.cos(angle));
}

function aim() {
  showDisc();
  if (viewer.loaded) viewer.change({ lights: [[...directionOf(Number(azimuth.value), Number(elevation.value)), 0]] });
}

function drag({ clientX, clientY }) {
  const box = dial.getBoundingClientRect();
  const [x, y] = [clientX - box.left - box.width / 2, clientY - box.top - box.height / 2];
  azimuth.value = (Math.atan2(x, -y) * 180 / Math.PI + 360) % 360;
  elevation.value = 90 * (1 - Math.hypot(x, y) / (box.width / 2 * rim / 60));
  aim();
}

dial.addEventListener('pointerdown', (event) => {
  dial.setPointerCapture(event.pointerId);
  drag(event);
});
dial.addEventListener('pointermove', (event) => { if (dial.hasPointerCapture(event.pointerId)) drag(event); });
for (const slider of [azimuth, elevation]) slider.addEventListener('input', aim);

connectMethods(viewer, $('methods'));
viewer.hidden = false;
const { width, height } = viewer.getBoundingClientRect();
await viewer.load(new URL('../app/assets/pavilion.glb', import.meta.url), { home: { ...sampleView(width / height, 0), show_lights: false } });
const [x, y, z] = viewer.state.lights[0];
const angles = anglesOf([x, y, z]);
[azimuth.value, elevation.value] = [angles.azimuth, angles.elevation];
showDisc();
viewer.parentElement.querySelector('img').remove();
