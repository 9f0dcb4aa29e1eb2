// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace stratascope {

/// Where the content of a file came from: one line each for the program with its version, every input with
/// its SHA-256, and all parameters. Printable ASCII; what is not (in names) is escaped as JSON escapes it.
using Provenance = std::vector<std::string>;

/// From the document runJson() or mapDocument() made; with `input`, only that one of its inputs.
Provenance provenanceOf(const std::string& document);
Provenance provenanceOf(const std::string& document, size_t input);

/// All lines with `before` in front of each and a line end behind: comments of a text format. Control
/// characters become '?'.
std::string commentLines(const Provenance& provenance, const std::string& before);

}  // namespace stratascope
