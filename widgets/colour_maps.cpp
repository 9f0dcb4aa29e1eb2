// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/colour_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace stratascope {
namespace {

// Viridis at steps of 1/8; between them straight lines differ from the full table by less than two grey
// levels.
constexpr std::array<Rgb, 9> kViridis{{{68, 1, 84},
                                       {71, 44, 122},
                                       {59, 81, 139},
                                       {44, 113, 142},
                                       {33, 144, 141},
                                       {39, 173, 129},
                                       {92, 200, 99},
                                       {170, 220, 50},
                                       {253, 231, 37}}};

// Cividis at steps of 1/9.
constexpr std::array<Rgb, 10> kCividis{{{0, 34, 78},
                                        {18, 53, 112},
                                        {59, 73, 108},
                                        {87, 93, 109},
                                        {112, 113, 115},
                                        {138, 134, 120},
                                        {165, 156, 116},
                                        {195, 179, 105},
                                        {225, 204, 85},
                                        {254, 232, 56}}};

std::uint8_t byte(double v) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0, 255.0)));
}

}  // namespace

Rgb classColour(SurfaceClass c) {
  switch (c) {
    case SurfaceClass::Facing:
      return {222, 66, 62};
    case SurfaceClass::Side:
      return {56, 160, 82};
    case SurfaceClass::Horizontal:
      return {56, 116, 214};
    case SurfaceClass::Oblique:
      return {222, 170, 36};
    case SurfaceClass::ConvexEdge:
      return {240, 128, 60};
    case SurfaceClass::ConcaveEdge:
      return {148, 92, 206};
    case SurfaceClass::JumpEdge:
      return {40, 178, 190};
    case SurfaceClass::Unknown:
      break;
  }
  return {150, 156, 164};
}

const char* className(SurfaceClass c) {
  switch (c) {
    case SurfaceClass::Facing:
      return "Facing";
    case SurfaceClass::Side:
      return "Side";
    case SurfaceClass::Horizontal:
      return "Horizontal";
    case SurfaceClass::Oblique:
      return "Oblique";
    case SurfaceClass::ConvexEdge:
      return "Convex edge";
    case SurfaceClass::ConcaveEdge:
      return "Concave edge";
    case SurfaceClass::JumpEdge:
      return "Jump edge";
    case SurfaceClass::Unknown:
      break;
  }
  return "Unknown";
}

Rgb planeColour(std::uint32_t number) {
  if (number == 0) return kNoValue;
  // Steps of the golden ratio around the hue circle keep neighbouring numbers apart; lightness tells later
  // rounds apart.
  const double hue = std::fmod(number * 0.6180339887498949, 1.0) * 6.0;
  const double chroma = 0.58 + 0.2 * (number / 2 % 2);
  const double value = 0.92 - 0.16 * (number % 3 / 2.0);
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hue, 6.0);
    return byte(255 * (value - value * chroma * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0)));
  };
  return {channel(5), channel(3), channel(1)};
}

Rgb mapColour(ColourMap map, double t) {
  const std::span<const Rgb> table = map == ColourMap::Viridis ? std::span<const Rgb>(kViridis) : kCividis;
  const double s = std::clamp(std::isnan(t) ? 0.0 : t, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(s), table.size() - 2);
  const double f = s - static_cast<double>(i);
  const Rgb a = table[i], b = table[i + 1];
  return {byte(a.r + f * (b.r - a.r)), byte(a.g + f * (b.g - a.g)), byte(a.b + f * (b.b - a.b))};
}

Rgb dimmed(Rgb colour) {
  const auto mix = [](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>((2 * from + 3 * to) / 5);
  };
  return {mix(colour.r, kNoValue.r), mix(colour.g, kNoValue.g), mix(colour.b, kNoValue.b)};
}

Rgb shaded(Rgb c, float factor) {
  return {byte(c.r * factor), byte(c.g * factor), byte(c.b * factor)};
}

}  // namespace stratascope
