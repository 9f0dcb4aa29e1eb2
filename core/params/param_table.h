// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "params/pipeline_params.h"

namespace stratascope {

enum class ParamKind { Real, Integer, Choice, Flag };

/// One parameter as people meet it: the single source of the panel, the command line, preset files, tooltips
/// and help.
struct ParamInfo {
  const char* key;    ///< "epsilon1": the option without dashes, with '_' for '-' ("plane_distance") in files
  const char* label;  ///< "Outer radius"
  const char* symbol;  ///< the paper's symbol, "ε1", or ""
  const char* unit;    ///< "m", "°", "" — the unit people read and files carry
  ParamKind kind;
  double minimum, maximum, step;     ///< for Real and Integer: what validate() accepts, and a slider's step
  std::vector<const char*> choices;  ///< for Choice: the words, in the enum's order
  const char* text;                  ///< one sentence: what raising it (or choosing) does
  const char*
      stage;   ///< first stage it acts on: "range", "normals", "classes", "planes", "height_map", "intervals"
  bool basic;  ///< shown above the fold
  double (*get)(const PipelineParams&);        ///< number, index of the choice, or 0/1
  void (*set)(PipelineParams&, double value);  ///< unchecked; validate() afterwards
};

std::span<const ParamInfo> paramTable();
/// nullptr if there is none. '-' and '_' are the same in keys.
const ParamInfo* findParam(std::string_view key);
/// The valid key nearest in spelling, for error messages.
const char* nearestParamKey(std::string_view key);

/// A number in the C locale, shortest form that reads back to the same double.
std::string paramNumberText(double value);
/// Value as text in the C locale, shortest form that reads back to the same number; the word of a choice;
/// true/false.
std::string paramText(const ParamInfo& info, const PipelineParams& params);
/// Reads what paramText writes. The error names key and text, not a file.
Status setParam(PipelineParams& params, std::string_view key, std::string_view text);

/// {"epsilon": 0.1, …}: every parameter, in the order of the table.
std::string paramsToJson(const PipelineParams& params);
/// Starts from `base`; unknown keys, wrong types and values that do not validate are errors that name key and
/// remedy.
Expected<PipelineParams> paramsFromJson(std::string_view json, const std::string& file,
                                        const PipelineParams& base = {});
Expected<PipelineParams> loadParams(const std::string& path, const PipelineParams& base = {});

/// The command-line options that reproduce `params`: only those that differ from the defaults.
std::string paramsAsOptions(const PipelineParams& params);

}  // namespace stratascope
