#include "make_tam/tile_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "make_tam/hash.h"

namespace luminist {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr int kCrowdScales = 6;

int wrapped(int i, int size) {
  return ((i % size) + size) % size;
}

/// Smooth noise along a stroke, -1 to 1.
double waviness(double along, std::uint64_t seed) {
  const double phase_a = 6.283 * unit_hash(seed, 1);
  const double phase_b = 6.283 * unit_hash(seed, 2);
  return 0.65 * std::sin(3.1 * along + phase_a) + 0.35 * std::sin(7.3 * along + phase_b);
}

/// Value noise of the paper, -1 to 1; `cell` texels, repeating after `size`.
double grain_at(int x, int y, int size, double cell) {
  const double u = x / cell;
  const double v = y / cell;
  const int cells = std::max(1, static_cast<int>(size / cell));
  const auto value = [&](int i, int j) {
    return 2.0 * unit_hash(static_cast<std::uint64_t>(wrapped(i, cells)) * 7919U, wrapped(j, cells)) - 1.0;
  };
  const int i = static_cast<int>(std::floor(u));
  const int j = static_cast<int>(std::floor(v));
  const double a = (u - i) * (u - i) * (3.0 - 2.0 * (u - i));
  const double b = (v - j) * (v - j) * (3.0 - 2.0 * (v - j));
  return std::lerp(std::lerp(value(i, j), value(i + 1, j), a), std::lerp(value(i, j + 1), value(i + 1, j + 1), a), b);
}

}  // namespace

TileLevel::TileLevel(const StrokeKind& kind, int size) : kind_(&kind), size_(size) {
  const std::size_t texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  order_.assign(texels, kNever);
  covered_.assign(texels, false);
  for (int scale = 0; scale < kCrowdScales && (size >> scale) >= 1; ++scale) {
    const auto cells = static_cast<std::size_t>(size >> scale);
    for (Crowds& crowds : crowds_) crowds.emplace_back(cells * cells, 0.0F);
  }
}

/// visit(x, y, q): q is the distance from the stroke's middle line over its half width there, at most 1.
template <class Visit>
void TileLevel::for_texels(const Stroke& stroke, Visit&& visit) const {
  const double half_width = 0.5 * kind_->width;
  const double half_length = 0.5 * stroke.length * size_;
  const double cosine = std::cos(stroke.angle);
  const double sine = std::sin(stroke.angle);
  const double margin = half_width + kind_->wobble + 1.0;
  const double reach_x = half_length * std::abs(cosine) + margin;
  const double reach_y = half_length * std::abs(sine) + margin;
  const double cx = stroke.x * size_ - 0.5;
  const double cy = stroke.y * size_ - 0.5;
  for (int y = static_cast<int>(std::floor(cy - reach_y)); y <= static_cast<int>(std::ceil(cy + reach_y)); ++y) {
    for (int x = static_cast<int>(std::floor(cx - reach_x)); x <= static_cast<int>(std::ceil(cx + reach_x)); ++x) {
      const double along = (x - cx) * cosine + (y - cy) * sine;
      double across = (y - cy) * cosine - (x - cx) * sine;
      double thin = 1.0;
      double beyond = 0.0;
      if (half_length > 0.0) {
        const double share = along / half_length;  // -1 to 1
        across -= kind_->wobble * waviness(share, stroke.seed);
        const double end = (1.0 - std::abs(share)) / std::max(2.0 * kind_->taper, 1e-6);
        thin = end >= 1.0 ? 1.0 : std::sqrt(std::max(end, 0.0));
        thin *= 0.85 + 0.15 * waviness(1.7 * share + 4.0, stroke.seed);
        if (std::abs(share) > 1.0) continue;
      } else {
        beyond = along;
      }
      const double q = std::sqrt(across * across + beyond * beyond) / std::max(half_width * thin, 1e-6);
      if (q <= 1.0) visit(wrapped(x, size_), wrapped(y, size_), q);
    }
  }
}

double TileLevel::crowding(const Stroke& stroke) const {
  const Crowds& crowds = crowds_[stroke.crosses ? 1 : 0];
  const int steps = std::max(1, static_cast<int>(stroke.length * size_ / 4.0));
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double along = steps == 1 ? 0.0 : stroke.length * (static_cast<double>(i) / (steps - 1) - 0.5);
    const int x = wrapped(static_cast<int>((stroke.x + along * std::cos(stroke.angle)) * size_), size_);
    const int y = wrapped(static_cast<int>((stroke.y + along * std::sin(stroke.angle)) * size_), size_);
    for (std::size_t scale = 0; scale < crowds.size(); ++scale) {
      const int cells = size_ >> scale;
      const auto cell = static_cast<std::size_t>((y >> scale) * cells + (x >> scale));
      sum += crowds[scale][cell] / static_cast<double>(1 << (2 * scale));
    }
  }
  return sum / steps;
}

void TileLevel::cover(int x, int y, bool crosses) {
  const auto texel = static_cast<std::size_t>(y * size_ + x);
  if (!covered_[texel]) ink_ += 1.0 / (static_cast<double>(size_) * size_);
  covered_[texel] = true;
  Crowds& crowds = crowds_[crosses ? 1 : 0];
  for (std::size_t scale = 0; scale < crowds.size(); ++scale) {
    crowds[scale][static_cast<std::size_t>((y >> scale) * (size_ >> scale) + (x >> scale))] += 1.0F;
  }
}

void TileLevel::draw(const Stroke& stroke) {
  const double tone = ink_;
  for_texels(stroke, [&](int x, int y, double q) {
    double at = tone + kind_->swelling * q * q;
    if (kind_->grain > 0.0) {
      at += kind_->grain * (0.6 * grain_at(x, y, size_, 2.0) + 0.4 * grain_at(x, y, size_, 4.0) + 0.3 * q);
    }
    float& order = order_[static_cast<std::size_t>(y * size_ + x)];
    order = std::min(order, static_cast<float>(at));
    if (q < 0.7) cover(x, y, stroke.crosses);
  });
}

Image TileLevel::thresholds() const {
  // What is left white is filled from the strokes outwards, ring by ring.
  std::vector<float> order = order_;
  float last = 1.0F + static_cast<float>(kind_->swelling + kind_->grain);
  while (std::ranges::find(order, kNever) != order.end()) {
    std::vector<float> next = order;
    bool any = false;
    last += 1.0F;
    for (int y = 0; y < size_; ++y) {
      for (int x = 0; x < size_; ++x) {
        const auto texel = static_cast<std::size_t>(y * size_ + x);
        if (order[texel] != kNever) continue;
        for (const auto& [i, j] :
             {std::pair(x - 1, y), std::pair(x + 1, y), std::pair(x, y - 1), std::pair(x, y + 1)}) {
          const auto beside = static_cast<std::size_t>(wrapped(j, size_) * size_ + wrapped(i, size_));
          if (order[beside] == kNever) continue;
          next[texel] = last + static_cast<float>(0.9 * unit_hash(texel, 3));
          any = true;
        }
      }
    }
    if (!any) break;  // no stroke at all
    order = std::move(next);
  }
  std::vector<std::uint32_t> by_order(order.size());
  std::iota(by_order.begin(), by_order.end(), 0U);
  std::ranges::stable_sort(by_order, [&order](std::uint32_t a, std::uint32_t b) { return order[a] < order[b]; });
  Image image(size_, size_, 1);
  for (std::size_t rank = 0; rank < by_order.size(); ++rank) {
    image.data[by_order[rank]] = static_cast<float>(rank + 1) / static_cast<float>(by_order.size());
  }
  return image;
}

}  // namespace luminist
