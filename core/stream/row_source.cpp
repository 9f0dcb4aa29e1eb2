// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/row_source.h"

#include <nlohmann/json.hpp>

namespace stratascope {

const char* streamStateName(StreamState state) {
  switch (state) {
    case StreamState::Connecting:
      return "connecting";
    case StreamState::Receiving:
      return "receiving";
    case StreamState::Paused:
      return "paused";
    case StreamState::Ended:
      return "ended";
    case StreamState::Failed:
      return "failed";
  }
  return "";
}

std::string countersJson(const StreamCounters& c) {
  const nlohmann::ordered_json json = {{"received", c.received},
                                       {"missing", c.missing},
                                       {"duplicated", c.duplicated},
                                       {"out_of_order", c.outOfOrder},
                                       {"dropped", c.dropped},
                                       {"orphaned", c.orphaned},
                                       {"scans", c.scans},
                                       {"bytes", c.bytes},
                                       {"telegrams", c.telegrams},
                                       {"bad_crc", c.badCrc},
                                       {"resynchronised", c.resynchronised},
                                       {"skipped_bytes", c.skippedBytes},
                                       {"naks", c.naks},
                                       {"power_ons", c.powerOns},
                                       {"device_errors", c.deviceErrors},
                                       {"connections", c.connections}};
  return json.dump();
}

}  // namespace stratascope
