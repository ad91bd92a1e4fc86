// The panel's controls for a sun by place and time.

import { check, slider } from './inputs.js';
import { connectSunHours } from './sun-hours.js';
import { clockOf, dateOf, dayOf, daysOfYear, now, offsetText, offsets, partsOf, timeOf } from './local-time.js';

const $ = (id) => document.getElementById(id);

/** Default: the user's clock, and the longitude at which that clock is the sun's. */
function somewhere() {
  const { time, ahead } = now();
  return { place: [48, Math.max(-180, Math.min(180, ahead / 4))], time, north: 0 };
}

/** A sentence about the sun's position. */
function textOf({ azimuth, altitude, up, rise, set }) {
  const clock = (time) => partsOf(time).minutes;
  const where = `Azimuth ${azimuth.toFixed(1)}°, height ${altitude.toFixed(1)}°`;
  const when = rise && set ? `up from ${clockOf(clock(rise))} to ${clockOf(clock(set))}`
    : rise ? `rises at ${clockOf(clock(rise))}` : set ? `sets at ${clockOf(clock(set))}`
      : up ? 'does not set' : 'does not rise';
  return `${where}: ${up ? '' : 'below the horizon, '}${when}.`;
}

/** Connects the controls. Returns refresh(state). */
export function connectSun(viewer) {
  const parts = () => partsOf(viewer.state.sun.time);
  const change = (sun) => viewer.change({ sun });
  const set = (part) => change({ time: timeOf({ ...parts(), ...part }) });
  const box = check('by-place', (on) => change(on ? somewhere() : null));
  const place = [$('latitude'), $('longitude')];
  for (const input of place)
    input.addEventListener('change', () => {
      if (place.every((each) => each.value !== '' && each.checkValidity()))
        change({ place: place.map((each) => Number(each.value)) });
      else input.reportValidity();
    });
  $('date').addEventListener('change', () => {
    if ($('date').value && $('date').checkValidity()) set({ date: $('date').value });
  });
  $('utc-offset').append(...offsets.map(offsetText).map((text) => new Option(text, text)));
  $('utc-offset').addEventListener('change', () => set({ offset: $('utc-offset').value }));
  const refreshHours = connectSunHours(viewer);
  $('play-day').addEventListener('click', () => viewer.run('toggleDay'));
  const show = {
    day: slider('day', () => parts().date.slice(5), (day) => set({ date: dateOf(Number(parts().date.slice(0, 4)), day) })),
    time: slider('time-of-day', clockOf, (minutes) => set({ minutes })),
    north: slider('north', (v) => `${Math.round(v)}°`, (north) => change({ north })),
  };

  return function refresh(state) {
    const { sun, day_playing: playing } = state;
    refreshHours(state);
    box(Boolean(sun));
    $('sun-place').hidden = !sun;
    if (!sun) return;
    place.forEach((input, i) => {
      if (document.activeElement !== input) input.value = String(sun.place[i]);
    });
    const { date, minutes, offset } = partsOf(sun.time);
    if (document.activeElement !== $('date')) $('date').value = date;
    const select = $('utc-offset');
    if (![...select.options].some((option) => option.value === offset))
      select.append(new Option(offset, offset));
    select.value = offset;
    $('day').max = String(daysOfYear(Number(date.slice(0, 4))));
    show.day(dayOf(date));
    show.time(minutes);
    show.north(sun.north);
    $('play-day').textContent = playing ? 'Pause the day' : 'Play the day';
    $('play-day').setAttribute('aria-pressed', String(playing));
    $('sun-now').textContent = textOf(viewer.sun);
  };
}
