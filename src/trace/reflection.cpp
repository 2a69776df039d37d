#include "trace/reflection.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

Vec3 fresnel(const Reflection& surface, float cosine) {
  const float rest = std::clamp(1.0F - cosine, 0.0F, 1.0F);
  const float rest5 = rest * rest * rest * rest * rest;
  return glm::min(surface.factor * (surface.specular + (1.0F - surface.specular) * rest5), Vec3(1.0F));
}

float distribution(float alpha2, float nh) {
  const float lobe = nh * nh * (alpha2 - 1.0F) + 1.0F;
  return alpha2 / (kPiF * std::max(lobe * lobe, 1e-12F));
}

/// 2 nv / (nv + sqrt(..)): the share of visible normals that nothing masks.
float unmasked(float alpha2, float nv) {
  return 2.0F * nv / (nv + std::sqrt(nv * nv * (1.0F - alpha2) + alpha2));
}

float eye_cosine(const Reflection& surface) {
  return std::max(glm::dot(surface.normal, surface.to_eye), 1e-3F);
}

/// A visible micro normal in the frame of the surface, seen from `eye` (unit, z > 0).
Vec3 visible_normal(const Vec3& eye, float alpha, const Vec2& place) {
  const Vec3 stretched = glm::normalize(Vec3(alpha * eye.x, alpha * eye.y, eye.z));
  const float across = stretched.x * stretched.x + stretched.y * stretched.y;
  const Vec3 t1 = across > 1e-12F ? Vec3(-stretched.y, stretched.x, 0.0F) / std::sqrt(across) : Vec3(1.0F, 0.0F, 0.0F);
  const Vec3 t2 = glm::cross(stretched, t1);
  const float radius = std::sqrt(place.x);
  const float angle = 2.0F * kPiF * place.y;
  const float x = radius * std::cos(angle);
  const float half = 0.5F * (1.0F + stretched.z);
  const float y = (1.0F - half) * std::sqrt(std::max(0.0F, 1.0F - x * x)) + half * radius * std::sin(angle);
  const Vec3 normal = x * t1 + y * t2 + std::sqrt(std::max(0.0F, 1.0F - x * x - y * y)) * stretched;
  return glm::normalize(Vec3(alpha * normal.x, alpha * normal.y, std::max(normal.z, 1e-6F)));
}

Vec3 diffuse_direction(const Vec3& normal, const Vec2& place) {
  Vec3 t;
  Vec3 b;
  tangent_frame(normal, t, b);
  const float radius = std::sqrt(place.x);
  const float angle = 2.0F * kPiF * place.y;
  return glm::normalize(radius * std::cos(angle) * t + radius * std::sin(angle) * b +
                        std::sqrt(std::max(0.0F, 1.0F - place.x)) * normal);
}

}  // namespace

Reflection Reflection::create(const SurfacePoint& point, const Vec3& to_eye, float factor) {
  Reflection surface;
  surface.normal = point.normal;
  surface.to_eye = to_eye;
  surface.albedo = point.albedo;
  surface.specular = point.specular;
  surface.factor = std::max(factor, 0.0F);
  const Vec3 shiny = fresnel(surface, eye_cosine(surface));
  if (point.roughness < kMirror) {
    surface.alpha = 0.0F;
    surface.albedo *= 1.0F - shiny;  // a mirror's F depends on the eye alone
  } else {
    surface.alpha = std::max(point.roughness * point.roughness, kLeastAlpha);
  }
  const float diffuse = largest(surface.albedo);
  const float all = diffuse + largest(shiny);
  surface.diffuse_share = all > 0.0F ? diffuse / all : 1.0F;
  return surface;
}

bool Reflection::scatters() const {
  return largest(albedo) > 0.0F || (!mirrors() && diffuse_share < 1.0F);
}

Scattered evaluate(const Reflection& surface, const Vec3& to_light) {
  const float nl = glm::dot(surface.normal, to_light);
  if (!(nl > 0.0F)) return {};
  const float diffuse_pdf = surface.diffuse_share * nl / kPiF;
  if (surface.mirrors() || surface.diffuse_share == 1.0F) {
    return {surface.albedo * (nl / kPiF), diffuse_pdf};
  }
  const float nv = eye_cosine(surface);
  const Vec3 sum = surface.to_eye + to_light;
  const float length = glm::length(sum);
  if (!(length > 1e-6F)) return {surface.albedo * (nl / kPiF), diffuse_pdf};
  const Vec3 h = sum / length;
  const float alpha2 = surface.alpha * surface.alpha;
  const float nh = std::clamp(glm::dot(surface.normal, h), 0.0F, 1.0F);
  const float hl = std::max(glm::dot(h, to_light), 0.0F);
  const Vec3 f = fresnel(surface, hl);
  const float d = distribution(alpha2, nh);
  const float masking =
      nl * std::sqrt(nv * nv * (1.0F - alpha2) + alpha2) + nv * std::sqrt(nl * nl * (1.0F - alpha2) + alpha2);
  const Vec3 value = (1.0F - f) * surface.albedo / kPiF + f * (d * 0.5F / std::max(masking, 1e-6F));
  const float shiny_pdf = unmasked(alpha2, nv) * d / (4.0F * nv);
  return {value * nl, diffuse_pdf + (1.0F - surface.diffuse_share) * shiny_pdf};
}

Bounce sample(const Reflection& surface, float lobe, const Vec2& place) {
  const bool diffuse = lobe < surface.diffuse_share;
  Bounce bounce;
  if (!diffuse && surface.mirrors()) {
    const float nv = eye_cosine(surface);
    bounce.direction =
        glm::normalize(2.0F * glm::dot(surface.normal, surface.to_eye) * surface.normal - surface.to_eye);
    bounce.weight = fresnel(surface, nv) / (1.0F - surface.diffuse_share);
    return bounce;
  }
  if (diffuse) {
    bounce.direction = diffuse_direction(surface.normal, place);
  } else {
    Vec3 t;
    Vec3 b;
    tangent_frame(surface.normal, t, b);
    const Vec3 eye(glm::dot(surface.to_eye, t), glm::dot(surface.to_eye, b), eye_cosine(surface));
    const Vec3 local = visible_normal(eye, surface.alpha, place);
    const Vec3 h = local.x * t + local.y * b + local.z * surface.normal;
    bounce.direction = glm::normalize(2.0F * glm::dot(h, surface.to_eye) * h - surface.to_eye);
  }
  const Scattered scattered = evaluate(surface, bounce.direction);
  if (!(scattered.pdf > 0.0F)) return {};
  bounce.pdf = scattered.pdf;
  bounce.weight = scattered.value / scattered.pdf;
  return bounce;
}

}  // namespace luminist
