#include "paint/located_json.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luminist {
namespace {

constexpr std::size_t kDeepest = 32;

/// Reads characters for the parser and counts them: after a token it stands behind it, or one character further after
/// a number, which ends only where something else begins.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, const char** reached) : at_(at), reached_(reached) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** reached_;
};

/// What follows the first mark in a text; all of it if there is none.
std::string_view after(std::string_view text, std::string_view mark) {
  const std::size_t found = text.find(mark);
  return found == std::string_view::npos ? text : text.substr(found + mark.size());
}

/// Builds the tree from the parser's events.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeBuilder(const std::string& text) : text_(text), reached_(text.data()) { open_.emplace_back(); }

  [[nodiscard]] const char** reached() { return &reached_; }
  [[nodiscard]] JsonNode take_root() { return std::move(open_.front().items.front()); }
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] std::size_t problem_at() const { return problem_at_; }

  bool null() override { return add(JsonNode()); }
  bool boolean(bool value) override {
    JsonNode node;
    node.kind = JsonNode::Kind::kBool;
    node.boolean = value;
    return add(std::move(node));
  }
  bool number_integer(std::int64_t value) override { return add_number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) override { return add_number(static_cast<double>(value)); }
  bool number_float(double value, const std::string& /*as_written*/) override { return add_number(value); }
  bool string(std::string& value) override {
    JsonNode node;
    node.kind = JsonNode::Kind::kString;
    node.text = std::move(value);
    return add(std::move(node));
  }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON text has none
  bool start_object(std::size_t /*size*/) override { return open(JsonNode::Kind::kObject); }
  bool start_array(std::size_t /*size*/) override { return open(JsonNode::Kind::kArray); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    const std::size_t at = token_start();
    if (open_.back().find(name) != nullptr) {
      return refuse(fmt::format("the key \"{}\" is there twice", name), at);
    }
    key_ = std::move(name);
    key_at_ = at;
    return true;
  }
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    // The library's text is "[id] parse error at line 1, column 2: what was expected" or "[id] what"; the place is
    // ours.
    std::string_view what = after(error.what(), "] ");
    if (what.starts_with("parse error")) what = after(what, ": ");
    problem_ = what;
    problem_at_ = position > 0 ? position - 1 : 0;
    return false;
  }

 private:
  bool refuse(std::string what, std::size_t at) {
    problem_ = std::move(what);
    problem_at_ = at;
    return false;
  }
  /// Where the token that was just read begins: after the last one, blanks, commas and colons.
  std::size_t token_start() {
    const std::size_t start = text_.find_first_not_of(" \t\r\n,:", last_end_);
    last_end_ = static_cast<std::size_t>(reached_ - text_.data());
    return start;
  }
  JsonNode named(JsonNode node) {
    node.at = token_start();
    node.key = std::exchange(key_, {});
    node.key_at = key_at_;
    return node;
  }
  bool add(JsonNode node) {
    open_.back().items.push_back(named(std::move(node)));
    return true;
  }
  bool add_number(double value) {
    JsonNode node;
    node.kind = JsonNode::Kind::kNumber;
    node.number = value;
    return add(std::move(node));
  }
  bool open(JsonNode::Kind kind) {
    JsonNode node;
    node.kind = kind;
    open_.push_back(named(std::move(node)));
    if (open_.size() > kDeepest) return refuse("too many brackets inside each other", open_.back().at);
    return true;
  }
  bool close() {
    JsonNode node = std::move(open_.back());
    open_.pop_back();
    open_.back().items.push_back(std::move(node));
    token_start();
    return true;
  }

  const std::string& text_;
  const char* reached_;
  std::size_t last_end_ = 0;
  std::vector<JsonNode> open_;  ///< the containers that are not closed yet, inside one that holds the root
  std::string key_;
  std::size_t key_at_ = 0;
  std::string problem_;
  std::size_t problem_at_ = 0;
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view name) const {
  for (const JsonNode& item : items) {
    if (kind == Kind::kObject && item.key == name) return &item;
  }
  return nullptr;
}

Result<JsonNode> parse_located_json(const std::string& text, const std::string& path) {
  TreeBuilder builder(text);
  const CountingIterator first(text.data(), builder.reached());
  const CountingIterator last(text.data() + text.size(), builder.reached());
  if (nlohmann::json::sax_parse(first, last, &builder)) return builder.take_root();
  return Error{ErrorKind::kBadContent, builder.problem(), located(text, path, builder.problem_at()), "", ""};
}

std::string located(const std::string& text, const std::string& path, std::size_t offset) {
  int line = 1;
  int column = 1;
  for (std::size_t i = 0; i < offset && i < text.size(); ++i) {
    if (text[i] == '\n') {
      ++line;
      column = 1;
    } else if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) {  // not inside a UTF-8 sequence
      ++column;
    }
  }
  return fmt::format("{}:{}:{}", path, line, column);
}

}  // namespace luminist
