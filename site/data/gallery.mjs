// The gallery's pages: each shows a scene and the code that draws it. `test`: the file of web/tests that checks
// what the page shows.

const pages = [
  { name: 'product', title: 'Product', test: 'three.test.mjs',
    words: 'A chair turns under a sun. Shadows of slats begin where the slats stand, at any zoom, without a bias to tune.' },
  { name: 'room', title: 'Room', test: 'three_meshes.test.mjs',
    words: 'Sun falls through a window with bars. The light rests, so its shadows are looked up: drawing costs no mask.' },
  { name: 'house', title: 'House cut open', test: 'three_clipping.test.mjs',
    words: 'A plane cuts the house and its shadow. Move the slider: without the roof, the sun shines into the rooms.' },
  { name: 'street', title: 'Street', test: 'three_building.test.mjs',
    words: 'Long shadows of an evening: thin railings and lamp posts keep them over the whole street.' },
  { name: 'forest', title: 'Forest of instances', test: 'three.test.mjs',
    words: 'Hundreds of trees are two instanced meshes. Each tree shades its neighbours.' },
  { name: 'character', title: 'Character', test: 'three_movers.test.mjs',
    words: 'A figure with a skeleton walks. The rest of the scene stays looked up; the figure is counted on top.' },
  { name: 'stained-glass', title: 'Stained glass', test: 'three_tints.test.mjs',
    words: 'Each pane lets its own colour through. Where panes overlap on the way to the sun, colours multiply.' },
  { name: 'leaves', title: 'Leaves', test: 'three_cutouts.test.mjs',
    words: 'Leaves are holes in a texture. Their shadow has the same holes, texel for texel.' },
  { name: 'soft-lamp', title: 'Soft lamp', test: 'three_alpha.test.mjs',
    words: 'A lamp with a radius. Move the slider: 24 points of the lamp are counted for each pixel.' },
  { name: 'many-lights', title: 'Many lights', test: 'three_lookup.test.mjs',
    words: 'Six spots: four rest and are looked up, two move and have masks.' },
  { name: 'city-hours', title: 'City hours', language: 'html', test: 'sun_hours.test.mjs',
    words: 'A city by its hours of sun on 21 March. Point at a roof or a street to read them.' },
  { name: 'own-file', title: 'Own file', language: 'html', test: 'files.test.mjs',
    words: 'Choose or drop a glTF file. It is read in the page, and goes to no server.' },
];

export default pages.map((page) => ({ language: 'js', ...page, file: `gallery/${page.name}.${page.language ?? 'js'}` }));
