// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stratascope::test {

struct HostileFile {
  std::string name;
  std::string bytes;
};

/// Every file must be refused by readScanBytes with one line that names it, without a large allocation.
void expectAllRefused(const std::string& extension, const std::vector<HostileFile>& files);

/// Reads many damaged copies of a valid file (bytes changed, cut out, doubled). Each must give an error or a
/// scan that is whole in itself. Returns how many were refused.
int readDamagedCopies(const std::string& extension, const std::string& valid, int copies, std::uint32_t seed);

/// The file cut after n bytes, for every n: call(n, the n bytes).
template <class Call>
void forEveryPrefix(const std::string& bytes, Call call) {
  for (size_t n = 0; n < bytes.size(); ++n) call(n, bytes.substr(0, n));
}

/// `text` with the first `from` replaced; throws if it is not there.
std::string replaced(std::string text, std::string_view from, std::string_view to);

}  // namespace stratascope::test
