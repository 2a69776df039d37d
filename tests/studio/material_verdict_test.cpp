// What no light makes because a material is locked.
#include "studio/session_fixture.h"
#include "verdict/lock_probe.h"

namespace luminist {
namespace {

class MaterialVerdict : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    std::ofstream(folder_.file("rig.toml"))
        << "[ambient]\ncolor = [0.1, 0.1, 0.1]\n[[light]]\nname = \"key\"\ntype = \"point\"\n"
           "position = [2, 4, 3]\nfalloff_exponent = 0\ncolor = [1, 1, 1]\n";
    LUM_EXPECT_OK(session_->load_rig("rig.toml", folder_.path()));
    LUM_ASSERT_OK(const int locked, session_->set_locked("*", true));
    EXPECT_GT(locked, 0);
  }
  /// The ball's pixels as they are in another state.
  SampledWish wish_of(const ParamState& wanted) {
    Renderer& renderer = *session_->stage().renderer;
    const SurfaceBuffer& surface = renderer.surface();
    SampledWish wish;
    wish.samples.id = 5;
    for (std::uint32_t pixel = 0; pixel < surface.pixels(); pixel += 3) {
      if (surface.material[pixel] == 1) wish.samples.pixels.push_back(pixel);
    }
    wish.target.resize(wish.samples.pixels.size());
    const Candidate candidate{&wanted};
    LUM_EXPECT_OK(renderer.evaluate({&candidate, 1}, wish.samples, {}, wish.target));
    wish.weight.assign(wish.target.size(), 1.0 / static_cast<double>(wish.target.size()));
    return wish;
  }
};

TEST_F(MaterialVerdict, TheProbeFindsTheLockThatKeepsASurfaceFromItsColour) {
  ParamState wanted = session_->state();
  LUM_EXPECT_OK(set_path(wanted, "materials/clay/roughness=0.2"));
  LUM_EXPECT_OK(set_path(wanted, "materials/clay/tint=0.4,0.9,1.2"));
  const SampledWish wish = wish_of(wanted);
  LUM_ASSERT_OK(const std::vector<Unlocking> found,
                best_unlockings(*session_->stage().renderer, session_->state(), wish, 10, LockedKind::kMaterial));
  ASSERT_EQ(found.size(), 3U) << "one for each parameter of the ball's material, none of the floor's";
  EXPECT_EQ(found[0].group.patterns, std::vector<std::string>{"materials/clay/tint"});
  EXPECT_LT(found[0].reached.error, found[1].reached.error);
}

TEST_F(MaterialVerdict, LightIsProbedWithoutMaterials) {
  for (const LockedGroup& group : locked_groups(session_->state())) {
    EXPECT_EQ(material_of_block(session_->state(), group.block), -1) << group.patterns.front();
  }
  EXPECT_EQ(locked_groups(session_->state(), LockedKind::kMaterial).size(), 6U);
}

}  // namespace
}  // namespace luminist
