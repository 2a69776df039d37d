#include "render/views.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/check.h"
#include "render/metric.h"

namespace luminist {
namespace {

Error mismatch(const char* what) {
  return {ErrorKind::kUsage, what, "", "", "views of one rig show one scene, in pictures of one width"};
}

/// A style's name as the beginning of a parameter's.
std::string identifier(const std::string& name) {
  std::string word;
  for (const char c : name) {
    const bool fine = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (fine) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!fine && !word.empty() && word.back() != '_') word += '_';
  }
  if (word.empty() || std::isdigit(static_cast<unsigned char>(word.front())) != 0) word = "style_" + word;
  if (word.back() != '_') word += '_';
  return word;
}

/// Values and locks of one block's parameters from another's, from a parameter on; of both the same ones.
void copy_params(const ParamBlock& from, int from_first, ParamBlock& to, int to_first, int count) {
  for (int k = 0; k < count; ++k) {
    const ParamSpec& source = from.schema()[from_first + k];
    const ParamSpec& sink = to.schema()[to_first + k];
    for (int c = 0; c < source.components(); ++c) to.set(to_first + k, c, from.get(from_first + k, c));
    for (int dof = 0; dof < source.dofs(); ++dof) {
      to.set_locked(sink.first_dof + dof, from.locked_by_hand(source.first_dof + dof));
    }
  }
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Pictures of one width, the first on top.
Image stacked(const std::vector<Image>& pictures) {
  Image all;
  all.width = pictures.front().width;
  all.channels = pictures.front().channels;
  for (const Image& picture : pictures) {
    all.height += picture.height;
    append(all.data, picture.data);
  }
  return all;
}

/// What a picture is compared by is not smoothed, and nothing is held back.
void as_estimated(ParamBlock& style) {
  for (const char* role : {"clamp", "denoise"}) {
    if (const auto param = style.schema().by_role(role)) style.set(*param, 0, 0.0);
  }
}

}  // namespace

Result<std::unique_ptr<Views>> Views::create(std::vector<View> views) {
  LUM_CHECK(!views.empty(), "a picture shows something");
  const SceneFrame frame = views.front().renderer->frame();
  for (const View& view : views) {
    const SceneFrame other = view.renderer->frame();
    if (view.renderer->surface().width != views.front().renderer->surface().width) {
      return mismatch("the views' pictures are of different widths");
    }
    if (other.center != frame.center || other.radius != frame.radius)
      return mismatch("the views show different scenes");
  }
  std::unique_ptr<Views> all(new Views(std::move(views)));
  LUM_TRY_VOID(all->join_styles());
  all->join_surfaces();
  all->join_targets();
  return all;
}

Result<void> Views::join_styles() {
  std::map<std::string, int> first;
  std::vector<ParamSpec> specs;
  style_.name = "views";
  style_.lights = LightCombination::kSum;
  for (const View& view : views_) {
    const Style& style = view.renderer->style();
    // A colour with keys is another one in each view: no colour of the joint rig scales what its light adds.
    const bool joint = view.frame || style.combination(view.style) == LightCombination::kJoint;
    if (joint) style_.lights = LightCombination::kJoint;
    const auto [known, is_new] = first.try_emplace(style.name, static_cast<int>(specs.size()));
    first_param_.push_back(known->second);
    if (!is_new) continue;
    sources_.push_back(&view.style);
    for (ParamSpec spec : view.style.schema().specs()) {
      spec.name = identifier(style.name) + spec.name;
      specs.push_back(std::move(spec));
    }
  }
  LUM_TRY(style_.schema, ParamSchema::create(std::move(specs), "views"));
  return {};
}

void Views::join_surfaces() {
  surface_.width = views_.front().renderer->surface().width;
  surface_.eye = views_.front().renderer->surface().eye;
  surface_.object_names = views_.front().renderer->surface().object_names;
  first_pixel_.push_back(0);
  for (const View& view : views_) {
    const SurfaceBuffer& one = view.renderer->surface();
    surface_.height += one.height;
    append(surface_.position, one.position);
    append(surface_.normal, one.normal);
    append(surface_.albedo, one.albedo);
    append(surface_.specular, one.specular);
    append(surface_.roughness, one.roughness);
    append(surface_.object, one.object);
    append(surface_.material, one.material);
    first_pixel_.push_back(surface_.pixels());
  }
}

void Views::join_targets() {
  std::vector<Image> color;
  std::vector<Image> before;
  std::vector<Image> importance;
  const std::size_t first_view_pixels = views_.front().renderer->surface().pixels();
  for (const View& view : views_) {
    const Target seen = as_compared(view.target, view.renderer->style().metric);
    color.push_back(seen.color);
    before.push_back(seen.before);
    importance.push_back(seen.importance);
    append(target_.stroke, seen.stroke);
    // A view counts as its weight says, however much of it is painted.
    double sum = 0.0;
    for (const float weight : seen.importance.data) sum += static_cast<double>(weight);
    if (!(sum > 0.0)) continue;
    const auto scale = static_cast<float>(view.weight * static_cast<double>(first_view_pixels) / sum);
    for (float& weight : importance.back().data) weight *= scale;
  }
  target_.color = stacked(color);
  target_.before = stacked(before);
  target_.importance = stacked(importance);
}

ParamState Views::joint(const LightRig& rig) const {
  ParamState state{rig, ParamBlock(style_.schema, frame()), views_.front().materials};
  int first = 0;
  for (const ParamBlock* source : sources_) {
    copy_params(*source, 0, state.style, first, source->schema().size());
    first += source->schema().size();
  }
  return state;
}

ParamState Views::state_of(const ParamState& joint, int view) const {
  const auto index = static_cast<std::size_t>(view);
  ParamState state{joint.rig, views_[index].style, joint.materials};
  copy_params(joint.style, first_param_[index], state.style, 0, state.style.schema().size());
  if (views_[index].frame) pose(state.rig, *views_[index].frame);
  return state;
}

Result<double> Views::error_of(const ParamState& joint, int view) {
  const View& one = views_[static_cast<std::size_t>(view)];
  return one.renderer->error(state_of(joint, view), one.target);
}

bool Views::estimates() const {
  return std::ranges::any_of(views_, [](const View& view) { return view.renderer->estimates(); });
}

Result<Image> Views::render(const ParamState& joint, const RenderOptions& options) {
  return pictures(joint, options, false);
}

Result<Image> Views::pictures(const ParamState& joint, const RenderOptions& options, bool compared) {
  std::vector<Image> pictures;
  for (int view = 0; view < count(); ++view) {
    Renderer& renderer = *views_[static_cast<std::size_t>(view)].renderer;
    ParamState state = state_of(joint, view);
    if (compared && renderer.estimates()) as_estimated(state.style);
    LUM_TRY(const Image picture, renderer.render(state, options));
    pictures.push_back(as_compared(picture, renderer.style().metric));
  }
  return stacked(pictures);
}

Result<double> Views::error(const ParamState& joint, const Target& target) {
  LUM_TRY(const Image picture, pictures(joint, {}, true));
  return picture_error(picture, target, style_.metric);
}

Result<double> Views::error(const ParamState& joint, const Target& target, std::span<const int> moving) {
  RenderOptions options;
  options.moving = moving;
  LUM_TRY(const Image picture, pictures(joint, options, true));
  return picture_error(picture, target, style_.metric);
}

std::vector<Views::Share> Views::shares(std::span<const std::uint32_t> pixels, std::uint64_t id) const {
  std::vector<Share> shares(views_.size());
  for (std::size_t view = 0; view < shares.size(); ++view) shares[view].samples.id = id * 64 + view + 1;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto after = std::upper_bound(first_pixel_.begin(), first_pixel_.end(), pixels[i]);
    const auto view = static_cast<std::size_t>(after - first_pixel_.begin()) - 1;
    LUM_CHECK(view < shares.size(), "samples lie in the picture");
    shares[view].samples.pixels.push_back(static_cast<std::uint32_t>(pixels[i] - first_pixel_[view]));
    shares[view].place.push_back(i);
  }
  return shares;
}

Result<void> Views::colors_at(const ParamState& joint, std::span<const int> without,
                              std::span<const std::uint32_t> pixels, std::span<Vec3> out) {
  LUM_CHECK(pixels.size() == out.size(), "one colour per pixel");
  const std::vector<Share> split = shares(pixels, 0);
  for (std::size_t view = 0; view < split.size(); ++view) {
    std::vector<Vec3> colors(split[view].place.size());
    LUM_TRY_VOID(views_[view].renderer->colors_at(state_of(joint, static_cast<int>(view)), without,
                                                  split[view].samples.pixels, colors));
    for (std::size_t i = 0; i < colors.size(); ++i) out[split[view].place[i]] = colors[i];
  }
  return {};
}

Result<void> Views::evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                             std::span<Vec3> out) {
  constexpr std::size_t kKept = 64;  // sets of samples: a solve has a few, a live one makes new ones now and then
  const std::size_t count = samples.pixels.size();
  LUM_CHECK(out.size() == candidates.size() * count, "one result per candidate and sample");
  if (split_.size() > kKept) split_.clear();
  const auto [known, is_new] = split_.try_emplace(samples.id);
  if (is_new) known->second = shares(samples.pixels, samples.id);
  for (std::size_t view = 0; view < views_.size(); ++view) {
    const Share& share = known->second[view];
    if (share.place.empty()) continue;
    std::vector<ParamState> states;
    states.reserve(candidates.size());
    std::vector<Candidate> seen;
    const ParamState* last = nullptr;
    for (const Candidate& candidate : candidates) {
      if (candidate.state != last) states.push_back(state_of(*candidate.state, static_cast<int>(view)));
      last = candidate.state;
      seen.push_back({&states.back(), candidate.light});
    }
    std::vector<Vec3> colors(seen.size() * share.place.size());
    LUM_TRY_VOID(views_[view].renderer->evaluate(seen, share.samples, softness, colors));
    for (std::size_t k = 0; k < seen.size(); ++k) {
      for (std::size_t i = 0; i < share.place.size(); ++i) {
        out[k * count + share.place[i]] = colors[k * share.place.size() + i];
      }
    }
  }
  return {};
}

const WorkCount& Views::work() const {
  work_ = {};
  std::vector<const Renderer*> counted;  // two views may share an engine
  for (const View& view : views_) {
    if (std::find(counted.begin(), counted.end(), view.renderer) != counted.end()) continue;
    counted.push_back(view.renderer);
    const WorkCount& one = view.renderer->work();
    work_.shades += one.shades;
    work_.shadow_queries += one.shadow_queries;
    work_.pictures += one.pictures;
  }
  return work_;
}

}  // namespace luminist
