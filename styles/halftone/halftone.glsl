// Printed dots. All lights together make a tone, and the tone the size of the dots; the screens lie on the picture, so
// that there are as many dots on a line from near as from afar.

const float kLevels = 1.0;  // of light that leaves the paper white

// Share of a cell that is inked at a place of a screen: round dots up to half of the cell, round gaps from there on,
// each as large as the tone says. `blur` is the width of a pixel in cells.
float dots(vec2 place, float ink, float blur) {
  vec2 centre = abs(fract(place) - 0.5);  // from the dot
  vec2 corner = 0.5 - centre;             // from the gap
  bool gaps = ink > 0.5;
  float radius = sqrt(max(gaps ? 1.0 - ink : ink, 0.0) / 3.14159265);
  float inside = radius - (gaps ? length(corner) : length(centre));
  float covered = saturate(0.5 + inside / max(blur, 1e-4));
  covered *= saturate(radius / max(0.5 * blur, 1e-4));  // a dot smaller than a pixel fades
  return gaps ? 1.0 - covered : covered;
}

float screened(vec2 place, float degrees, float ink) {
  float angle = radians(degrees);
  mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
  float covered = dots(turn * place * style.frequency, ink, pixel_size() * style.frequency);
  return mix(covered, ink, pattern_fade());
}

vec3 shade(Surface s) {
  vec3 tone = s.emissive + diffuse_light(s) * mix(vec3(1.0), s.albedo, style.albedo);
  tone = pow(clamp(tone / kLevels, vec3(0.0), vec3(1.0)), vec3(max(style.contrast, 0.05)));
  if (style.inks == 0) {
    float ink = screened(s.screen, style.angle, 1.0 - luminance(tone));
    return mix(style.paper, style.ink, ink);
  }
  // Cyan, magenta and yellow take red, green and blue; their screens lie thirty degrees apart against moire.
  vec3 inks = 1.0 - tone;
  vec3 passed = 1.0 - vec3(screened(s.screen, style.angle - 30.0, inks.r), screened(s.screen, style.angle + 30.0, inks.g),
                           screened(s.screen, style.angle - 45.0, inks.b));
  return style.paper * passed;
}
