// The folder in memory from which the program reads a scene and the files that it names.

const sceneFolder = '/scene';

/** Where in the scene's folder a file is that a .gltf names; null: outside, or in the .gltf itself. */
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

/** Files that a .gltf names in these of its sections: [{uri, path}]; those outside its folder are
 * left to the program. */
export function outsideFilesOf(bytes, sections) {
  let json;
  try {
    if (bytes[0] === 0x67) return []; // "glTF": a GLB
    json = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    return []; // the program says what is wrong with it
  }
  return sections.flatMap((section) => json?.[section] ?? [])
    .map((entry) => ({ uri: entry?.uri, path: placeOf(entry?.uri) }))
    .filter(({ path }) => path);
}

const lastPart = (path) => path.slice(path.lastIndexOf('/') + 1);

/** A file that was dropped without its folder stands in for the one named with it. */
function withNamedPlaces(name, files) {
  const placed = new Map(files);
  for (const { path } of outsideFilesOf(files.get(name), ['buffers', 'images'])) {
    if (placed.has(path)) continue;
    for (const [other, bytes] of files) if (lastPart(other) === lastPart(path)) placed.set(path, bytes);
  }
  return placed;
}

/** Writes a file into the folder, which is there. */
export function placeFile(fs, path, bytes) {
  const folder = path.slice(0, path.length - lastPart(path).length);
  if (folder) fs.mkdirTree(`${sceneFolder}/${folder}`);
  fs.writeFile(`${sceneFolder}/${path}`, bytes, { canOwn: true });
}

/** Writes the files into a fresh folder, which becomes the current one. */
export function placeFiles(fs, name, files) {
  fs.mkdir(sceneFolder);
  fs.chdir(sceneFolder);
  for (const [path, bytes] of withNamedPlaces(name, files)) placeFile(fs, path, bytes);
}
