#include "scene/gltf_deform.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "scene/gltf_animation.h"
#include "scene/gltf_document.h"

namespace luminist {
namespace {

/// Reads one deformer.
class DeformerReader {
 public:
  DeformerReader(const tinygltf::Model& model, std::size_t vertices, const std::string& path)
      : model_(&model), vertices_(vertices), path_(path) {}

  [[nodiscard]] Error bad(std::string what, std::string field) const {
    return {ErrorKind::kBadContent, std::move(what), path_, std::move(field), ""};
  }

  /// [vertices], or empty if the accessor is not there.
  [[nodiscard]] Result<std::vector<Vec3>> vectors(const std::map<std::string, int>& attributes, const std::string& name,
                                                  const std::string& field) const {
    const auto found = attributes.find(name);
    if (found == attributes.end()) return std::vector<Vec3>();
    LUM_TRY(const std::vector<float> numbers, floats(found->second, 3, vertices_, field + "." + name));
    std::vector<Vec3> result(vertices_);
    for (std::size_t i = 0; i < numbers.size(); ++i) result[i / 3][static_cast<int>(i % 3)] = numbers[i];
    return result;
  }

  /// Whether more values than are wanted are a fault: a file may share the matrices of a larger skin.
  enum class Count { kExactly, kAtLeast };
  [[nodiscard]] Result<std::vector<float>> floats(int accessor, int components, std::size_t count,
                                                  const std::string& field, Count wanted = Count::kExactly) const {
    LUM_TRY(std::vector<float> numbers, gltf_floats(*model_, accessor, components, path_, field));
    const auto stride = static_cast<std::size_t>(components);
    const bool spare = wanted == Count::kAtLeast && numbers.size() > count * stride;
    if (numbers.size() != count * stride && !spare) {
      return bad(fmt::format("{} values where {} are wanted", numbers.size() / stride, count), field);
    }
    if (!std::all_of(numbers.begin(), numbers.end(), [](float v) { return std::isfinite(v); })) {
      return bad("a value is not finite", field);
    }
    return numbers;
  }

  Result<void> read_joints(const tinygltf::Primitive& primitive, int skin_index, const std::string& field,
                           Deformer& deformer) const {
    const tinygltf::Skin& skin = model_->skins[static_cast<std::size_t>(skin_index)];
    const std::string skin_field = fmt::format("skins[{}]", skin_index);
    if (skin.joints.empty()) return bad("a skin needs joints", skin_field);
    for (const int joint : skin.joints) {
      if (!inside(joint, model_->nodes.size())) return bad("there is no such node", skin_field + ".joints");
    }
    deformer.joints = skin.joints;
    deformer.joint_from_mesh.assign(skin.joints.size(), Mat4(1.0F));
    if (skin.inverseBindMatrices >= 0) {
      const std::string binds = skin_field + ".inverseBindMatrices";
      LUM_TRY(const std::vector<float> numbers,
              floats(skin.inverseBindMatrices, 16, skin.joints.size(), binds, Count::kAtLeast));
      for (std::size_t i = 0; i < 16 * skin.joints.size(); ++i) {
        deformer.joint_from_mesh[i / 16][static_cast<int>(i % 16 / 4)][static_cast<int>(i % 4)] = numbers[i];
      }
    }
    const auto joints = primitive.attributes.find("JOINTS_0");
    const auto weights = primitive.attributes.find("WEIGHTS_0");
    if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) {
      return bad("a skinned mesh needs JOINTS_0 and WEIGHTS_0", field);
    }
    LUM_TRY(const std::vector<float> places, floats(joints->second, 4, vertices_, field + ".JOINTS_0"));
    LUM_TRY(const std::vector<float> shares, floats(weights->second, 4, vertices_, field + ".WEIGHTS_0"));
    for (std::size_t i = 0; i < vertices_; ++i)
      LUM_TRY_VOID(add_vertex(&places[4 * i], &shares[4 * i], field, deformer));
    return {};
  }

 private:
  Result<void> add_vertex(const float* places, const float* shares, const std::string& field,
                          Deformer& deformer) const {
    std::array<std::uint16_t, 4> joints{};
    Vec4 weights(0.0F);
    float sum = 0.0F;
    for (int k = 0; k < 4; ++k) {
      if (!(places[k] >= 0.0F && places[k] < static_cast<float>(deformer.joints.size()))) {
        if (shares[k] == 0.0F) continue;
        return bad("a vertex names a joint that the skin lacks", field + ".JOINTS_0");
      }
      joints[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(places[k]);
      weights[k] = std::max(shares[k], 0.0F);
      sum += weights[k];
    }
    deformer.vertex_joints.push_back(joints);
    deformer.vertex_weights.push_back(sum > 0.0F ? weights / sum : Vec4(1.0F, 0.0F, 0.0F, 0.0F));
    return {};
  }

  const tinygltf::Model* model_;
  std::size_t vertices_;
  std::string path_;
};

/// How many targets the mesh of a node has.
std::size_t target_count(const tinygltf::Model& model, int node) {
  const int mesh = model.nodes[static_cast<std::size_t>(node)].mesh;
  if (!inside(mesh, model.meshes.size())) return 0;
  const auto& primitives = model.meshes[static_cast<std::size_t>(mesh)].primitives;
  return primitives.empty() ? 0 : primitives.front().targets.size();
}

Result<WeightTrack> read_weights(const tinygltf::Model& model, const tinygltf::Animation& animation, int sampler_index,
                                 std::size_t targets, const std::string& path, const std::string& field) {
  const DeformerReader reader(model, 0, path);
  if (!inside(sampler_index, animation.samplers.size())) return reader.bad("there is no such sampler", field);
  const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(sampler_index)];
  WeightTrack track;
  LUM_TRY(track.interpolation, gltf_interpolation(sampler.interpolation, path, field));
  LUM_TRY(track.times, gltf_times(model, sampler.input, path, field + ".input"));
  const std::size_t values = track.interpolation == Track::Interpolation::kCubic ? 3 : 1;
  LUM_TRY(track.values, reader.floats(sampler.output, 1, track.times.size() * targets * values, field + ".output"));
  return track;
}

}  // namespace

bool gltf_deforms(const tinygltf::Model& model, const tinygltf::Node& node, const tinygltf::Primitive& primitive) {
  return !primitive.targets.empty() || inside(node.skin, model.skins.size());
}

Result<Deformer> gltf_deformer(const tinygltf::Model& model, const tinygltf::Node& node,
                               const tinygltf::Primitive& primitive, const Mesh& mesh, const std::string& path,
                               const std::string& field, Diagnostics& diagnostics) {
  const DeformerReader reader(model, mesh.positions.size(), path);
  Deformer deformer;
  deformer.positions = mesh.positions;
  for (std::size_t k = 0; k < primitive.targets.size(); ++k) {
    const std::string target_field = fmt::format("{}.targets[{}]", field, k);
    MorphTarget target;
    LUM_TRY(target.positions, reader.vectors(primitive.targets[k], "POSITION", target_field));
    LUM_TRY(target.normals, reader.vectors(primitive.targets[k], "NORMAL", target_field));
    deformer.targets.push_back(std::move(target));
  }
  const std::vector<double>& wanted =
      !node.weights.empty() ? node.weights : model.meshes[static_cast<std::size_t>(node.mesh)].weights;
  deformer.weights.assign(primitive.targets.size(), 0.0F);
  for (std::size_t k = 0; k < std::min(wanted.size(), deformer.weights.size()); ++k) {
    deformer.weights[k] = std::isfinite(wanted[k]) ? static_cast<float>(std::clamp(wanted[k], -1e6, 1e6)) : 0.0F;
  }
  if (primitive.attributes.count("JOINTS_1") > 0) {
    diagnostics.warn(path, field + " hangs from more than four joints a vertex; the first four move it");
  }
  if (inside(node.skin, model.skins.size())) LUM_TRY_VOID(reader.read_joints(primitive, node.skin, field, deformer));
  return deformer;
}

bool place_joints(Deformer& deformer, const std::vector<int>& place_of) {
  for (int& joint : deformer.joints) {
    joint = place_of[static_cast<std::size_t>(joint)];
    if (joint < 0) return false;
  }
  return true;
}

Result<std::vector<WeightTrack>> gltf_weight_tracks(const tinygltf::Model& model, const std::vector<int>& place_of,
                                                    const std::string& path, Diagnostics& diagnostics) {
  std::vector<WeightTrack> tracks;
  std::set<int> taken;
  for (std::size_t a = 0; a < model.animations.size(); ++a) {
    const tinygltf::Animation& animation = model.animations[a];
    for (std::size_t c = 0; c < animation.channels.size(); ++c) {
      const tinygltf::AnimationChannel& channel = animation.channels[c];
      const std::string field = fmt::format("animations[{}].channels[{}]", a, c);
      if (channel.target_path != "weights" || !inside(channel.target_node, place_of.size())) continue;
      const int place = place_of[static_cast<std::size_t>(channel.target_node)];
      const std::size_t targets = target_count(model, channel.target_node);
      if (targets == 0) {
        diagnostics.warn(path, field + " moves the \"weights\" of a mesh without morph targets, and is left out");
      }
      if (place < 0 || targets == 0 || !taken.insert(place).second) continue;
      LUM_TRY(WeightTrack track, read_weights(model, animation, channel.sampler, targets, path, field));
      track.node = place;
      tracks.push_back(std::move(track));
    }
  }
  return tracks;
}

}  // namespace luminist
