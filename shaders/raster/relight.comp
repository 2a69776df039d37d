// raster/relight.comp -- shade() for every sample of every candidate. A work group belongs to one candidate.
void main() {
  uint index = linear_index();
  uint candidate = index / lum_frame.padded;
  lum_sample = index % lum_frame.padded;
  if (lum_sample >= lum_frame.samples || candidate >= lum_frame.candidates) return;
  lum_candidate = lum_candidates[candidate];
  lum_load_blocks();

  uint entry = lum_frame.indexed != 0u ? lum_entries[lum_sample] : lum_sample;
  Surface s = lum_surface(entry);
  vec3 color = s.object == 0u ? vec3(0.0) : shade(s);
  lum_colors[candidate * lum_frame.samples + lum_sample] = vec4(color, 1.0);
}
