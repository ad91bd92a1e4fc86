// Drag and drop of files and folders, and the file picker.

async function filesBelow(entry, folder = '') {
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
    file.relativePath = folder + file.name;
    return [file];
  }
  const reader = entry.createReader();
  const files = [];
  for (;;) {
    const entries = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (entries.length === 0) return files;
    for (const below of entries) files.push(...(await filesBelow(below, `${folder}${entry.name}/`)));
  }
}

async function filesOf(transfer) {
  // Entries must be read before the first await.
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (entries.some((entry) => entry.isDirectory))
    return (await Promise.all(entries.map((entry) => filesBelow(entry)))).flat();
  return [...transfer.files];
}

/** Calls onFiles(files) for files that are dropped anywhere on the page or picked. */
export function acceptFiles({ overlay, picker, openButton, onFiles, onProblem }) {
  let depth = 0; // dragenter and dragleave arrive for every element on the way
  const show = (on) => { overlay.hidden = !on; };
  const hasFiles = (event) => event.dataTransfer?.types.includes('Files');
  addEventListener('dragenter', (event) => {
    if (!hasFiles(event)) return;
    depth += 1;
    show(true);
  });
  addEventListener('dragleave', () => {
    depth = Math.max(0, depth - 1);
    if (depth === 0) show(false);
  });
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', async (event) => {
    event.preventDefault();
    depth = 0;
    show(false);
    try {
      onFiles(await filesOf(event.dataTransfer));
    } catch (error) {
      onProblem(`The dropped files could not be read: ${error.message}`);
    }
  });
  openButton.addEventListener('click', () => picker.click());
  picker.addEventListener('change', () => {
    if (picker.files.length) onFiles([...picker.files]);
    picker.value = ''; // so that the same file can be picked again
  });
}
