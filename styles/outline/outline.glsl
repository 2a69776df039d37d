// Lines of one colour. The share in alpha is multiplied with what the style below makes of the light there.
vec4 ink(Surface s) { return vec4(style.line_color, style.line_lit); }
