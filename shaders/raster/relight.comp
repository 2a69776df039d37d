// raster/relight.comp -- shade() for every sample of every candidate. An invocation takes one sample through a run of
// neighbouring candidates: fetching the surface costs as much as shading it.
void main() {
  uint index = linear_index();
  uint first = index / lum_frame.padded * lum_frame.run;
  uint last = min(first + lum_frame.run, lum_frame.candidates);
  lum_sample = lum_frame.first + index % lum_frame.padded;
  if (lum_sample >= lum_frame.samples || first >= last) return;

  Surface surface = lum_surface(lum_frame.indexed != 0u ? lum_entries[lum_sample] : lum_sample);
  for (uint candidate = first; candidate < last; ++candidate) {
    lum_load_candidate(candidate);
    Surface s = lum_turn(surface);
    if (lum_candidate.z == LUM_NONE) s.emissive = vec3(0.0);
    vec3 color = s.object == 0u ? lum_background() : lum_shade(s);
    if (lum_frame.layered != 0u) color += lum_layer[lum_sample].rgb;
    lum_colors[candidate * lum_frame.samples + lum_sample] = vec4(color, 1.0);
  }
}
