// The panel's inputs.

/** A slider with its value in words beside it. Returns show(value). */
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

/** A checkbox. Returns show(on). */
export function check(id, onChange) {
  const input = document.getElementById(id);
  input.addEventListener('change', () => onChange(input.checked));
  return (value) => { input.checked = value; };
}

/** Shows a value in a menu, and adds it if it is missing. */
export function choose(select, value, words) {
  if (![...select.options].some((option) => option.value === value)) select.append(new Option(words, value));
  select.value = value;
}
