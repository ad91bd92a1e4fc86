// The theme: light, dark, or as the system says. Runs before the page is shown, so that it never flashes.

(() => {
  const choices = ['auto', 'light', 'dark'];
  const stored = () => { try { return localStorage.getItem('theme'); } catch { return null; } };
  const store = (choice) => { try { localStorage.setItem('theme', choice); } catch { /* private windows keep none */ } };
  let choice = choices.includes(stored()) ? stored() : 'auto';
  const show = () => {
    const root = document.documentElement;
    if (choice === 'auto') delete root.dataset.theme;
    else root.dataset.theme = choice;
    const name = document.getElementById('theme-name');
    if (name) name.textContent = choice[0].toUpperCase() + choice.slice(1);
  };
  show();
  addEventListener('DOMContentLoaded', () => {
    show();
    document.getElementById('theme').addEventListener('click', () => {
      choice = choices[(choices.indexOf(choice) + 1) % choices.length];
      store(choice);
      show();
    });
  });
})();
