// The part of a workbench that looks beyond one solve, and at a style's files.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "studio/exploration_results.h"
#include "studio/workbench.h"

namespace luminist {
namespace {

constexpr int kOfferWidth = 300;  // pixels

}  // namespace

Result<void> Workbench::add_offer(std::vector<Offer>& offers, std::string title, const ParamState& lights,
                                  SolveReport report) {
  LUM_TRY(const Image picture, session_->stage().renderer->render(lights));
  Image small = resized(picture, kOfferWidth, kOfferWidth * picture.height / picture.width);
  offers.push_back({std::move(title), std::make_shared<const Image>(std::move(small)), lights, std::move(report)});
  return {};
}

Result<void> Workbench::offer_alternatives(const ExploreWatch& watch) {
  LUM_TRY_VOID(need_session());
  LUM_TRY_VOID(put_proposal());
  LUM_TRY(const Alternatives found, find_alternatives(*session_, AlternativesOptions{}, watch));
  std::vector<Offer> offers;
  for (const Alternative& each : found.list) {
    LUM_TRY_VOID(add_offer(offers, fmt::format("error {:.4f}", each.report.error()), each.state, each.report));
  }
  offers_ = std::make_shared<const std::vector<Offer>>(std::move(offers));
  return {};
}

Result<void> Workbench::offer_diet(const ExploreWatch& watch) {
  LUM_TRY_VOID(need_session());
  LUM_TRY_VOID(put_proposal());
  LUM_TRY(const Diet diet, find_diet(*session_, DietOptions{}, watch));
  std::vector<Offer> offers;
  for (std::size_t i = 0; i < diet.steps.size(); ++i) {
    SolveReport report;
    report.solver = "fast";
    report.termination = Termination::kConverged;
    report.epsilon_start = diet.steps[i].epsilon_removed;
    report.epsilon = diet.steps[i].epsilon;
    const std::string chosen = i == diet.chosen ? "\nthe fewest within 5 %" : "";
    LUM_TRY_VOID(add_offer(offers, diet_line(diet, i) + chosen, diet.steps[i].state, report));
  }
  offers_ = std::make_shared<const std::vector<Offer>>(std::move(offers));
  return {};
}

Result<void> Workbench::take_offer(std::size_t offer) {
  const auto offers = offers_;
  if (!offers || offer >= offers->size()) {
    return Error{ErrorKind::kNothingToDo, "there is no such offer any more", "", "", ""};
  }
  LUM_TRY_VOID(need_session());
  if (stroke_) LUM_TRY_VOID(finish_stroke());
  const Offer& taken = (*offers)[offer];
  LUM_TRY(const Target* target, session_->target());
  session_->propose(taken.lights, {{}, taken.report, *target, "Take an offer"});
  live_painting_.reset();
  quick_painting_.reset();
  trial_.reset();
  solving_ = resting_ = follow_again_ = proposal_put_ = false;
  unanswered_ = 0;
  picture_.reset();
  return {};
}

Result<void> Workbench::prepare() {
  if (!session_ || !device_->info().software || !QuickStage::helps(session_->shot())) return {};
  if (unprepared_ == session_->stage().id) return {};
  if (quick_stages_.size() == QuickStage::kSizes.size()) {
    LUM_TRY_VOID(prepare_stroke());
    prepare_shadows();
    return {};
  }
  Diagnostics told_already;
  auto stage = QuickStage::open(*device_, roots_, session_->shot(), QuickStage::kSizes[quick_stages_.size()],
                                session_->project().folder().parent_path(), told_already);
  if (!stage) {
    unprepared_ = session_->stage().id;  // it fails again, which was told
    return std::move(stage).error();
  }
  const auto smaller = [&](const auto& each) { return each->pixels() < (*stage)->pixels(); };
  quick_stages_.insert(std::ranges::find_if(quick_stages_, smaller), std::move(*stage));
  return {};
}

Result<bool> Workbench::refresh_style() {
  if (!session_ || stroke_) return false;
  if (!style_files_ || facts_of_ != session_->stage().id) {
    style_files_.emplace(session_->stage().style);
    return false;
  }
  if (!style_files_->changed()) return false;
  LUM_TRY_VOID(put_proposal());
  offers_.reset();
  LUM_TRY_VOID(session_->reload_style());
  style_files_->follow(session_->stage().style);
  live_painting_.reset();
  drop_quick_stages();
  quick_size_ = {};
  kept_.clear();
  canvas_.reset();
  trial_.reset();
  solving_ = resting_ = proposal_put_ = false;
  follow_again_ = live_ && session_->painted();
  facts_of_ = 0;
  forget_pictures();
  note_history();
  return true;
}

}  // namespace luminist
