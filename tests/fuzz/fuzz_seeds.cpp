// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// fuzz_seeds DIR: writes the small valid files each fuzzing program starts from, DIR/FORMAT/N.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "io/e57_pages.h"
#include "support/hostile_lists.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds DIR\n";
    return 2;
  }
  namespace fs = std::filesystem;
  for (const auto& format : stratascope::test::formatsUnderAttack()) {
    const fs::path folder =
        fs::path(argv[1]) / (format.name == "scan graph" ? "graph" : format.extension.substr(1));
    fs::create_directories(folder);
    for (size_t i = 0; i < format.valid.size(); ++i) {
      std::string bytes = format.valid[i];
      if (format.extension == ".e57") {  // the fuzzing program adds the pages' checksums itself
        bytes = stratascope::openE57Pages("seed", bytes)->bytes;
        bytes.resize(bytes.find_last_of('>') + 1);
      }
      std::ofstream(folder / std::to_string(i), std::ios::binary) << bytes;
    }
  }
  return 0;
}
