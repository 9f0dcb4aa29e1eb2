// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/text_labels.h"

#include <vtkTextProperty.h>

#include <QFontInfo>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <cmath>

namespace stratascope {
namespace {

constexpr int kFontSize = 12;  // the render window knows the screen's resolution

std::shared_ptr<const PaintedWord> wordOf(const QString& text, bool bold, double pixelRatio) {
  QFont font = QGuiApplication::font();
  font.setPixelSize(static_cast<int>(std::lround(QFontInfo(font).pixelSize() * pixelRatio)));
  font.setBold(bold);
  const QFontMetrics metrics(font);
  QImage image(metrics.horizontalAdvance(text) + 2, metrics.height(), QImage::Format_Grayscale8);
  image.fill(Qt::black);
  QPainter painter(&image);
  painter.setFont(font);
  painter.setPen(Qt::white);
  painter.drawText(image.rect(), Qt::AlignCenter, text);
  auto word = std::make_shared<PaintedWord>();
  word->columns = image.width();
  for (int y = 0; y < image.height(); ++y)
    word->coverage.insert(word->coverage.end(), image.constScanLine(y),
                          image.constScanLine(y) + image.width());
  return word;
}

}  // namespace

TextLabels::TextLabels(vtkRenderer* renderer, double pixelRatio, bool painted)
    : renderer_(renderer), pixelRatio_(pixelRatio), painted_(painted) {
  if (!painted_) return;
  prop_->UseBoundsOff();
  renderer_->AddViewProp(prop_);
}

void TextLabels::paint(const std::vector<Label>& labels, bool bold) {
  std::vector<PaintedLabel> painted;
  std::map<std::pair<QString, bool>, std::shared_ptr<const PaintedWord>> words;
  for (const Label& label : labels) {
    auto& word = words[{label.text, bold}];
    if (!word) word = words_[{label.text, bold}];
    if (!word) word = wordOf(label.text, bold, pixelRatio_);
    const auto part = [](int v) { return static_cast<std::uint8_t>(v); };
    painted.push_back({label.at.cast<float>(),
                       {part(label.colour.red()), part(label.colour.green()), part(label.colour.blue())},
                       word});
  }
  words_ = std::move(words);
  prop_->setLabels(std::move(painted));
}

void TextLabels::show(const std::vector<Label>& labels, bool bold) {
  if (painted_) return paint(labels, bold);
  while (actors_.size() < labels.size()) {
    auto actor = vtkSmartPointer<vtkBillboardTextActor3D>::New();
    actor->PickableOff();
    actor->UseBoundsOff();  // they lie beside what is measured anyhow, and VTK lays the text out anew to know
    // One translucent prop costs a pass of its own over the whole picture; of letters only the rim is.
    actor->ForceOpaqueOn();
    actor->GetTextProperty()->SetJustificationToCentered();
    actor->GetTextProperty()->SetVerticalJustificationToCentered();
    renderer_->AddActor(actor);
    actors_.push_back(actor);
  }
  for (size_t i = 0; i < actors_.size(); ++i) {
    vtkBillboardTextActor3D* actor = actors_[i];
    actor->SetVisibility(i < labels.size());
    if (i >= labels.size()) continue;
    const Label& label = labels[i];
    actor->SetInput(label.text.toUtf8().constData());
    Eigen::Vector3d at = label.at;
    actor->SetPosition(at.data());
    vtkTextProperty* text = actor->GetTextProperty();
    text->SetColor(label.colour.redF(), label.colour.greenF(), label.colour.blueF());
    text->SetBold(bold);
    text->SetFontSize(kFontSize);
  }
}

}  // namespace stratascope
