// The dialog that lists the keys.

const names = { ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓', ' ': 'Space',
  'Shift+ArrowLeft': 'Shift ←', 'Shift+ArrowRight': '→', 'Shift+ArrowUp': '↑', 'Shift+ArrowDown': '↓' };

export function connectKeyHelp(dialog, list, openButton, keys) {
  let row = null;
  for (const { key, does } of keys) {
    if (does) {
      row = document.createElement('div');
      const dt = document.createElement('dt');
      dt.textContent = does;
      row.append(dt, document.createElement('dd'));
      list.append(row);
    }
    const kbd = document.createElement('kbd');
    kbd.textContent = names[key] ?? (key.length === 1 ? key.toUpperCase() : key);
    row.querySelector('dd').append(kbd, ' ');
  }
  openButton.addEventListener('click', () => dialog.showModal());
  addEventListener('keydown', (event) => {
    if (event.key === '?' && !dialog.open && !event.target.closest?.('input, select')) dialog.showModal();
  });
}
