// Converts a time of the state, "2026-06-21T14:30+02:00", to values of sliders and back.

const minute = 60000;
const two = (value) => String(value).padStart(2, '0');

/** {date: "2026-06-21", minutes: of the day, offset: "+02:00"} */
export function partsOf(time) {
  const [, date, hours, minutes, offset] = /^(\d{4}-\d\d-\d\d)T(\d\d):(\d\d)(?::\d\d)?(.*)$/.exec(time);
  return { date, minutes: 60 * Number(hours) + Number(minutes), offset };
}

export const timeOf = ({ date, minutes, offset }) => `${date}T${clockOf(minutes)}${offset}`;

/** "14:30" */
export const clockOf = (minutes) => `${two(Math.floor(minutes / 60))}:${two(minutes % 60)}`;

const startOf = (year) => {
  const start = new Date(0);
  start.setUTCFullYear(year, 0, 1);
  return start.getTime();
};

export const daysOfYear = (year) => (startOf(year + 1) - startOf(year)) / (1440 * minute);

/** Day of the year, 1 for the first of January. */
export function dayOf(date) {
  return 1 + (Date.parse(date) - startOf(Number(date.slice(0, 4)))) / (1440 * minute);
}

/** The inverse of dayOf(). */
export const dateOf = (year, day) =>
  new Date(startOf(year) + (day - 1) * 1440 * minute).toISOString().slice(0, 10);

/** "+05:30" from minutes ahead of UTC. */
export function offsetText(ahead) {
  const size = Math.abs(ahead);
  return `${ahead < 0 ? '-' : '+'}${two(Math.floor(size / 60))}:${two(size % 60)}`;
}

/** Offsets of the world's clocks, in minutes. */
export const offsets = [...Array(27)].map((_, i) => 60 * (i - 12))
  .concat([-570, -210, 210, 270, 330, 345, 390, 525, 570, 630, 765]).sort((a, b) => a - b);

/** Now, by the user's clock, to five minutes. */
export function now() {
  const date = new Date(5 * minute * Math.round(Date.now() / (5 * minute)));
  const ahead = -date.getTimezoneOffset();
  const shown = new Date(date.getTime() + ahead * minute).toISOString();
  return { time: `${shown.slice(0, 16)}${offsetText(ahead)}`, ahead };
}
