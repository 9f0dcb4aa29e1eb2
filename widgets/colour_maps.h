// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

#include "base/ids.h"

namespace stratascope {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

/// The paper's colours: red facing, green side, blue horizontal; the others told apart from them and from
/// each other.
Rgb classColour(SurfaceClass c);
const char* className(SurfaceClass c);

/// A colour of its own for each plane by its number, which stays with it; grey for 0.
Rgb planeColour(std::uint32_t number);

/// Even steps to the eye, readable without colour vision.
enum class ColourMap { Viridis, Cividis };
/// t is clamped to [0, 1].
Rgb mapColour(ColourMap map, double t);
inline Rgb heightColour(double t) {
  return mapColour(ColourMap::Viridis, t);
}

/// Where there is no value to be coloured.
inline constexpr Rgb kNoValue{150, 156, 164};

/// Magenta: in neither viridis nor the class colours.
inline constexpr Rgb kHighlight{255, 45, 160};

/// Neighbours of a selected point: inside the shell, nearer, farther.
inline constexpr Rgb kTakenColour{30, 200, 120}, kNearColour{255, 150, 30}, kFarColour{120, 140, 190};

Rgb shaded(Rgb colour, float factor);
/// What may still change: more than half grey, so that it stands back on light and dark ground.
Rgb dimmed(Rgb colour);

/// The numbers a scalar bar spans.
struct ColourScale {
  double low = 0;
  double high = 1;
  ColourMap map = ColourMap::Viridis;
  double fraction(double v) const { return high > low ? (v - low) / (high - low) : 0.5; }
  Rgb colour(double v) const { return std::isnan(v) ? kNoValue : mapColour(map, fraction(v)); }
  bool operator==(const ColourScale&) const = default;
};

}  // namespace stratascope
