#include "studio/session_fixture.h"

namespace luminist {
namespace {

using RestyleTest = SessionTest;

TEST_F(RestyleTest, LinesGoOverAStyleAndAwayWithoutChangingIt) {
  LUM_EXPECT_OK(session_->restyle("toon"));
  const ParamBlock before = session_->state().style;
  // Any number of the style will do; the first that is one.
  int param = 0;
  while (before.schema()[param].type != ParamType::kFloat) ++param;
  const std::string name = before.schema()[param].name;
  const double most = before.schema()[param].range_max.front();
  LUM_EXPECT_OK(session_->set({"style/" + name + "=" + std::to_string(0.875 * most)}));
  LUM_EXPECT_OK(session_->set_locked("style/" + name, false));
  const auto value = [&] {
    const ParamBlock& style = session_->state().style;
    return style.get(*style.schema().find(name), 0);
  };
  const double wanted = value();
  EXPECT_NE(wanted, before.get(param, 0));
  LUM_EXPECT_OK(session_->restyle("toon+outline"));
  EXPECT_EQ(value(), wanted);
  EXPECT_GT(session_->state().style.schema().size(), before.schema().size());
  const ParamBlock& stacked = session_->state().style;
  EXPECT_FALSE(stacked.locked(stacked.schema()[*stacked.schema().find(name)].first_dof));
  LUM_EXPECT_OK(session_->restyle("toon"));
  EXPECT_EQ(value(), wanted);
  LUM_EXPECT_OK(session_->restyle("gooch"));
  LUM_EXPECT_OK(session_->restyle("toon"));
  EXPECT_EQ(value(), before.get(param, 0)) << "another style begins with its own values";
}

TEST_F(RestyleTest, TheStyleThatItHasIsNoCommandAndOpensNoStage) {
  const std::size_t steps = session_->project().undo_steps();
  const std::uint64_t stage = session_->stage().id;
  LUM_EXPECT_OK(session_->restyle("cinematic"));
  EXPECT_EQ(session_->project().undo_steps(), steps);
  EXPECT_EQ(session_->stage().id, stage);
}

}  // namespace
}  // namespace luminist
