// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/window_state.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <limits>

namespace stratascope {
namespace {

constexpr int kVersion = 1;

template <size_t N>
QJsonArray numbers(const std::array<double, N>& values) {
  QJsonArray array;
  for (const double v : values) array.append(v);
  return array;
}

template <size_t N>
bool readNumbers(const QJsonValue& json, std::array<double, N>& values) {
  const QJsonArray array = json.toArray();
  if (array.size() != static_cast<int>(N)) return false;
  for (int i = 0; i < array.size(); ++i) {
    if (!array[i].isDouble() || !std::isfinite(array[i].toDouble())) return false;
    values[static_cast<size_t>(i)] = array[i].toDouble();
  }
  return true;
}

QJsonObject cameraJson(const CameraState& c) {
  return {{"position", numbers(c.position)}, {"focus", numbers(c.focus)}, {"up", numbers(c.up)},
          {"centre", numbers(c.centre)},     {"angle", c.angleDeg},       {"scale", c.scale},
          {"perspective", c.perspective}};
}

std::optional<CameraState> cameraFrom(const QJsonObject& json) {
  CameraState c;
  c.angleDeg = json["angle"].toDouble();
  c.scale = json["scale"].toDouble();
  c.perspective = json["perspective"].toBool(true);
  if (!readNumbers(json["position"], c.position) || !readNumbers(json["focus"], c.focus) ||
      !readNumbers(json["up"], c.up) || !readNumbers(json["centre"], c.centre))
    return {};
  if (!(c.angleDeg > 0 && c.angleDeg < 180 && c.scale > 0)) return {};
  return c;
}

QJsonValue rangeJson(const std::optional<std::pair<double, double>>& range) {
  return range ? QJsonValue(QJsonArray{range->first, range->second}) : QJsonValue();
}

std::optional<std::pair<double, double>> rangeFrom(const QJsonValue& json) {
  std::array<double, 2> ends{};
  if (!readNumbers(json, ends) || !(ends[0] <= ends[1])) return {};
  return std::pair(ends[0], ends[1]);
}

template <class Choice>
Choice choiceFrom(const QJsonValue& json, int count, Choice otherwise) {
  const int number = json.toInt(-1);
  return number >= 0 && number < count ? static_cast<Choice>(number) : otherwise;
}

/// A cut at infinity, "nothing is cut", has no number in JSON.
const QString kNoCut = QStringLiteral("none");

QJsonObject selectionJson(const Selected& selected) {
  if (const auto* point = std::get_if<PointRef>(&selected))
    return {{"scan", point->scan}, {"point", static_cast<double>(point->offset)}};
  if (const auto* cell = std::get_if<CellIndex>(&selected)) return {{"k", cell->k}, {"l", cell->l}};
  if (const auto* label = std::get_if<PlaneLabel>(&selected)) return {{"plane", static_cast<double>(*label)}};
  return {};
}

void readSelection(const QJsonObject& json, Selected& selected) {
  const auto unsignedOf = [&](const char* key) {
    return static_cast<std::uint32_t>(std::clamp(json[QLatin1String(key)].toDouble(), 0.0, 4294967295.0));
  };
  if (json.contains("point"))
    selected.emplace<PointRef>(PointRef{std::max(0, json["scan"].toInt()), unsignedOf("point")});
  else if (json.contains("k"))
    selected.emplace<CellIndex>(CellIndex{json["k"].toInt(), json["l"].toInt()});
  else if (json.contains("plane"))
    selected.emplace<PlaneLabel>(unsignedOf("plane"));
}

}  // namespace

bool isSessionName(const QString& path) {
  return path.endsWith(QLatin1String(kSessionEnding), Qt::CaseInsensitive);
}

std::string windowJson(const WindowState& state) {
  QJsonObject json{{"window", kVersion}};
  const ViewOptions& o = state.options;
  QJsonObject colours{{"cloud", static_cast<int>(o.colouring)},
                      {"maps", static_cast<int>(o.mapColouring)},
                      {"palette", static_cast<int>(o.colourMap)},
                      {"cloudRange", rangeJson(o.cloudRange)},
                      {"mapRange", rangeJson(o.mapRange)}};
  json["colours"] = colours;
  if (o.cut) json["cut"] = std::isfinite(*o.cut) ? QJsonValue(*o.cut) : QJsonValue(kNoCut);
  if (state.cameras) {
    QJsonArray cameras;
    for (const CameraState& camera : *state.cameras) cameras.append(cameraJson(camera));
    json["cameras"] = cameras;
  }
  QJsonObject marks;
  for (const auto& [name, on] : state.marks) marks[QString::fromStdString(name)] = on;
  json["marks"] = marks;
  json["selection"] = selectionJson(state.selection);
  json["size"] = QJsonArray{state.width, state.height};
  json["docks"] = QString::fromLatin1(state.docks.toBase64());
  QJsonArray splitters;
  for (const QByteArray& splitter : state.splitters)
    splitters.append(QString::fromLatin1(splitter.toBase64()));
  json["splitters"] = splitters;
  json["maximised"] = state.maximised;
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

WindowState windowFromJson(const std::string& text) {
  WindowState state;
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
  const QJsonObject colours = json["colours"].toObject();
  ViewOptions& o = state.options;
  o.colouring = choiceFrom(colours["cloud"], kCloudColourings, o.colouring);
  o.mapColouring = choiceFrom(colours["maps"], kMapColourings, o.mapColouring);
  o.colourMap = choiceFrom(colours["palette"], 2, o.colourMap);
  o.cloudRange = rangeFrom(colours["cloudRange"]);
  o.mapRange = rangeFrom(colours["mapRange"]);
  if (json["cut"].isDouble()) o.cut = json["cut"].toDouble();
  if (json["cut"].toString() == kNoCut) o.cut = std::numeric_limits<double>::infinity();
  const QJsonArray cameras = json["cameras"].toArray();
  if (cameras.size() == 3) {
    std::array<CameraState, 3> found;
    bool whole = true;
    for (int i = 0; i < 3; ++i) {
      const auto camera = cameraFrom(cameras[i].toObject());
      if (camera)
        found[static_cast<size_t>(i)] = *camera;
      else
        whole = false;
    }
    if (whole) state.cameras = found;
  }
  const QJsonObject marks = json["marks"].toObject();
  for (auto mark = marks.begin(); mark != marks.end(); ++mark)
    if (mark.value().isBool()) state.marks[mark.key().toStdString()] = mark.value().toBool();
  readSelection(json["selection"].toObject(), state.selection);
  const QJsonArray size = json["size"].toArray();
  constexpr int kLargest = 16384;
  if (size.size() == 2 && std::min(size[0].toInt(), size[1].toInt()) > 0 &&
      std::max(size[0].toInt(), size[1].toInt()) <= kLargest) {
    state.width = size[0].toInt();
    state.height = size[1].toInt();
  }
  state.docks = QByteArray::fromBase64(json["docks"].toString().toLatin1());
  for (const QJsonValue& splitter : json["splitters"].toArray())
    state.splitters.push_back(QByteArray::fromBase64(splitter.toString().toLatin1()));
  const int maximised = json["maximised"].toInt(-1);
  state.maximised = maximised >= 0 && maximised < 3 ? maximised : -1;
  return state;
}

}  // namespace stratascope
