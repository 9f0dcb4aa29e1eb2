// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/open_stream.h"

#include <algorithm>

#include "io/scan_io.h"
#include "stream/replay.h"

namespace stratascope {
namespace {
constexpr std::string_view kReplay = "replay:";
}

bool isScene(const std::string& file) {
  return file.ends_with(".json");
}

Expected<ScanSupply> openSupply(const PlayRequest& request) {
  if (!isScene(request.file)) {
    auto scan = readScan(request.file);
    if (!scan) return scan.error();
    if (scan->unordered() || !scan->lattice)
      return Error{request.file, "", "has no lattice, so it cannot be played line by line",
                   "open it as a file"};
    return supplyOf(std::make_shared<const Scan>(*std::move(scan)), request.rounds);
  }
  auto scene = loadScene(request.file);
  if (!scene) return scene.error();
  if (request.head != HeadMode::AsTheScene) scene->scanner.continuousHead = request.head == HeadMode::Turns;
  SimulatedScans simulated{.simulation = request.simulation, .rounds = request.rounds};
  if (!request.moving.empty()) {
    const auto item = std::ranges::find(scene->items, request.moving, &Scene::Item::name);
    if (item == scene->items.end())
      return Error{request.file, "", "has no item named \"" + request.moving + "\"", "name one of its items"};
    simulated.movingItem = static_cast<int>(item - scene->items.begin());
  }
  return supplyOf(*std::move(scene), simulated);
}

bool looksLikeStreamAddress(const std::string& text) {
  return looksLikeDeviceAddress(text) || text.starts_with(kReplay);
}

std::string playedFile(const std::string& address) {
  if (looksLikeDeviceAddress(address)) return {};
  return address.starts_with(kReplay) ? address.substr(kReplay.size()) : address;
}

Expected<std::unique_ptr<RowSource>> openStream(const StreamRequest& request) {
  if (looksLikeDeviceAddress(request.address)) {
    const auto address = streamAddressFromText(request.address);
    if (!address) return address.error();
    return makeDeviceSource(*address, request.telegrams);
  }
  PlayRequest play = request.play;
  play.file = playedFile(request.address);
  if (play.file.empty()) return Error{request.address, "", "names no file", "write replay:FILE"};
  auto scans = openSupply(play);
  if (!scans) return scans.error();
  return makeReplay(*std::move(scans), {.speed = request.speed, .paused = request.paused});
}

}  // namespace stratascope
