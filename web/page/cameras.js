// The menu of a scene's cameras, shown if it has any. The view moves there and stays free.

/** Shows or hides `section` after each load; choosing from its `menu` moves the viewer's camera. */
export function connectCameras(viewer, section, menu) {
  let cameras = [];
  menu.addEventListener('change', () => {
    if (menu.value !== '') viewer.change({ camera: cameras[Number(menu.value)].camera });
  });
  viewer.addEventListener('load', ({ detail }) => {
    cameras = detail.cameras;
    menu.replaceChildren(new Option('Free', ''),
      ...cameras.map(({ name }, index) => new Option(name, String(index))));
    section.hidden = cameras.length === 0;
  });
  // Once somebody moves it, the view matches no camera of the file.
  viewer.addEventListener('change', () => {
    const chosen = cameras[Number(menu.value)];
    if (menu.value !== '' && !isSame(viewer.state?.camera, chosen?.camera)) menu.value = '';
  });
}

const isSame = (a, b) =>
  Boolean(a && b) && [...a.from, ...a.to, a.fov].every((n, i) => n === [...b.from, ...b.to, b.fov][i]);
