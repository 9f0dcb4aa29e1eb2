// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/colour_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stratascope {
namespace {

// Viridis at steps of 1/8; between them straight lines differ from the full table by less than two grey levels.
constexpr std::array<Rgb, 9> kViridis{{{68, 1, 84},
                                       {71, 44, 122},
                                       {59, 81, 139},
                                       {44, 113, 142},
                                       {33, 144, 141},
                                       {39, 173, 129},
                                       {92, 200, 99},
                                       {170, 220, 50},
                                       {253, 231, 37}}};

std::uint8_t byte(double v) { return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0, 255.0))); }

}  // namespace

Rgb classColour(SurfaceClass c) {
  switch (c) {
    case SurfaceClass::Facing: return {222, 66, 62};
    case SurfaceClass::Side: return {56, 160, 82};
    case SurfaceClass::Horizontal: return {56, 116, 214};
    case SurfaceClass::Oblique: return {222, 170, 36};
    case SurfaceClass::ConvexEdge: return {240, 128, 60};
    case SurfaceClass::ConcaveEdge: return {148, 92, 206};
    case SurfaceClass::JumpEdge: return {40, 178, 190};
    case SurfaceClass::Unknown: break;
  }
  return {150, 156, 164};
}

const char* className(SurfaceClass c) {
  switch (c) {
    case SurfaceClass::Facing: return "Facing";
    case SurfaceClass::Side: return "Side";
    case SurfaceClass::Horizontal: return "Horizontal";
    case SurfaceClass::Oblique: return "Oblique";
    case SurfaceClass::ConvexEdge: return "Convex edge";
    case SurfaceClass::ConcaveEdge: return "Concave edge";
    case SurfaceClass::JumpEdge: return "Jump edge";
    case SurfaceClass::Unknown: break;
  }
  return "Unknown";
}

Rgb planeColour(PlaneLabel label) {
  if (label == kNoPlane) return {150, 156, 164};
  // Steps of the golden ratio around the hue circle keep neighbouring labels apart; the hash breaks up regular ones.
  const std::uint32_t hash = label * 2654435761u;
  const double hue = std::fmod((hash >> 8) * 0.6180339887498949, 1.0) * 6.0;
  const double chroma = 0.58 + 0.2 * ((hash >> 3) & 1u);
  const double value = 0.78 + 0.14 * ((hash >> 5) & 1u);
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hue, 6.0);
    return byte(255 * (value - value * chroma * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0)));
  };
  return {channel(5), channel(3), channel(1)};
}

Rgb heightColour(double t) {
  const double s = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * (kViridis.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(s), kViridis.size() - 2);
  const double f = s - static_cast<double>(i);
  const Rgb a = kViridis[i], b = kViridis[i + 1];
  return {byte(a.r + f * (b.r - a.r)), byte(a.g + f * (b.g - a.g)), byte(a.b + f * (b.b - a.b))};
}

Rgb shaded(Rgb c, float factor) { return {byte(c.r * factor), byte(c.g * factor), byte(c.b * factor)}; }

}  // namespace stratascope
