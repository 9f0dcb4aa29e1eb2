// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/param_history.h"

#include <QUndoCommand>

#include "widgets/text_format.h"

namespace stratascope {
namespace {

class ParamCommand : public QUndoCommand {
public:
  ParamCommand(ParamEdit edit, std::function<void(const PipelineParams&)> apply)
      : QUndoCommand(edit.text), edit_(std::move(edit)), apply_(std::move(apply)) {}
  void undo() override { apply_(edit_.before); }
  void redo() override { apply_(edit_.after); }
  int id() const override { return edit_.key.isEmpty() ? -1 : 1; }
  bool mergeWith(const QUndoCommand* next) override {
    const ParamEdit& other = static_cast<const ParamCommand*>(next)->edit_;
    if (other.key != edit_.key || other.gesture != edit_.gesture) return false;
    edit_.after = other.after;
    const ParamInfo& info = *findParam(edit_.key.toStdString());
    setText(QObject::tr("%1 %2 → %3")
                .arg(tableText(info.label), paramValueText(info, info.get(edit_.before)),
                     paramValueText(info, info.get(edit_.after))));
    setObsolete(edit_.after == edit_.before);
    return true;
  }

private:
  ParamEdit edit_;
  std::function<void(const PipelineParams&)> apply_;
};

}  // namespace

ParamHistory::ParamHistory(std::function<void(const PipelineParams&)> apply, QObject* parent)
    : QUndoStack(parent), apply_(std::move(apply)) {}

void ParamHistory::add(const ParamEdit& edit) {
  push(new ParamCommand(edit, apply_));
}

}  // namespace stratascope
