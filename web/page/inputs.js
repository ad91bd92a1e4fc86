// What the panel is made of.

/** A slider with its value beside it in words. Returns show(value). */
export function slider(id, words, onInput) {
  const input = document.getElementById(id);
  const output = input.parentElement.querySelector('output');
  input.addEventListener('input', () => onInput(Number(input.value)));
  return (value) => {
    if (document.activeElement !== input || Math.abs(Number(input.value) - value) > 1)
      input.value = String(value);
    output.textContent = words(value);
    input.setAttribute('aria-valuetext', words(value));
  };
}

/** A box. Returns show(on). */
export function check(id, onChange) {
  const input = document.getElementById(id);
  input.addEventListener('change', () => onChange(input.checked));
  return (value) => { input.checked = value; };
}

/** Shows a value in a menu, which need not have had it. */
export function choose(select, value, words) {
  if (![...select.options].some((option) => option.value === value)) select.append(new Option(words, value));
  select.value = value;
}
