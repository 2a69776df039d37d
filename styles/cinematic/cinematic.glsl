// The light of computer cinematography: Lambert and GGX, in the convention that a white diffuser facing a light shows
// the light's colour (so the usual reflectances are multiplied by pi).

// pi * D * V * F for GGX with Smith's height-correlated masking and Schlick's Fresnel term.
vec3 highlight(Surface s, vec3 to_light) {
  float alpha = max(s.roughness * s.roughness, 0.01);
  float alpha2 = alpha * alpha;
  vec3 h = safe_normalize(s.view + to_light, s.normal);
  float nh = saturate(dot(s.normal, h));
  float nl = saturate(dot(s.normal, to_light));
  float nv = max(dot(s.normal, s.view), 1e-3);
  float lobe = nh * nh * (alpha2 - 1.0) + 1.0;
  float distribution = alpha2 / max(lobe * lobe, 1e-12);
  float masking = nl * sqrt(nv * nv * (1.0 - alpha2) + alpha2) + nv * sqrt(nl * nl * (1.0 - alpha2) + alpha2);
  float fresnel = 1.0 - saturate(dot(h, to_light));
  fresnel *= fresnel * fresnel * fresnel * fresnel;
  return (s.specular + (1.0 - s.specular) * fresnel) * (distribution * 0.5 / max(masking, kTiny));
}

vec3 shade(Surface s) {
  vec3 sum = s.emissive + ambient() * (s.albedo + style.specular * s.specular);
  for (int i = 0; i < light_count(); ++i) {
    LightSample l = light(i, s);
    float nl = dot(s.normal, l.direction);
    if (nl <= 0.0) continue;
    sum += (s.albedo + style.specular * highlight(s, l.direction)) * l.color * (nl * l.visibility);
  }
  return sum;
}
