// A page's use of the element in TypeScript; it must compile, and each expected error must occur.

import 'edgeshade';
import { hourColors, keys, sizeText, type Command, type EdgeshadeViewer, type LoadDetail, type ViewState } from 'edgeshade';

const viewer: EdgeshadeViewer = document.createElement('edgeshade-viewer');
const found = document.querySelector('edgeshade-viewer');
found?.fit();

viewer.addEventListener('load', (event) => {
  const { triangles, milliseconds, source } = event.detail;
  const seconds: number = milliseconds.draw / 1000;
  console.log(triangles.toFixed(), seconds, source?.length);
});
viewer.addEventListener('progress', (event) => console.log(event.detail.stage, event.detail.fraction));
viewer.addEventListener('error', (event) => console.log(event.detail.message));
viewer.addEventListener('contextlost', () => viewer.say('One moment.', 'note'));
viewer.addEventListener('click', (event) => console.log(event.clientX));

export async function show(file: File): Promise<LoadDetail | null> {
  const detail = await viewer.load(file, { home: { ambient: 0.4 }, state: { left: { shadows: 'map' } } });
  await viewer.load(new URL('house.glb', document.baseURI));
  await viewer.load([file]);
  viewer.change({ lights: [[1.5, 2.2, 0, 1]], camera: { fov: 40 }, background: [0, 0, 0] });
  const state: ViewState | null = viewer.state;
  const command: Command = keys[0].command;
  viewer.run(command);
  const hours: number | undefined = viewer.sunHours?.counted;
  console.log(hours, viewer.sunHoursAt(1, 2)?.lit.toFixed(), hourColors[0].length);
  const picture: Blob = await viewer.screenshot();
  console.log(state?.camera.from[0].toFixed(1), viewer.stats?.frame_ms, sizeText(picture.size));
  return detail;
}

// @ts-expect-error: not a method of shadows
viewer.change({ left: { shadows: 'soft' } });
// @ts-expect-error: a light has four numbers
viewer.change({ lights: [[1, 2, 3]] });
// @ts-expect-error: no such command
viewer.run('fly');
// @ts-expect-error: read only
viewer.loaded = true;
