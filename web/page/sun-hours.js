// Hours of sunlight over the picture: checkbox and step, progress of the count, colours, and the
// value under the pointer.

import { hourColors } from '../element/hour-colors.js';
import { check, choose } from './inputs.js';

const $ = (id) => document.getElementById(id);
const steps = [5, 10, 15, 30, 60];

/** "3 h 20 min" */
export function durationText(minutes) {
  const [hours, rest] = [Math.floor(minutes / 60), minutes % 60];
  return [hours && `${hours} h`, rest && `${rest} min`].filter(Boolean).join(' ') || '0 h';
}

/** Hours of sunlight of one surface. */
export const hoursText = ({ lit, of, step }) => `${durationText(lit * step)} of ${durationText(of * step)}`;

/** Progress of the count, in words. */
export function progressText({ counted, of }, moves) {
  if (of === 0) return 'The sun does not rise on this day.';
  if (counted < of) return `Hours of sun: ${counted} of ${of} sun positions`;
  return moves ? 'Hours of sun: shown when nothing moves' : `Hours of sun, from ${of} positions`;
}

/** Connects the controls. Returns refresh(state). */
export function connectSunHours(viewer) {
  const box = check('sun-hours', (on) => viewer.change({ sun_hours: on }));
  const select = $('sun-hours-step');
  select.append(...steps.map((step) => new Option(`${step} min`, String(step))));
  select.addEventListener('change', () => viewer.change({ sun_hours_step: Number(select.value) }));
  $('hours-scale').firstElementChild.style.background = `linear-gradient(90deg, ${hourColors})`;

  let pointer = null; // its position; null: away, or dragging
  let next = 0;
  const point = () => {
    const here = pointer && viewer.sunHoursAt(...pointer);
    const label = $('hours-here');
    label.hidden = !here;
    if (!here) return;
    label.textContent = hoursText(here);
    [label.style.left, label.style.top] = pointer.map((place) => `${place}px`);
  };
  const show = () => {
    next = 0;
    const hours = viewer.sunHours;
    $('hours').hidden = !hours;
    if (hours) {
      const { state } = viewer;
      const moves = state.playing || state.day_playing;
      const complete = hours.counted === hours.of;
      $('hours-progress').textContent = progressText(hours, moves);
      $('hours-scale').hidden = !complete || moves || hours.of === 0;
      $('hours-most').textContent = durationText(hours.of * hours.step);
      if (!complete) next = requestAnimationFrame(show);
    }
    point();
  };
  const later = () => { next ||= requestAnimationFrame(show); };
  viewer.addEventListener('frame', later);
  for (const type of ['pointermove', 'pointerdown', 'pointerup', 'pointerleave'])
    viewer.addEventListener(type, (event) => {
      // A lifted finger keeps its last position.
      if (type === 'pointerleave' && event.pointerType !== 'mouse') return;
      pointer = type === 'pointerleave' || event.buttons ? null : [event.clientX, event.clientY];
      point();
    });

  return function refresh(state) {
    box(state.sun_hours);
    choose(select, String(state.sun_hours_step), `${state.sun_hours_step} min`);
    later();
  };
}
