#include "app/channels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/metric.h"
#include "studio/heat_map.h"

namespace luminist {
namespace {

constexpr std::array<ChannelFacts, kChannels> kChannelFacts = {{
    {"Light", "What the lights make of it. Strokes that no solve has answered yet lie over it."},
    {"Paint", "What you painted: the picture that the solver is after."},
    {"Residual", "Where light and paint differ, as much as it counts. Black: not at all."},
    {"Importance", "How much each pixel counts for the solver. Black counts most, white nothing."},
    {"Importance", "How much each pixel counts, with the picture faintly in it."},
    {"Albedo", "The colour of the surfaces, without light."},
    {"Normal", "Which way the surfaces face."},
    {"Distance", "How far the surfaces are from the eye: near is bright."},
    {"Objects", "A colour for each object: what a stroke can be clipped to."},
}};

/// The picture at the shot's size; while the brush moves it may be made smaller.
Image full_picture(const StudioSnapshot& snapshot) {
  const Image& size = snapshot.painted->color;
  const Image& picture = *snapshot.picture;
  return picture.same_size(size) ? picture : resized(picture, size.width, size.height);
}

Image light_image(const StudioSnapshot& snapshot) {
  Image image = full_picture(snapshot);
  const PaintedPictures& painted = *snapshot.painted;
  if (snapshot.unanswered == 0) return image;
  for (std::size_t i = 0; i < painted.stroke.size(); ++i) {
    if (painted.stroke[i] >= snapshot.unanswered) image.set_rgb(i, painted.color.rgb(i));
  }
  return image;
}

Image residual_image(const StudioSnapshot& snapshot) {
  const PaintedPictures& painted = *snapshot.painted;
  Target target;
  target.color = painted.color;
  target.importance = painted.importance;
  const Image residual = residual_map(full_picture(snapshot), target);
  constexpr float kLeastWhite = 0.02F;  // a picture that is nearly met does not look like a fire
  return heat_map(residual, std::max(kLeastWhite, quantile(residual, 0.995)));
}

Image importance_image(const StudioSnapshot& snapshot) {
  Image image = snapshot.painted->importance;
  for (float& value : image.data) value = 1.0F - std::clamp(value, 0.0F, 1.0F);
  return image;
}

Image weighed_image(const StudioSnapshot& snapshot) {
  constexpr float kPicture = 0.3F;
  Image image = importance_image(snapshot);
  const Image picture = full_picture(snapshot);
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const float grey = srgb_from_linear(glm::dot(picture.rgb(i), Vec3(0.2126F, 0.7152F, 0.0722F)));
    image.data[i] = (1.0F - kPicture) * image.data[i] + kPicture * grey;
  }
  return image;
}

Image normal_image(const SurfaceBuffer& surface) {
  Image image(surface.width, surface.height, 3);
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] != 0) image.set_rgb(i, 0.5F * surface.normal[i] + Vec3(0.5F));
  }
  return image;
}

Image distance_image(const SurfaceBuffer& surface) {
  Image image(surface.width, surface.height, 1);
  float least = std::numeric_limits<float>::infinity();
  float most = 0.0F;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] == 0) continue;
    image.data[i] = glm::length(surface.position[i] - surface.eye);
    least = std::min(least, image.data[i]);
    most = std::max(most, image.data[i]);
  }
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] == 0) continue;
    image.data[i] = 1.0F - 0.9F * (image.data[i] - least) / std::max(most - least, 1e-6F);
  }
  return image;
}

/// Hues that are far apart for neighbours in the list: steps of the golden angle.
Vec3 object_color(std::uint32_t object) {
  const float turn = static_cast<float>(object) * 2.39996F;
  return Vec3(0.5F) + 0.28F * Vec3(std::cos(turn), std::cos(turn - 2.0944F), std::cos(turn + 2.0944F));
}

Image object_image(const SurfaceBuffer& surface) {
  Image image(surface.width, surface.height, 3);
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] != 0) image.set_rgb(i, object_color(surface.object[i]));
  }
  return image;
}

Image albedo_image(const SurfaceBuffer& surface) {
  Image image(surface.width, surface.height, 3);
  for (std::size_t i = 0; i < surface.pixels(); ++i) image.set_rgb(i, surface.albedo[i]);
  return image;
}

}  // namespace

const ChannelFacts& facts_of(Channel channel) {
  return kChannelFacts[static_cast<std::size_t>(channel)];
}

DisplayOptions display_of(Channel channel, const DisplayOptions& light) {
  switch (channel) {
    case Channel::kLight:
    case Channel::kPaint:
      return light;
    case Channel::kResidual:
    case Channel::kAlbedo:
      return {};
    default:
      return {0.0F, ViewTransform::kRaw};
  }
}

Image channel_image(const StudioSnapshot& snapshot, Channel channel) {
  const SurfaceBuffer& surface = snapshot.facts->surface;
  switch (channel) {
    case Channel::kLight:
      return light_image(snapshot);
    case Channel::kPaint:
      return snapshot.painted->color;
    case Channel::kResidual:
      return residual_image(snapshot);
    case Channel::kImportance:
      return importance_image(snapshot);
    case Channel::kWeighed:
      return weighed_image(snapshot);
    case Channel::kAlbedo:
      return albedo_image(surface);
    case Channel::kNormal:
      return normal_image(surface);
    case Channel::kDistance:
      return distance_image(surface);
    case Channel::kObjects:
      return object_image(surface);
  }
  return {};
}

}  // namespace luminist
