// The folder in memory from which the program reads a scene and the files it names.

const sceneFolder = '/scene';

/**
 * The path in the scene's folder of a file that a .gltf names; null if it lies outside, or in the
 * .gltf itself.
 */
export function placeOf(uri) {
  if (typeof uri !== 'string' || /^[a-z][a-z0-9+.-]*:/i.test(uri)) return null;
  let path;
  try {
    path = decodeURIComponent(uri);
  } catch {
    return null;
  }
  return path.startsWith('/') || path.split(/[\\/]/).includes('..') ? null : path;
}

/** The files that a .gltf names in these sections: [{uri, path}]; files outside its folder are
 * left to the program. */
export function outsideFilesOf(bytes, sections) {
  let json;
  try {
    if (bytes[0] === 0x67) return []; // "glTF": a GLB
    json = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    return []; // the program reports what is wrong with it
  }
  return sections.flatMap((section) => json?.[section] ?? [])
    .map((entry) => ({ uri: entry?.uri, path: placeOf(entry?.uri) }))
    .filter(({ path }) => path);
}

const lastPart = (path) => path.slice(path.lastIndexOf('/') + 1);

/** A file that was dropped without its folder stands in for the one that the .gltf names. */
function withNamedPlaces(name, files) {
  const placed = new Map(files);
  for (const { path } of outsideFilesOf(files.get(name), ['buffers', 'images'])) {
    if (placed.has(path)) continue;
    for (const [other, bytes] of files) if (lastPart(other) === lastPart(path)) placed.set(path, bytes);
  }
  return placed;
}

/** Writes a file into the existing folder. */
export function placeFile(fs, path, bytes) {
  const folder = path.slice(0, path.length - lastPart(path).length);
  if (folder) fs.mkdirTree(`${sceneFolder}/${folder}`);
  fs.writeFile(`${sceneFolder}/${path}`, bytes, { canOwn: true });
}

/** Writes the files into a new folder, which becomes the current one. */
export function placeFiles(fs, name, files) {
  fs.mkdir(sceneFolder);
  fs.chdir(sceneFolder);
  for (const [path, bytes] of withNamedPlaces(name, files)) placeFile(fs, path, bytes);
}
