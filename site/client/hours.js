// Hours of sun: the element's own count, shown at the pointer or at a place that keys move.

import '../app/element/edgeshade-viewer.js';
import { hourColors } from '../app/element/hour-colors.js';
import { sampleView } from '../app/page/sample.js';
import { hoursText, progressText } from '../app/page/sun-hours.js';

const $ = (id) => document.getElementById(id);
const [viewer, here, day, pointer, scale] = ['hours', 'here', 'day', 'pointer', 'scale'].map($);
const keyStep = 12; // CSS pixels that a key moves the pointer by
const place = [48.14, 11.57];
let at = null; // the pointer, in the element, CSS pixels

scale.style.background = `linear-gradient(90deg, ${hourColors})`;

function show() {
  const hours = viewer.sunHours;
  if (!hours) return;
  if (hours.of === 0 || hours.counted < hours.of) {
    here.textContent = progressText(hours, false);
    return;
  }
  const box = viewer.getBoundingClientRect();
  const found = at && viewer.sunHoursAt(box.left + at[0], box.top + at[1]);
  here.textContent = found ? `${hoursText(found)} of sun here` : 'Point at the picture.';
}

function point(x, y, marked) {
  at = [x, y];
  pointer.hidden = !marked;
  [pointer.style.left, pointer.style.top] = [`${x}px`, `${y}px`];
  show();
}

viewer.addEventListener('pointermove', ({ clientX, clientY }) => {
  const box = viewer.getBoundingClientRect();
  point(clientX - box.left, clientY - box.top, false);
});
viewer.addEventListener('keydown', (event) => {
  const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
  if (!event.altKey || !(dx || dy)) return;
  event.preventDefault();
  event.stopPropagation();
  const { width, height } = viewer.getBoundingClientRect();
  const [x, y] = at ?? [width / 2, height / 2];
  point(Math.min(width - 1, Math.max(0, x + keyStep * dx)), Math.min(height - 1, Math.max(0, y + keyStep * dy)), true);
}, { capture: true });
viewer.addEventListener('frame', show);
day.addEventListener('change', () => {
  if (day.value) viewer.change({ sun: { place, time: `${day.value}T12:00+01:00` } });
});

viewer.hidden = false;
const { width, height } = viewer.getBoundingClientRect();
await viewer.load(new URL('../app/assets/pavilion.glb', import.meta.url), { home: { ...sampleView(width / height, 0),
  show_lights: false, sun: { place, time: `${day.value}T12:00+01:00` }, sun_hours: true, sun_hours_step: 30 } });
viewer.parentElement.querySelector('img').remove();
const poll = () => {
  show();
  const { counted, of } = viewer.sunHours;
  if (counted < of) setTimeout(poll, 200);
};
poll();
