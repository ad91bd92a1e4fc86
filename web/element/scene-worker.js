// The worker that reads a scene: downloads, decodes, finds the edges, builds the shadow data. It
// passes the page a buffer that only needs copying.

import { instantiate } from './runtime.js';
import { download, downloadBeside } from './download.js';
import { takeImages } from './scene-images.js';
import { placeFile, placeFiles, placeOf } from './virtual-folder.js';

const progress = (stage, fraction = 0) => postMessage({ progress: { stage, fraction } });

async function bytesOf(source) {
  if (source.url) return download(source.url, (fraction) => progress('download', fraction));
  const files = new Map();
  for (const { path, blob } of source.files) {
    try {
      files.set(path, new Uint8Array(await blob.arrayBuffer()));
    } catch {
      throw new Error(`'${path}' could not be read from your device.`);
    }
  }
  return { name: source.name, files };
}

/**
 * Fetches a file that the scene names, unless it is already there or lies outside the scene's
 * folder.
 */
async function fetchFile(fs, source, uri) {
  const path = placeOf(uri);
  if (!source.url || !path || fs.analyzePath(path).exists) return;
  placeFile(fs, path, await downloadBeside(source.url, uri, path));
}

/** Milliseconds of each stage. */
class Stages {
  #milliseconds = {};
  #stage = null;
  #since = 0;

  enter(stage) {
    const now = performance.now();
    if (this.#stage)
      this.#milliseconds[this.#stage] = (this.#milliseconds[this.#stage] ?? 0) + now - this.#since;
    this.#stage = stage;
    this.#since = now;
    if (stage) progress(stage);
  }
  get milliseconds() {
    return this.#milliseconds;
  }
}

/** Throws the program's sentence for a failure, if there is one. */
function requireDone(problem) {
  if (problem) throw new Error(problem);
}

async function read({ module, source, variant }) {
  const stages = new Stages();
  stages.enter('download');
  const [program, { name, files }] = await Promise.all([instantiate(module), bytesOf(source)]);
  const fileBytes = [...files.values()].reduce((sum, bytes) => sum + bytes.byteLength, 0);
  stages.enter('read');
  placeFiles(program.FS, name, files);
  files.clear();
  const reader = new program.SceneReader();
  const onStage = (stage) => stages.enter(stage);
  requireDone(reader.read(name, variant, onStage));
  await takeImages(reader, (uri) => fetchFile(program.FS, source, uri));
  requireDone(reader.finish(onStage));
  const bytes = reader.bytes().slice();
  stages.enter(null);
  const scene = {
    name,
    bytes,
    fileBytes,
    triangles: reader.triangles(),
    warnings: JSON.parse(reader.warnings()),
    variants: JSON.parse(reader.variants()).filter(Boolean),
    cameras: JSON.parse(reader.cameras()),
    milliseconds: stages.milliseconds,
  };
  postMessage({ scene }, [bytes.buffer]);
}

/** A failure inside the program, such as a failed growth of its memory, as a sentence. */
function sentenceFor(error) {
  if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)
    return 'The scene could not be read: it needs more than the browser provides ' +
      `(${error.message}).`;
  return error.message || 'The scene could not be read.';
}

onmessage = ({ data }) =>
  read(data).catch((error) => postMessage({ problem: sentenceFor(error) }));
