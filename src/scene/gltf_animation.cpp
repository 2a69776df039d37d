#include "scene/gltf_animation.h"

#include <tiny_gltf.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "scene/gltf_document.h"

namespace luminist {
namespace {

const std::map<std::string, Track::Property> kProperties{{"translation", Track::Property::kTranslation},
                                                         {"rotation", Track::Property::kRotation},
                                                         {"scale", Track::Property::kScale}};
const std::map<std::string, Track::Interpolation> kInterpolations{{"", Track::Interpolation::kLinear},
                                                                  {"LINEAR", Track::Interpolation::kLinear},
                                                                  {"STEP", Track::Interpolation::kStep},
                                                                  {"CUBICSPLINE", Track::Interpolation::kCubic}};

class TrackReader {
 public:
  TrackReader(const tinygltf::Model& model, const std::vector<int>& place_of, const std::string& path,
              Diagnostics& diagnostics)
      : model_(&model), place_of_(&place_of), path_(path), diagnostics_(&diagnostics) {}

  Result<std::vector<Track>> read() {
    std::vector<Track> tracks;
    for (std::size_t a = 0; a < model_->animations.size(); ++a) {
      const tinygltf::Animation& animation = model_->animations[a];
      for (std::size_t c = 0; c < animation.channels.size(); ++c) {
        const std::string field = fmt::format("animations[{}].channels[{}]", a, c);
        LUM_TRY(std::optional<Track> track, read_channel(animation, animation.channels[c], field));
        if (track) tracks.push_back(std::move(*track));
      }
    }
    return tracks;
  }

 private:
  [[nodiscard]] Error bad(std::string what, std::string field) const {
    return {ErrorKind::kBadContent, std::move(what), path_, std::move(field), ""};
  }
  void warn(std::string what) { diagnostics_->warn(path_, std::move(what)); }

  Result<std::optional<Track>> read_channel(const tinygltf::Animation& animation,
                                            const tinygltf::AnimationChannel& channel, const std::string& field) {
    if (channel.target_node < 0) return std::optional<Track>();  // the format: such a channel is ignored
    if (static_cast<std::size_t>(channel.target_node) >= place_of_->size()) return bad("there is no such node", field);
    if (channel.target_path == "weights") return std::optional<Track>();
    const auto property = kProperties.find(channel.target_path);
    if (property == kProperties.end()) {
      warn(fmt::format("{} moves \"{}\", which stands still here", field, channel.target_path));
      return std::optional<Track>();
    }
    const int place = (*place_of_)[static_cast<std::size_t>(channel.target_node)];
    if (place < 0) return std::optional<Track>();
    if (!model_->nodes[static_cast<std::size_t>(channel.target_node)].matrix.empty()) {
      warn(field + " moves a node that is given as a matrix, and is left out");
      return std::optional<Track>();
    }
    if (!taken_.insert({place, property->second}).second) {
      warn(field + " moves what another clip moves already, and is left out");
      return std::optional<Track>();
    }
    if (channel.sampler < 0 || static_cast<std::size_t>(channel.sampler) >= animation.samplers.size()) {
      return bad("there is no such sampler", field);
    }
    Track track;
    track.node = place;
    track.property = property->second;
    LUM_TRY_VOID(read_keys(animation.samplers[static_cast<std::size_t>(channel.sampler)], field, track));
    return std::optional<Track>(std::move(track));
  }

  Result<void> read_keys(const tinygltf::AnimationSampler& sampler, const std::string& field, Track& track) const {
    LUM_TRY(track.interpolation, gltf_interpolation(sampler.interpolation, path_, field));
    LUM_TRY(track.times, gltf_times(*model_, sampler.input, path_, field + ".input"));
    const int components = track.property == Track::Property::kRotation ? 4 : 3;
    LUM_TRY(const std::vector<float> numbers,
            gltf_floats(*model_, sampler.output, components, path_, field + ".output"));
    const std::size_t wanted = track.times.size() * (track.interpolation == Track::Interpolation::kCubic ? 3 : 1);
    const auto stride = static_cast<std::size_t>(components);
    if (numbers.size() != wanted * stride) {
      return bad(fmt::format("{} values for {} keys", numbers.size() / stride, track.times.size()), field + ".output");
    }
    for (std::size_t i = 0; i < wanted; ++i) {
      Vec4 value(0.0F);
      for (std::size_t k = 0; k < stride; ++k) value[static_cast<int>(k)] = numbers[i * stride + k];
      if (!std::isfinite(glm::dot(value, value))) return bad("a value is not finite", field + ".output");
      track.values.push_back(value);
    }
    return {};
  }

  const tinygltf::Model* model_;
  const std::vector<int>* place_of_;
  std::string path_;
  Diagnostics* diagnostics_;
  std::set<std::pair<int, Track::Property>> taken_;
};

}  // namespace

Result<Track::Interpolation> gltf_interpolation(const std::string& word, const std::string& path,
                                                const std::string& field) {
  const auto interpolation = kInterpolations.find(word);
  if (interpolation != kInterpolations.end()) return interpolation->second;
  return Error{ErrorKind::kBadContent, fmt::format("unknown interpolation \"{}\"", word), path, field, ""};
}

Result<std::vector<float>> gltf_times(const tinygltf::Model& model, int accessor, const std::string& path,
                                      const std::string& field) {
  const auto bad = [&](const char* what) { return Error{ErrorKind::kBadContent, what, path, field, ""}; };
  LUM_TRY(std::vector<float> times, gltf_floats(model, accessor, 1, path, field));
  if (times.empty()) return bad("an animation needs a key");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i])) return bad("a time is not finite");
    if (i > 0 && !(times[i] > times[i - 1])) return bad("times must ascend");
  }
  return times;
}

Result<std::vector<Track>> gltf_tracks(const tinygltf::Model& model, const std::vector<int>& place_of,
                                       const std::string& path, Diagnostics& diagnostics) {
  return TrackReader(model, place_of, path, diagnostics).read();
}

}  // namespace luminist
