// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace stratascope {

/// LZF stream, as PCD's binary_compressed holds it:
///   000LLLLL, then L+1 bytes                    those bytes as they are, 1…32
///   LLLddddd dddddddd              (L = 1…6)    L+2 bytes again, from d+1 bytes back
///   111ddddd LLLLLLLL dddddddd                  L+9 bytes again, from d+1 bytes back
/// Always a valid stream: bytes that do not repeat grow by 1 in 32.
std::string lzfCompress(std::string_view bytes);

}  // namespace stratascope
