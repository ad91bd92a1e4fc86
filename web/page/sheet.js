// On a phone the panel is a sheet at the bottom, folded until it is opened.

const narrow = matchMedia('(max-width: 720px)');

export function connectSheet(panel, button) {
  const fold = (folded) => {
    panel.classList.toggle('folded', folded);
    button.setAttribute('aria-expanded', String(!folded));
    button.textContent = folded ? 'Controls' : 'Hide';
  };
  fold(narrow.matches);
  narrow.addEventListener('change', () => fold(narrow.matches));
  button.addEventListener('click', () => fold(!panel.classList.contains('folded')));
  panel.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && narrow.matches) fold(true);
  });
}
