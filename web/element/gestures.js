// Passes mouse, pen, touch and keys on the picture to the viewer, in picture pixels.

const phases = { pointerdown: 0, pointermove: 1, pointerup: 2, pointercancel: 2 };
const pixelsPerNotch = 100;
const linesPerNotch = 3;

/** Keys of the picture. Others, above all Tab, are left to the page. */
export const keys = [
  { key: 'ArrowLeft', command: 'orbitLeft', does: 'Orbit' },
  { key: 'ArrowRight', command: 'orbitRight' },
  { key: 'ArrowUp', command: 'orbitUp' },
  { key: 'ArrowDown', command: 'orbitDown' },
  { key: 'Shift+ArrowLeft', command: 'panLeft', does: 'Pan' },
  { key: 'Shift+ArrowRight', command: 'panRight' },
  { key: 'Shift+ArrowUp', command: 'panUp' },
  { key: 'Shift+ArrowDown', command: 'panDown' },
  { key: '+', command: 'zoomIn', does: 'Zoom in' },
  { key: '-', command: 'zoomOut', does: 'Zoom out' },
  { key: 'f', command: 'fit', does: 'Fit the scene' },
  { key: 'r', command: 'reset', does: 'Reset the view' },
  { key: 'a', command: 'lightLeft', does: 'Move the light left' },
  { key: 'd', command: 'lightRight', does: 'Move the light right' },
  { key: 'w', command: 'lightUp', does: 'Move the light up' },
  { key: 's', command: 'lightDown', does: 'Move the light down' },
  { key: 'q', command: 'lightNearer', does: 'Move the light nearer' },
  { key: 'e', command: 'lightFarther', does: 'Move the light farther' },
  { key: 'l', command: 'nextLight', does: 'Choose the next light' },
  { key: 'n', command: 'addLight', does: 'Add a light' },
  { key: 'Delete', command: 'removeLight', does: 'Remove the light' },
  { key: 'u', command: 'toggleSun', does: 'Switch between sun and point light' },
  { key: 'm', command: 'nextShadows', does: 'Next shadow method' },
  { key: 'c', command: 'toggleSplit', does: 'Compare two settings' },
  { key: '[', command: 'splitLeft', does: 'Move the divider left' },
  { key: ']', command: 'splitRight', does: 'Move the divider right' },
  { key: 'v', command: 'toggleDebug', does: 'Show the shadow volumes' },
  { key: 'g', command: 'toggleGround', does: 'Show or hide the ground' },
  { key: '1', command: 'sectionX', does: 'Cut the scene open along X, Y, Z' },
  { key: '2', command: 'sectionY' },
  { key: '3', command: 'sectionZ' },
  { key: '4', command: 'sectionFree', does: 'Cut it by a plane that faces you' },
  { key: '5', command: 'sectionBox', does: 'Cut it to a box' },
  { key: '6', command: 'sectionFlip', does: 'Keep the cut\'s other side' },
  { key: 'o', command: 'sectionShadows', does: 'What is cut away casts or not' },
  { key: 'z', command: 'sectionOff', does: 'Make the scene whole again' },
  { key: 'h', command: 'toggleLights', does: 'Show or hide the lights\' handles' },
  { key: 'x', command: 'nextAnimation', does: 'Next animation' },
  { key: ' ', command: 'togglePlaying', does: 'Play or pause' },
  { key: ',', command: 'slower', does: 'Slower' },
  { key: '.', command: 'faster', does: 'Faster' },
  { key: 'j', command: 'toggleDay', does: 'Play the day of a sun by place and time' },
  { key: 'y', command: 'toggleHours', does: 'Show the hours of sun of that day' },
  { key: '9', command: 'earlier', does: 'Ten minutes earlier' },
  { key: '0', command: 'later', does: 'Ten minutes later' },
  { key: '7', command: 'dayEarlier', does: 'A day earlier' },
  { key: '8', command: 'dayLater', does: 'A day later' },
];

const commandOfKey = new Map(keys.map(({ key, command }) => [key, command]));
commandOfKey.set('=', 'zoomIn').set('_', 'zoomOut').set('Backspace', 'removeLight');

function commandFor(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return undefined;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const shifted = event.shiftKey && event.key.startsWith('Arrow');
  return commandOfKey.get(shifted ? `Shift+${key}` : key);
}

/**
 * Listens on the canvas. `target` has pointer(phase, id, x, y, button, shift, control),
 * wheel(x, y, notches) and run(command).
 */
export function listenForGestures(canvas, target) {
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return [
      (event.clientX - box.left) * (canvas.width / box.width),
      (event.clientY - box.top) * (canvas.height / box.height),
    ];
  };
  const down = new Set();
  const onPointer = (event) => {
    const phase = phases[event.type];
    if (phase === 0) {
      down.add(event.pointerId);
      canvas.focus({ preventScroll: true });
      try {
        canvas.setPointerCapture(event.pointerId);
      } catch {
        // The pointer has already gone, or a script made it up.
      }
    }
    if (phase !== 0 && !down.has(event.pointerId) && event.pointerType !== 'mouse') return;
    if (phase === 2) down.delete(event.pointerId);
    target.pointer(phase, event.pointerId, ...place(event), event.button, event.shiftKey,
      event.ctrlKey || event.metaKey);
    event.preventDefault();
  };
  for (const type of Object.keys(phases)) canvas.addEventListener(type, onPointer);

  const onWheel = (event) => {
    if (!target.takesWheel(event)) return;
    const perNotch = event.deltaMode === 0 ? pixelsPerNotch : linesPerNotch;
    target.wheel(...place(event), -event.deltaY / perNotch);
    event.preventDefault();
  };
  canvas.addEventListener('wheel', onWheel, { passive: false });

  const onKey = (event) => {
    const command = commandFor(event);
    if (!command) return;
    target.run(command);
    event.preventDefault();
  };
  canvas.addEventListener('keydown', onKey);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
}
