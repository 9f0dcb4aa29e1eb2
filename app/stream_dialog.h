// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

#include "stream/open_stream.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace stratascope {

/// File → Open stream: where lines come from and what has to be known of it. The fields of the chosen kind
/// write the address the command line takes; an address that is typed fills the fields.
class StreamDialog : public QDialog {
  Q_OBJECT
public:
  enum class Kind { Replay, Scene, Tcp, Serial };
  enum class Remember { Last, Nothing };
  /// `folder`: where the file dialogs begin.
  StreamDialog(const QString& folder, Remember remember, QWidget* parent = nullptr);

  StreamRequest request() const;
  void setRequest(const StreamRequest& request);
  /// In which kind a request is shown.
  static Kind kindOf(const std::string& address);

public slots:
  void accept() override;

private:
  void buildPlayed();
  void buildDevices();
  Kind kind() const;
  void setKind(Kind kind);
  void chooseFile();
  void showKind();
  void fillMoving();
  void writeAddress();
  void readAddress();
  void check();

  QString folder_;
  Remember remember_;
  QComboBox* kind_;
  QLineEdit* address_;
  QLabel* problem_;
  QDialogButtonBox* buttons_;

  QGroupBox *fileBox_, *sceneBox_, *tcpBox_, *serialBox_, *headBox_;
  QLineEdit* file_;
  QLabel *fileLabel_, *giveUpLabel_;
  QComboBox* speed_;
  QCheckBox *loop_, *paused_;
  QComboBox *head_, *noise_, *moving_;
  QSpinBox* seed_;
  QLineEdit* host_;
  QSpinBox* port_;
  QComboBox *device_, *baud_;
  QDoubleSpinBox *headStart_, *headStep_;
  QCheckBox* headTurns_;
  QSpinBox* lines_;
  QComboBox* rangeBits_;
  QDoubleSpinBox* giveUp_;
};

}  // namespace stratascope
