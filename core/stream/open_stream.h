// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stream/scan_supply.h"
#include "stream/telegram_source.h"

namespace stratascope {

/// How the head of a simulated scanner moves.
enum class HeadMode : std::uint8_t { AsTheScene, Steps, Turns };

/// A scan file, or a scene (.json) that is scanned as it is played.
struct PlayRequest {
  std::string file;
  Rounds rounds = Rounds::Once;
  // of scenes alone
  SimulationOptions simulation{};
  HeadMode head = HeadMode::AsTheScene;
  std::string moving{};  ///< name of the item that walks to and fro; empty = none
};
bool isScene(const std::string& file);
/// Errors: the file; no item of that name.
Expected<ScanSupply> openSupply(const PlayRequest& request);

/// A stream as people ask for it, on the command line or in the window. What its kind does not know is
/// ignored.
struct StreamRequest {
  /// tcp://HOST:PORT, serial:DEVICE?baud=N, replay:FILE, or just the file.
  std::string address;
  PlayRequest play{};  ///< but its file, which the address names
  double speed = 1;    ///< of a replay; see Transport::setSpeed
  bool paused = false;
  TelegramSourceOptions telegrams{};
};
/// tcp://, serial: and replay: do; a file's name does not.
bool looksLikeStreamAddress(const std::string& text);
/// The file that is played; empty for a device.
std::string playedFile(const std::string& address);
/// Reads the file, if it is one: may take its time. Errors: the address, the file.
Expected<std::unique_ptr<RowSource>> openStream(const StreamRequest& request);

}  // namespace stratascope
