// The panel's controls of the section that cuts the scene open.

const $ = (id) => document.getElementById(id);
const commands = { x: 'sectionX', y: 'sectionY', z: 'sectionZ', free: 'sectionFree', box: 'sectionBox' };
const axes = ['x', 'y', 'z'];

/** The menu's word for a section: off, x, y, z, free or box. */
export function kindOfSection(section) {
  if (!section) return 'off';
  if (section.planes.length > 1) return 'box';
  const used = axes.filter((_, axis) => section.planes[0][axis] !== 0);
  return used.length === 1 ? used[0] : 'free';
}

/** Connects the controls. Returns refresh(state). */
export function connectSection(viewer) {
  const [kind, fill] = [$('section'), $('section-fill')];
  kind.addEventListener('change', () => {
    viewer.change({ section: kind.value === 'off' ? null : viewer.state.section });
    const shown = kindOfSection(viewer.state.section);
    if (kind.value !== shown) viewer.run(commands[kind.value]);
  });
  $('section-flip').addEventListener('click', () => viewer.run('sectionFlip'));
  $('section-whole').addEventListener('change', () => viewer.run('sectionShadows'));
  const chooseFill = () => viewer.change({ section: { ...viewer.state.section,
    fill: $('section-filled').checked ? fill.value : 'none' } });
  $('section-filled').addEventListener('change', chooseFill);
  fill.addEventListener('input', chooseFill);
  return ({ section }) => {
    kind.value = kindOfSection(section);
    $('section-how').hidden = !section;
    if (!section) return;
    $('section-flip').disabled = section.planes.length > 1;
    $('section-whole').checked = section.shadows === 'whole';
    $('section-filled').checked = section.fill !== 'none';
    fill.hidden = section.fill === 'none';
    if (section.fill !== 'none') fill.value = section.fill;
  };
}
