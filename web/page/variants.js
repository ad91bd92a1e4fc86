// The menu of a scene's variants of materials (KHR_materials_variants), shown if it has any.

/** Shows or hides `section` after each load; its `menu` shows the current variant, '' for none. */
export function connectVariants(viewer, section, menu) {
  menu.addEventListener('change', () => chooseVariant(viewer, menu.value));
  viewer.addEventListener('load', ({ detail }) => {
    const chosen = viewer.getAttribute('variant') ?? '';
    menu.replaceChildren(new Option('The file\'s own', ''),
      ...detail.variants.map((name) => new Option(name, name)));
    menu.value = detail.variants.includes(chosen) ? chosen : '';
    section.hidden = detail.variants.length === 0;
  });
}

/** Shows this scene, or the next one, in this variant. */
export function chooseVariant(viewer, name) {
  if (name) viewer.setAttribute('variant', name);
  else viewer.removeAttribute('variant');
}
