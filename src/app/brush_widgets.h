#pragma once
// app/brush_widgets.h -- a widget for each quality of a brush: the one in the hand, or that of a stroke.
#include "app/desk.h"

namespace luminist {

/// The declaration of a quality. name: one of brush_qualities().
const BrushQuality& brush_quality(const char* name);
/// What it does and its range, once the pointer rests on the last item.
void quality_tip(const Theme& theme, const BrushQuality& what);

/// The qualities that the brush's tool has, without its colour. returns whether the hand let go of one.
bool brush_settings(Desk& desk, Brush& brush);

}  // namespace luminist
