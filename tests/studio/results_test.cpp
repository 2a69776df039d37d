#include "studio/results.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "studio/golden.h"
#include "studio/heat_map.h"
#include "studio/plot.h"
#include "studio/session_fixture.h"

namespace luminist {
namespace {

TEST_F(SessionTest, ResultsOfAnAcceptedSolveKeepItsTarget) {
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_ASSERT_OK(const Target* target, session_->target());
  const Image painted = target->color;
  LUM_EXPECT_OK(session_->add_light({}));
  LUM_EXPECT_OK(session_->solve(few_evals(), {}));
  LUM_ASSERT_OK(const Results proposed, collect_results(*session_));
  LUM_EXPECT_OK(session_->accept());
  LUM_ASSERT_OK(const Results accepted, collect_results(*session_));
  EXPECT_EQ(proposed.target.data, painted.data);
  EXPECT_EQ(accepted.target.data, painted.data);
  EXPECT_EQ(accepted.picture.data, proposed.picture.data);
  EXPECT_EQ(accepted.residual.data, proposed.residual.data);
  EXPECT_EQ(accepted.rig, proposed.rig);
  ASSERT_TRUE(accepted.report);
  const auto json = solve_to_json(*accepted.report, session_->shown());
  EXPECT_EQ(json["epsilon"].get<double>(), accepted.report->epsilon);
  EXPECT_EQ(json["lights"][0]["name"], "light");
}

TEST(HeatMap, GrowsLighterEvenly) {
  const auto lightness = [](const Vec3& c) { return std::cbrt(0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z); };
  double last = lightness(heat_color(0.0F));
  EXPECT_NEAR(last, 0.06, 0.01);
  for (int i = 1; i <= 20; ++i) {
    const double now = lightness(heat_color(static_cast<float>(i) / 20.0F));
    EXPECT_NEAR(now - last, 0.0455, 0.03) << i;  // twenty even steps from 0.06 to 0.97; strong hues bend them
    last = now;
  }
  EXPECT_NEAR(last, 0.97, 0.02);
  EXPECT_EQ(heat_color(NAN), heat_color(1.0F));
}

TEST(HeatMap, ItsScaleRunsFromZeroToWhiteBelowThePicture) {
  const Image values(64, 10, 1, 0.25F);
  const Image plain = heat_map(values, 0.5F);
  const Image sheet = heat_map_with_scale(values, 0.5F);
  ASSERT_EQ(sheet.width, 64);
  ASSERT_GT(sheet.height, 20);
  for (std::size_t i = 0; i < plain.pixels(); ++i) ASSERT_EQ(sheet.rgb(i), plain.rgb(i));
  const std::size_t bar = sheet.index(0, 16);
  EXPECT_EQ(sheet.rgb(bar), heat_color(0.5F / 64.0F));
  EXPECT_EQ(sheet.rgb(bar + 63), heat_color(63.5F / 64.0F));
}

TEST(HeatMap, FindsQuantiles) {
  Image values(5, 1, 1);
  values.data = {4.0F, NAN, 1.0F, 3.0F, 2.0F};
  EXPECT_EQ(quantile(values, 0.0), 1.0F);
  EXPECT_EQ(quantile(values, 1.0), 4.0F);
  EXPECT_EQ(quantile(values, 0.5), 2.0F);
}

TEST(ImportancePicture, PrintsOneAsBlack) {
  Image importance(3, 1, 1);
  importance.data = {0.0F, 0.5F, 1.0F};
  const Image picture = importance_picture(importance);
  EXPECT_EQ(picture.rgb(0), Vec3(1.0F));
  EXPECT_EQ(picture.rgb(2), Vec3(0.0F));
  EXPECT_NEAR(srgb_from_linear(picture.rgb(1).x), 0.5F, 1e-6F);
}

TEST(ConvergencePlot, DrawsTheCurveFromTheStartToTheEndOfTheWork) {
  SolveReport report;
  report.solver = "fast";
  report.epsilon_start = 0.5;
  report.epsilon = 0.01;
  report.render_equivalents = 20.0;
  report.convergence = {{1.0, 1, 0.1, 0.5}, {8.0, 2, 0.5, 0.05}, {12.0, 3, 0.8, 0.01}};
  const Image plot = convergence_plot(report);
  const auto is_curve = [&](int x, int y) { return plot.at(x, y, 2) > 3.0F * plot.at(x, y, 0); };
  int columns = 0;
  for (int x = 0; x < plot.width; ++x) {
    bool found = false;
    for (int y = 0; y < plot.height; ++y) found = found || is_curve(x, y);
    columns += found ? 1 : 0;
  }
  EXPECT_NEAR(columns, 770 * 19 / 20, 15);  // from 1 to 20 of an axis that is 770 pixels long and ends at 20
}

TEST(ConvergencePlot, SurvivesWhatASolveMayReport) {
  for (const double epsilon : {0.0, 1e-300, 1e9, static_cast<double>(INFINITY)}) {
    SolveReport report;
    report.epsilon_start = epsilon;
    report.epsilon = epsilon;
    report.convergence = {{0.0, 1, 0.0, epsilon}, {1e9, 2, 0.0, 0.0}};
    EXPECT_EQ(convergence_plot(report).width, 900);
  }
}

TEST(ContactSheet, HoldsEveryPictureUnderItsColumn) {
  const std::vector<SheetRow> rows = {{"one", {Image(40, 20, 3, 1.0F), Image(40, 20, 1, 0.5F)}},
                                      {"two", {Image(20, 40, 3, 0.25F)}}};
  const Image sheet = contact_sheet({"a", "b"}, rows, 100);
  EXPECT_EQ(sheet.width, 12 + 2 * 112);
  EXPECT_EQ(std::count(sheet.data.begin(), sheet.data.end(), 1.0F), 100 * 50 * 3);
  EXPECT_EQ(std::count(sheet.data.begin(), sheet.data.end(), 0.5F), 100 * 50 * 3);
  EXPECT_EQ(std::count(sheet.data.begin(), sheet.data.end(), 0.25F), 100 * 200 * 3);
}

TEST(ComparePictures, LooksAtSizeChannelsAndFiniteValuesFirst) {
  const Image reference(4, 4, 3, 0.5F);
  EXPECT_NE(compare_pictures(Image(4, 5, 3), reference).fault.find("4 x 5"), std::string::npos);
  EXPECT_NE(compare_pictures(Image(4, 4, 1), reference).fault.find("1 channels"), std::string::npos);
  Image broken = reference;
  broken.data[7] = NAN;
  EXPECT_NE(compare_pictures(broken, reference).fault.find("not finite"), std::string::npos);
  EXPECT_NE(compare_pictures(broken, broken).fault, "");  // a picture full of NaN equals nothing
}

TEST(ComparePictures, IsAbsoluteBelowOneAndRelativeAbove) {
  Image reference(2, 1, 1);
  Image picture(2, 1, 1);
  reference.data = {0.5F, 10.0F};
  picture.data = {0.6F, 12.0F};
  const PictureDifference difference = compare_pictures(picture, reference);
  EXPECT_EQ(difference.fault, "");
  EXPECT_NEAR(difference.max_difference, 0.2, 1e-7);
  EXPECT_NEAR(difference.mean_difference, 0.15, 1e-7);
}

}  // namespace
}  // namespace luminist
