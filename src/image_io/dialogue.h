#pragma once
// image_io/dialogue.h -- questions to the helper process, and its answers.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/process.h"
#include "image_io/packet.h"

namespace luminist {

struct Question {
  HelperTask task = HelperTask::kDecode;
  PacketHeader header = {};
  std::string_view text = {};
  std::string_view data = {};
};

struct Answer {
  PacketHeader header;
  std::string text;
  std::string data;
};

struct Dialogue {
  std::vector<Answer> answers;  ///< as many as came before the helper's end
  ProcessEnd end = {};          ///< if they are not all
};

/// One run of the helper, which stays for the next one. LUMINIST_IMAGE_HELPER, or else `luminist-image` beside the
/// running executable, is started where none waits. errors kChild if it cannot be. thread any.
Result<Dialogue> ask_helper(std::span<Question> questions);

}  // namespace luminist
