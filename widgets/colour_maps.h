// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "base/ids.h"

namespace stratascope {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

/// The paper's colours: red facing, green side, blue horizontal; the others told apart from them and from each other.
Rgb classColour(SurfaceClass c);
const char* className(SurfaceClass c);

/// A colour of its own for each plane, the same for the same label; grey for kNoPlane.
Rgb planeColour(PlaneLabel label);

/// Viridis: even steps to the eye, readable without colour vision. t is clamped to [0, 1].
Rgb heightColour(double t);

/// Magenta: in neither viridis nor the class colours.
inline constexpr Rgb kHighlight{255, 45, 160};

Rgb shaded(Rgb colour, float factor);

/// The heights the colours of both maps and of their scalar bars span, metres.
struct HeightScale {
  double low = 0;
  double high = 1;
  double fraction(double z) const { return high > low ? (z - low) / (high - low) : 0.5; }
  bool operator==(const HeightScale&) const = default;
};

}  // namespace stratascope
