// The page around the element: panel, files, address bar.

import { keys, sizeText } from '../element/edgeshade-viewer.js';
import { connectCameras } from './cameras.js';
import { connectControls } from './controls.js';
import { connectDivider } from './divider.js';
import { acceptFiles } from './drop.js';
import { connectFigures } from './figures.js';
import { connectKeyHelp } from './key-help.js';
import { connectMethods } from './methods.js';
import { sampleUrl, sampleView } from './sample.js';
import { connectSheet } from './sheet.js';
import { hashOf, readHash } from './url-state.js';
import { chooseVariant, connectVariants } from './variants.js';

const $ = (id) => document.getElementById(id);
const viewer = $('viewer');
const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)');

let model = null; // on show: {url} or {file}
let loaded = null; // detail of its load event
let wantedForFile = null; // {file, changes}: from an address that names a file on the user's device

connectCameras(viewer, $('cameras'), $('camera'));
connectVariants(viewer, $('variants'), $('variant'));
const refreshControls = connectControls(viewer);
const refreshDivider = connectDivider(viewer, $('divider'));
const refreshFigures = connectFigures($('stats'), sizeText);
connectKeyHelp($('keys'), $('key-list'), $('keys-open'), keys);
connectMethods(viewer, $('light-methods'));
connectSheet($('panel'), $('sheet'));

// ---- loading -----------------------------------------------------------------------------------

async function show(source, next, views) {
  try {
    const detail = await viewer.load(source, views);
    if (!detail) return false;
    model = next ?? { file: detail.name };
    $('scene-name').textContent =
      `${detail.name}: ${detail.triangles.toLocaleString('en')} triangles, ${sizeText(detail.fileBytes)}`;
    document.title = `${detail.name} – edgeshade`;
    refresh();
    return true;
  } catch {
    if (!viewer.loaded) $('scene-name').textContent = 'No scene yet: drop one here, or open one.';
    return false; // the element has informed the user
  }
}

function showFiles(files) {
  chooseVariant(viewer, '');
  const fits = wantedForFile && files.some((file) => file.name === wantedForFile.file);
  const state = fits ? wantedForFile.changes : undefined;
  wantedForFile = null;
  return show(files, null, { state });
}

function showSample(changes) {
  const { width, height } = viewer.getBoundingClientRect();
  const panel = $('panel').getBoundingClientRect();
  const covered = panel.left > 0 ? (width - panel.left) / width : 0; // a sheet lies below the
                                                                     // picture
  const home = sampleView(width / height, covered);
  return show(sampleUrl, { url: sampleUrl }, { home, state: changes });
}

async function showAddress() {
  const { model: asked, changes, problems } = readHash(location.hash);
  chooseVariant(viewer, asked?.variant ?? '');
  if (reducedMotion.matches) {
    delete changes.playing;
    delete changes.day_playing;
  }
  if (asked?.file) {
    wantedForFile = { file: asked.file, changes };
    await showSample({});
    viewer.say(`This address shows '${asked.file}', which is on a device and not on a server: ` +
      'drop that file here to restore the view.');
  } else if (asked?.url && asked.url !== sampleUrl) {
    await show(asked.url, asked, { state: changes });
  } else {
    await showSample(changes);
  }
  for (const problem of problems) viewer.say(problem, 'error');
}

acceptFiles({
  overlay: $('drop'),
  picker: $('files'),
  openButton: $('open'),
  onFiles: showFiles,
  onProblem: (sentence) => viewer.say(sentence, 'error'),
});

// ---- page, picture and address in sync ---------------------------------------------------------

let refreshing = 0;
let saving = null;
let ownHash = location.hash;

function saveAddress() {
  saving = null;
  if (!viewer.loaded || !model) return;
  ownHash = hashOf({ ...model, variant: $('variant').value }, viewer.state);
  history.replaceState(null, '', ownHash);
}

function refresh() {
  if (refreshing) return;
  refreshing = requestAnimationFrame(() => {
    refreshing = 0;
    refreshControls();
    refreshDivider();
    // Browsers limit how often the address may change.
    saving ??= setTimeout(saveAddress, viewer.state?.day_playing ? 2000 : 300);
  });
}

viewer.addEventListener('change', refresh);
viewer.addEventListener('load', ({ detail }) => { loaded = detail; });
viewer.addEventListener('frame', () => {
  if ($('figures').open) refreshFigures(viewer.stats, loaded);
  if (viewer.state.playing || viewer.state.day_playing) refresh();
});
$('figures').addEventListener('toggle', () => refreshFigures(viewer.stats ?? {}, loaded));
addEventListener('hashchange', () => {
  if (location.hash !== ownHash) showAddress();
});
reducedMotion.addEventListener('change', () => {
  if (reducedMotion.matches && viewer.loaded) viewer.change({ playing: false, day_playing: false });
});

// ---- the page's own buttons --------------------------------------------------------------------

$('screenshot').addEventListener('click', async () => {
  try {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(await viewer.screenshot());
    link.download = `${(loaded?.name ?? 'edgeshade').replace(/\.\w+$/, '')}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  } catch (error) {
    viewer.say(error.message, 'error');
  }
});

showAddress();
