#pragma once
// app/value_slider.h -- a slider whose number can always be read: where it stands is a bar below the digits.
#include <imgui.h>

namespace luminist {

/// ImGui::SliderFloat() with that look. returns whether the value changed.
bool value_slider(const char* id, float* value, float least, float most, const char* format,
                  ImGuiSliderFlags flags = ImGuiSliderFlags_None);
bool value_slider(const char* id, int* value, int least, int most, const char* format,
                  ImGuiSliderFlags flags = ImGuiSliderFlags_None);

}  // namespace luminist
