// The table of figures: the cost of the last frames and the contents of the scene.

const milliseconds = (value) => `${value.toFixed(value < 10 ? 2 : 1)} ms`;
const whole = (value) => Math.round(value).toLocaleString('en');

/** [label, text] of each known figure. `stats`: from the viewer. */
export function rowsOf(stats, loaded, sizeText) {
  const rows = [];
  const put = (label, value, text) => {
    if (value !== undefined && value !== null) rows.push([label, text(value)]);
  };
  put('Frame', stats.frame_ms, milliseconds);
  put('of which planning', stats.plan_ms, milliseconds);
  if (stats.pose_ms > 0) put('besides, posing', stats.pose_ms, milliseconds);
  for (const [stage, value] of Object.entries(stats.stage_ms ?? {}))
    if (value > 0) put(`of it ${stage}`, value, milliseconds);
  put('Triangles', stats.triangles, whole);
  put('Edges', stats.edges, whole);
  put('Records', stats.records, whole);
  put('Silhouette edges', stats.silhouettes, whole);
  put('Shadow data on the GPU', stats.shadow_bytes, sizeText);
  if (stats.map_bytes) put('Shadow maps', stats.map_bytes, sizeText);
  if (stats.primitive_map_bytes) put('Primitive maps', stats.primitive_map_bytes, sizeText);
  if (loaded) {
    put('File', loaded.fileBytes, sizeText);
    put('From click to picture', loaded.totalMilliseconds, milliseconds);
  }
  return rows;
}

/** Returns refresh(stats, loaded), at most four times a second. */
export function connectFigures(list, sizeText) {
  let waiting = null;
  let latest = null;
  const show = () => {
    waiting = null;
    list.replaceChildren(...rowsOf(...latest, sizeText).flatMap(([label, text]) => {
      const dt = document.createElement('dt');
      const dd = document.createElement('dd');
      dt.textContent = label;
      dd.textContent = text;
      return [dt, dd];
    }));
  };
  return function refresh(stats, loaded) {
    latest = [stats, loaded];
    waiting ??= setTimeout(show, 250);
  };
}
