#include "app/range_popup.h"

#include "app/icons.h"
#include "params/param_text.h"

namespace luminist {
namespace {

constexpr std::string_view kLights = "lights/";

/// "key" of "lights/key/barn".
std::string light_of(const std::string& path) {
  return path.substr(kLights.size(), path.rfind('/') - kLights.size());
}

bool number_field(const Desk& desk, const char* id, float& value) {
  ImGui::SetNextItemWidth(desk.theme.px(72.0F));
  return ImGui::InputFloat(id, &value, 0.0F, 0.0F, "%.4g");
}

}  // namespace

bool takes_ranges(const ParamSpec& spec, const std::string& path) {
  return path.starts_with(kLights) && spec.dofs() > 0 && spec.type != ParamType::kDirection;
}

void RangePopup::read(const ParamBlock& block, int param, const SceneFrame& frame) {
  const ParamSpec& spec = block.schema()[param];
  for (int c = 0; c < spec.components(); ++c) {
    const ParamRange range = block.range(param, c, frame);
    rows_[static_cast<std::size_t>(c)] = {block.limits(spec.first_dof + c) != nullptr,
                                          static_cast<float>(spec.written(c, range.low, frame)),
                                          static_cast<float>(spec.written(c, range.high, frame))};
  }
  seen_ = rows_;
}

void RangePopup::record(Desk& desk, const ParamSpec& spec, const std::string& light) const {
  std::vector<Constraint> ranges;
  for (int c = 0; c < spec.components(); ++c) {
    const Row& row = rows_[static_cast<std::size_t>(c)];
    if (!row.held) continue;
    const SceneFrame& frame = desk.now->facts->frame;
    ranges.push_back({light, Between{dof_name(spec, c), static_cast<float>(spec.stored(c, row.low, frame)),
                                     static_cast<float>(spec.stored(c, row.high, frame))}});
  }
  const auto of_param = [light, name = spec.name](const Constraint& each) {
    const auto* range = std::get_if<Between>(&each.rule);
    return range != nullptr && each.light == light && range->param.substr(0, range->param.find('.')) == name;
  };
  desk.studio->change(
      ranges.empty() ? "free a range" : "hold a range",
      [of_param, ranges](Session& session) {
        std::vector<Constraint> all = session.state().rig.constraints;
        std::erase_if(all, of_param);
        all.insert(all.end(), ranges.begin(), ranges.end());
        return session.set_constraints(std::move(all));
      },
      Workbench::After::kFollow);
}

void RangePopup::offer(Desk& desk, const ParamBlock& block, int param, const std::string& path) {
  const ParamSpec& spec = block.schema()[param];
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
    read(block, param, desk.now->facts->frame);
    ImGui::OpenPopup("range");
  }
  if (!ImGui::BeginPopup("range")) return;
  ImGui::TextDisabled("Whoever turns it, it stays between");
  for (int c = 0; c < spec.components(); ++c) {
    Row& row = rows_[static_cast<std::size_t>(c)];
    ImGui::PushID(c);
    ImGui::Checkbox("##held", &row.held);
    ImGui::SameLine();
    row.held |= number_field(desk, "##low", row.low);
    ImGui::SameLine();
    ImGui::TextUnformatted("and");
    ImGui::SameLine();
    row.held |= number_field(desk, "##high", row.high);
    if (spec.components() > 1) {
      ImGui::SameLine();
      ImGui::TextDisabled("%s", dof_name(spec, c).substr(spec.name.size() + 1).c_str());
    }
    ImGui::PopID();
  }
  bool ranges = true;
  for (int c = 0; c < spec.components(); ++c) {
    const Row& row = rows_[static_cast<std::size_t>(c)];
    ranges = ranges && (!row.held || row.low < row.high);
  }
  ImGui::BeginDisabled(!ranges);
  if (ImGui::Button("Keep")) {
    if (rows_ != seen_) record(desk, spec, light_of(path));
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndDisabled();
  tip(desk.theme, "What is ticked stays in its range, from a number to a larger one; what is not is free again.");
  ImGui::EndPopup();
}

}  // namespace luminist
