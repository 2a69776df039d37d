#pragma once
// solve/picture_parts.h -- how the picture of a rig falls into summands that colours scale.
#include <span>
#include <vector>

#include "base/result.h"
#include "render/renderer.h"

namespace luminist {

/// A summand of the picture: what one light adds, or what is left without lights, or all of it where a style does not
/// sum its lights. Where the style's colours scale the picture, each of these falls into one part a colour and one that
/// no colour of the style scales. A part's field is measured with the colours that scale it at white.
struct Part {
  int light = Candidate::kAllLights;  ///< as in Candidate
  int light_color = -1;               ///< the light's parameter that scales it; else -1
  int style_color = -1;               ///< the style's parameter that scales it; else -1
  int rest = 0;                       ///< the part of the same light that no colour of the style scales
};

/// A part that a colour scales: with that colour times the factor.
struct ColoredPart {
  int part = 0;
  float factor = 1.0F;
};

/// A colour that scales parts: a light's (also those parts that have its colour by a constraint), or the style's.
struct PartColor {
  int block = 0;  ///< as in Dof
  int param = 0;
  bool of_style = false;
  std::vector<ColoredPart> parts;
};

/// The parts of a picture, which of them a degree of freedom touches, and the colours that scale them.
class PictureParts {
 public:
  /// Whether colours really scale is tried on the probe samples; where they do not, colours are as other parameters. Of
  /// the style's colours only those with something unlocked are asked.
  /// errors the renderer's. cost a few candidates a light and a style's colour on the probe.
  static Result<PictureParts> create(Renderer& renderer, const ParamState& state, const SampleSet& probe);

  [[nodiscard]] const std::vector<Part>& list() const { return parts_; }
  [[nodiscard]] const std::vector<PartColor>& colors() const { return colors_; }
  /// The index of the colour that a degree of freedom is a channel of, or -1 if it is nothing so simple.
  [[nodiscard]] int color_of(const Dof& dof) const;

  /// The parts that a degree of freedom changes other than by scaling; always all parts of a light. One of the style or
  /// of a material changes all of them: whatever light does, it does there, and no part is kept while it turns.
  [[nodiscard]] std::vector<int> touched_by(const ParamState& state, const Dof& dof) const;
  /// Those that the degrees of freedom of some blocks touch besides colours, in order, each once.
  [[nodiscard]] std::vector<int> touched_by(const ParamState& state, const UnitMap& map,
                                            std::span<const int> blocks) const;

  /// The state whose picture is the field of a part: colours that scale are white, those of the style black if they
  /// scale other parts. The field of a part that the style scales is what that adds to the field of its rest.
  [[nodiscard]] ParamState whitened(const ParamState& state, int part) const;
  /// The same with the style's own colours.
  [[nodiscard]] ParamState whitened(const ParamState& state) const;

 private:
  void find_groups(const ParamState& state, bool joint);
  Result<void> try_light_colors(Renderer& renderer, const ParamState& state, const SampleSet& probe);
  /// Whether all parts are linear in these colours of the style at once.
  [[nodiscard]] Result<bool> scale_together(Renderer& renderer, const ParamState& state, const SampleSet& probe,
                                            const std::vector<int>& params) const;
  void split(const std::vector<int>& params);
  void list_colors(const ParamState& state);

  std::vector<Part> parts_;
  std::vector<PartColor> colors_;
  int stride_ = 1;  ///< parts a light
};

/// What scales a part in a state: the colours of its light and of the style, or ones.
Vec3 part_color(const ParamState& state, const Part& part);
/// The same without the colour of the style, or of the light.
Vec3 part_color_without(const ParamState& state, const Part& part, bool style);

}  // namespace luminist
