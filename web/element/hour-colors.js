/**
 * Colour scale of the hours of sunlight, from none to all: every eighth of
 * src/plot/color_scale.cpp.
 */
export const hourColors = ['#0e1552', '#312d5c', '#544464', '#765b6a', '#96736f', '#b58e72', '#d2ac72',
  '#ebcc70', '#ffee69'];
